// Numbers and tables as people read them.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text.h"

namespace gridscope {

std::string grouped(uint64_t number);                              // "1,234,567"
std::string percentOf(uint64_t part, uint64_t whole);              // "12.3 %"; "0 %" of nothing
std::string byteText(uint64_t bytes);                              // "512 bytes", "2.0 GiB"
std::string shellText(const std::vector<std::string>& arguments);  // quoted where a shell needs it
std::string viewLabel(std::string_view name);                      // "hit-kind" as "Hit kind"
std::string joined(const std::vector<std::string>& parts, std::string_view separator);

// Rows of cells in aligned columns.
class Table {
 public:
  // A letter a column: l aligned to the left, r to the right.
  explicit Table(std::string alignment) : alignment_(std::move(alignment)) {}
  void add(std::vector<std::string> row);
  void print(std::FILE* out) const;
  const std::vector<std::vector<std::string>>& rows() const { return rows_; }

 private:
  std::string alignment_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace gridscope
