// See attempt.h.
#include "core/tune/attempt.h"

#include <new>
#include <string_view>

#include "core/base/error.h"

namespace gridscope {

namespace {

enum class Outcome { measured, refused, lost };

Outcome measured(TuneRow& row, const std::function<void(TuneRow&)>& measure) {
  try {
    measure(row);
    return Outcome::measured;
  } catch (const Error& error) {
    row.refusal = error.what();
  } catch (const std::bad_alloc&) {
    row.refusal = "not enough memory";
  }
  return std::string_view(row.refusal).find("DEVICE_LOST") == std::string_view::npos ? Outcome::refused : Outcome::lost;
}

}  // namespace

bool tryRow(TuneRow& row, const std::function<void(TuneRow&)>& measure, const std::function<bool()>& freeMemory) {
  const TuneRow fresh = row;
  Outcome outcome = measured(row, measure);
  if (outcome == Outcome::refused && freeMemory()) {
    row = fresh;
    outcome = measured(row, measure);
  }
  return outcome != Outcome::lost;
}

}  // namespace gridscope
