// One setting of a sweep being tried: what goes wrong with it is that row's alone, as long as the device lives.
#pragma once

#include <functional>

#include "core/tune/tune.h"

namespace gridscope {

// Runs `measure`, which fills the row; its fault becomes the row's refusal. Before that `freeMemory` may let go of what is kept beside: where
// it did (true), the row is measured once more from the start. Returns false when the device is lost, with the refusal saying so.
bool tryRow(TuneRow& row, const std::function<void(TuneRow&)>& measure, const std::function<bool()>& freeMemory);

}  // namespace gridscope
