// What a sweep found, for people (text), for programs (JSON) and for spreadsheets (CSV).
#pragma once

#include <cstdio>
#include <string>

#include <nlohmann/json.hpp>

#include "core/tune/tune.h"

namespace gridscope {

// The frame's own setting, the recommended one and the best, then the front, then what could not be tried.
void printTune(std::FILE* out, const TuneResult& result);

// "sweep", "own", "recommended" (with its flags), and "settings": all of them, in the order tried.
nlohmann::ordered_json tuneJson(const TuneResult& result);

// A header, and a line a setting (RFC 4180). Empty figures: it could not be tried.
std::string tuneCsv(const TuneResult& result);

}  // namespace gridscope
