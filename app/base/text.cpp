// See text.h.
#include "app/base/text.h"

#include <algorithm>
#include <cctype>

#include "core/base/error.h"

namespace gridscope {

std::string grouped(uint64_t number) {
  std::string text = std::to_string(number);
  for (size_t place = text.size(); place > 3; place -= 3) text.insert(place - 3, ",");
  return text;
}

std::string percentOf(uint64_t part, uint64_t whole) {
  if (part == 0) return "0 %";
  return printed("%.3g %%", 100.0 * double(part) / double(whole));
}

std::string byteText(uint64_t bytes) {
  if (bytes < 1024) return std::to_string(bytes) + " bytes";
  static constexpr const char* kUnits[] = {"KiB", "MiB", "GiB", "TiB"};
  double value = double(bytes) / 1024.0;
  size_t unit = 0;
  for (; value >= 1024.0 && unit + 1 < std::size(kUnits); ++unit) value /= 1024.0;
  return printed("%.1f %s", value, kUnits[unit]);
}

std::string viewLabel(std::string_view name) {
  std::string label(name);
  std::ranges::replace(label, '-', ' ');
  if (!label.empty()) label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  return label;
}

std::string joined(const std::vector<std::string>& parts, std::string_view separator) {
  std::string text;
  for (const std::string& part : parts) text.append(text.empty() ? "" : separator).append(part);
  return text;
}

std::string shellText(const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) {
    const bool plain = !argument.empty() && std::ranges::all_of(argument, [](char c) {
      return std::isalnum(uint8_t(c)) || std::string_view("-_./,:=+@%").find(c) != std::string_view::npos;
    });
    std::string quoted;
    for (char c : argument) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += (text.empty() ? "" : " ") + (plain ? argument : "'" + quoted + "'");
  }
  return text;
}

// Letters of a UTF-8 text: bytes that do not continue one.
static size_t letterCount(const std::string& text) {
  return static_cast<size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

void Table::add(std::vector<std::string> row) {
  CHECK_LE(row.size(), alignment_.size());
  rows_.push_back(std::move(row));
}

void Table::print(std::FILE* out) const {
  std::vector<size_t> widths(alignment_.size(), 0);
  for (const auto& row : rows_)
    for (size_t column = 0; column < row.size(); ++column) widths[column] = std::max(widths[column], letterCount(row[column]));

  for (const auto& row : rows_) {
    std::string line;
    for (size_t column = 0; column < row.size(); ++column) {
      const std::string blanks(widths[column] - letterCount(row[column]), ' ');
      line += column == 0 ? "" : "  ";
      line += alignment_[column] == 'r' ? blanks + row[column] : row[column] + blanks;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    std::fprintf(out, "%s\n", line.c_str());
  }
}

}  // namespace gridscope
