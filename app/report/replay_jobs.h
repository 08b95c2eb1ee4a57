// Replays of many files: here, one after the other, or spread over processes of this program.
#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/base/progress.h"
#include "app/session/options.h"

namespace gridscope {

// What is said of one file, ready for --json: file, verdict, reason, device, from, seconds, products, pictures.
using ReplayReport = nlohmann::ordered_json;

// In this process.
std::vector<ReplayReport> replayFiles(const std::vector<std::filesystem::path>& files, const Options& options, Progress& progress);

// In `jobs` processes. Files of a process that dies are unsupported.
std::vector<ReplayReport> replayInProcesses(const std::vector<std::filesystem::path>& files, const Options& options, Progress& progress);

}  // namespace gridscope
