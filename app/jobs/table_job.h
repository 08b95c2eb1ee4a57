// A table worked out beside the window, on a thread of its own: the window shows the last finished one meanwhile and never waits.
#pragma once

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/frame/table_rows.h"

namespace gridscope {

// Everything that a table's rows depend on.
struct TableWish {
  TableKind kind = TableKind::cells;
  std::shared_ptr<const FrameSnapshot> frame;
  std::optional<PixelArea> area;
  std::string search;
  SheetOrder order;
};

// A finished table.
struct TableResult {
  TableWish wish;
  std::shared_ptr<const Sheet> sheet;
  SheetRows shown;
  uint64_t number = 0;  // rises with every result
};

class TableJob {
 public:
  // Takes over what is finished, and begins again when the wish differs from it. A few comparisons when nothing changed.
  void want(const TableWish& wish);

  // The last finished table; null before the first.
  const std::shared_ptr<const TableResult>& result() const { return result_; }

  // The result does not yet answer the last wish.
  bool running() const { return work_.valid(); }

  // Waits for the work that is running, if any: for tests.
  void finish();

 private:
  void take();

  std::shared_ptr<const TableResult> result_;
  std::future<std::shared_ptr<const TableResult>> work_;
};

// The table of a wish, numbered behind `last` (may be null), whose sheet serves again where it is made of the same pieces.
std::shared_ptr<const TableResult> makeTable(const TableWish& wish, const TableResult* last);

}  // namespace gridscope
