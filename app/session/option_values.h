// Values of options, from text. Every function throws Error: one line with the option, what was given and what to give instead.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gridscope {

// Both ends included; by default every number of 32 bits.
struct WholeRange {
  uint32_t low = 0;
  uint32_t high = 0xFFFFFFFFu;
};

// Both ends included.
struct NumberRange {
  double low;
  double high;
};

uint32_t parseWhole(const std::string& option, const std::string& text, WholeRange range);
double parseNumber(const std::string& option, const std::string& text, NumberRange range);

// Finite numbers with a comma between them, as many as one of `counts` says. `shape` is what to give, "minx,miny" say.
std::vector<double> parseNumbers(const std::string& option, const std::string& text, const std::vector<size_t>& counts, const char* shape);

// Does the text begin as a number does: with a digit, a sign or a point?
bool looksLikeNumber(const std::string& text);

std::vector<std::string> splitText(const std::string& text, char separator);

}  // namespace gridscope
