// See table_job.h.
#include "app/jobs/table_job.h"

#include <chrono>

#include "app/base/low_priority.h"

namespace gridscope {

static bool sameArea(const std::optional<PixelArea>& a, const std::optional<PixelArea>& b) {
  if (!a || !b) return !a && !b;
  return a->begin == b->begin && a->end == b->end;
}

// Made of the same pieces?
static bool sameSheet(const TableWish& a, const TableWish& b) {
  if (a.kind != b.kind || !a.frame || !b.frame || !sameArea(a.area, b.area)) return false;
  return a.frame == b.frame || sheetSources(a.kind, *a.frame) == sheetSources(b.kind, *b.frame);
}

static bool sameRows(const TableWish& a, const TableWish& b) { return sameSheet(a, b) && a.search == b.search && a.order == b.order; }

std::shared_ptr<const TableResult> makeTable(const TableWish& wish, const TableResult* last) {
  auto result = std::make_shared<TableResult>();
  result->wish = wish;
  result->number = last ? last->number + 1 : 1;
  const bool sheetServes = last && last->sheet && sameSheet(last->wish, wish);
  result->sheet = sheetServes ? last->sheet : std::make_shared<const Sheet>(makeSheet(wish.kind, *wish.frame, wish.area));
  result->shown = sheetRows(*result->sheet, wish.order, wish.search);
  return result;
}

void TableJob::take() {
  if (!work_.valid() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  result_ = work_.get();
}

void TableJob::finish() {
  if (!work_.valid()) return;
  work_.wait();
  take();
}

void TableJob::want(const TableWish& wish) {
  take();
  if (work_.valid() || !wish.frame) return;
  if (result_ && sameRows(result_->wish, wish)) return;
  work_ = std::async(std::launch::async, [wish, last = result_] {
    lowerThreadPriority();
    return makeTable(wish, last.get());
  });
}

}  // namespace gridscope
