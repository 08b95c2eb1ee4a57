// Differences of two captures as text and as JSON.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/capture/diff.h"

namespace gridscope {

// A line a difference; nothing for equal captures.
std::vector<std::string> differenceLines(const CaptureDifferences& differences);
nlohmann::ordered_json differencesJson(const CaptureDifferences& differences);

}  // namespace gridscope
