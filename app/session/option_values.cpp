// See option_values.h.
#include "app/session/option_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/base/text.h"
#include "core/base/error.h"

namespace gridscope {

// The whole text as a number; nothing when it is something else, or has something behind it.
template <class Number>
static std::optional<Number> numberOf(const std::string& text) {
  Number number{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

static std::optional<double> finiteNumberOf(const std::string& text) {
  const std::optional<double> number = numberOf<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

uint32_t parseWhole(const std::string& option, const std::string& text, WholeRange range) {
  const std::optional<uint64_t> number = numberOf<uint64_t>(text);
  if (number && *number >= range.low && *number <= range.high) return static_cast<uint32_t>(*number);
  const std::string end = range.high == WholeRange{}.high ? " or more" : " to " + std::to_string(range.high);
  throw Error(option + " " + text + ": give a whole number, " + std::to_string(range.low) + end);
}

double parseNumber(const std::string& option, const std::string& text, NumberRange range) {
  const std::optional<double> number = finiteNumberOf(text);
  if (!number || *number < range.low || *number > range.high)
    throw Error(option + " " + text + ": give a number from " + printed("%g to %g", range.low, range.high));
  return *number;
}

std::vector<double> parseNumbers(const std::string& option, const std::string& text, const std::vector<size_t>& counts, const char* shape) {
  std::vector<double> numbers;
  for (const std::string& part : splitText(text, ',')) {
    const std::optional<double> number = finiteNumberOf(part);
    if (!number) throw Error(option + " " + text + ": '" + part + "' is not a finite number; give " + shape);
    numbers.push_back(*number);
  }
  if (std::ranges::find(counts, numbers.size()) == counts.end())
    throw Error(option + " " + text + ": " + std::to_string(numbers.size()) + " numbers; give " + shape);
  return numbers;
}

bool looksLikeNumber(const std::string& text) {
  return !text.empty() && std::string_view("0123456789+-.").find(text.front()) != std::string_view::npos;
}

std::vector<std::string> splitText(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

}  // namespace gridscope
