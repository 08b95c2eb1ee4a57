// See sheet.h.
#include "app/frame/sheet.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "app/base/text.h"

namespace gridscope {

static constexpr const char* kUnknown = "\u2013";

static std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& letter : result) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return result;
}

// "72, 4, 47": the separator is a comma and what follows it.
static std::string placeText(const SheetColumn& column, size_t row, const char* separator) {
  const uint64_t number = static_cast<uint64_t>(column.values[row]);
  const uint64_t x = number % uint64_t(column.extent.x), rest = number / uint64_t(column.extent.x);
  if (column.extent.z == 0) return std::to_string(x) + separator + std::to_string(rest);
  return std::to_string(x) + separator + std::to_string(rest % uint64_t(column.extent.y)) + separator +
         std::to_string(rest / uint64_t(column.extent.y));
}

static bool isKnown(const SheetColumn& column, size_t row) { return column.known && !std::isnan(column.values[row]); }

std::string sheetText(const SheetColumn& column, size_t row) {
  if (!isKnown(column, row)) return kUnknown;
  const double value = column.values[row];
  switch (column.kind) {
    case ColumnKind::whole: return grouped(static_cast<uint64_t>(value));
    case ColumnKind::decimal: return printed(std::abs(value) < 0.1 && value != 0.0 ? "%.3g" : "%.3f", value);
    case ColumnKind::percent: return printed("%.1f %%", value);
    case ColumnKind::reference: return printed("0x%08X", static_cast<uint32_t>(value));
    case ColumnKind::word: return column.words[static_cast<size_t>(value)];
    case ColumnKind::place: return placeText(column, row, ", ");
  }
  return {};
}

std::string sheetPlainText(const SheetColumn& column, size_t row) {
  if (!isKnown(column, row)) return {};
  const double value = column.values[row];
  switch (column.kind) {
    case ColumnKind::whole: return std::to_string(static_cast<uint64_t>(value));
    case ColumnKind::decimal: return printed("%.9g", value);
    case ColumnKind::percent: return printed("%.4g", value);
    case ColumnKind::reference: return sheetText(column, row);
    case ColumnKind::word: return column.words[static_cast<size_t>(value)];
    case ColumnKind::place: return placeText(column, row, ",");
  }
  return {};
}

namespace {

enum class Comparison { holds, equals, above, below, notAbove, notBelow };

// One term of a search, made ready for the columns of a sheet.
struct Term {
  std::string text;  // small letters, places without spaces
  std::optional<size_t> column;
  Comparison comparison = Comparison::holds;
  double number = NAN;  // of all comparisons but `holds`
};

// Spaces behind a comma go, so that "72, 4, 47" is one term.
std::vector<std::string> termsOf(std::string_view search) {
  std::vector<std::string> terms;
  std::string term;
  for (size_t at = 0; at < search.size(); ++at) {
    if (!std::isspace(static_cast<unsigned char>(search[at]))) {
      term += static_cast<char>(std::tolower(static_cast<unsigned char>(search[at])));
    } else if (!term.empty() && term.back() != ',') {
      terms.push_back(term);
      term.clear();
    }
  }
  if (!term.empty()) terms.push_back(term);
  return terms;
}

// The column that a word names: its title without spaces, or its first word ("rays" for "rays lost" only where no column is called so).
std::optional<size_t> columnNamed(const Sheet& sheet, const std::string& word) {
  for (const bool firstWord : {false, true}) {
    for (size_t column = 0; column < sheet.columns.size(); ++column) {
      std::string title = lowered(sheet.columns[column].title);
      if (firstWord) title = title.substr(0, title.find(' '));
      std::erase(title, ' ');
      if (title == word) return column;
    }
  }
  return std::nullopt;
}

std::optional<double> numberOf(std::string text) {
  std::erase(text, ',');
  if (!text.empty() && text.back() == '%') text.pop_back();
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// "refused>5" as a term; nothing: not one.
std::optional<Term> comparisonTerm(const Sheet& sheet, const std::string& word) {
  const size_t at = word.find_first_of("<>=");
  if (at == std::string::npos || at == 0) return std::nullopt;
  const bool orEqual = word[at] != '=' && at + 1 < word.size() && word[at + 1] == '=';
  const std::optional<size_t> column = columnNamed(sheet, word.substr(0, at));
  const std::optional<double> number = numberOf(word.substr(at + (orEqual ? 2 : 1)));
  if (!column || !number) return std::nullopt;
  Comparison comparison = Comparison::equals;
  if (word[at] == '>') comparison = orEqual ? Comparison::notBelow : Comparison::above;
  if (word[at] == '<') comparison = orEqual ? Comparison::notAbove : Comparison::below;
  return Term{.text = word, .column = column, .comparison = comparison, .number = *number};
}

std::vector<Term> parseSearch(const Sheet& sheet, std::string_view search) {
  const std::vector<std::string> words = termsOf(search);
  std::vector<Term> terms;
  for (size_t at = 0; at < words.size(); ++at) {
    if (const auto term = comparisonTerm(sheet, words[at])) {
      terms.push_back(*term);
      continue;
    }
    const std::optional<size_t> column = at + 1 < words.size() ? columnNamed(sheet, words[at]) : std::nullopt;
    if (!column) {
      terms.push_back({.text = words[at]});
      continue;
    }
    Term term{.text = words[++at], .column = column};
    const ColumnKind kind = sheet.columns[*column].kind;
    if (kind == ColumnKind::whole || kind == ColumnKind::decimal || kind == ColumnKind::percent) {
      term.comparison = Comparison::equals;
      term.number = numberOf(term.text).value_or(NAN);
    }
    terms.push_back(term);
  }
  return terms;
}

// One term against one column, what does not change from row to row worked out before.
class ColumnMatch {
 public:
  ColumnMatch(const SheetColumn& column, const Term& term) : column_(column), term_(term) {
    for (const std::string& word : column.words) wordMatches_.push_back(lowered(word).find(term.text) != std::string::npos);
    hexadecimal_ = term.text.starts_with("0x");
    numeric_ = term.text.find_first_not_of("0123456789.,%-") == std::string::npos;
  }

  bool at(size_t row) const {
    if (!isKnown(column_, row)) return false;
    const double value = column_.values[row];
    if (term_.comparison != Comparison::holds) return compares(value);
    if (column_.kind == ColumnKind::reference)
      return hexadecimal_ && lowered(sheetText(column_, row)).find(term_.text) != std::string::npos;
    if (column_.kind == ColumnKind::word) return wordMatches_[static_cast<size_t>(value)];
    if (!numeric_) return false;
    if (column_.kind == ColumnKind::place) {
      const std::string place = placeText(column_, row, ",");
      return term_.column ? place == term_.text : place.find(term_.text) != std::string::npos;
    }
    const bool withCommas = column_.kind != ColumnKind::whole || term_.text.find(',') != std::string::npos;
    if (withCommas) return sheetText(column_, row).find(term_.text) != std::string::npos;
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof(digits), static_cast<uint64_t>(value)).ptr;
    return std::string_view(digits, size_t(end - digits)).find(term_.text) != std::string_view::npos;
  }

 private:
  // Equal: as far as the number was typed.
  bool compares(double value) const {
    switch (term_.comparison) {
      case Comparison::above: return value > term_.number;
      case Comparison::below: return value < term_.number;
      case Comparison::notAbove: return value <= term_.number;
      case Comparison::notBelow: return value >= term_.number;
      default:
        return column_.kind == ColumnKind::whole ? value == term_.number : std::abs(value - term_.number) < 5e-4 + 1e-6 * std::abs(value);
    }
  }

  const SheetColumn& column_;
  const Term& term_;
  std::vector<uint8_t> wordMatches_;
  bool numeric_ = false, hexadecimal_ = false;
};

// Rows that hold one term.
void keepMatching(const Sheet& sheet, const Term& term, std::vector<uint32_t>& rows) {
  std::vector<ColumnMatch> matches;
  for (size_t column = 0; column < sheet.columns.size(); ++column)
    if (!term.column || *term.column == column) matches.emplace_back(sheet.columns[column], term);
  std::erase_if(rows, [&](uint32_t row) {
    return std::none_of(matches.begin(), matches.end(), [&](const ColumnMatch& match) { return match.at(row); });
  });
}

// What a column's rows are sorted by: words by the alphabet.
std::vector<double> sortKeys(const SheetColumn& column) {
  if (column.kind != ColumnKind::word) return column.values;
  std::vector<size_t> byAlphabet(column.words.size());
  std::iota(byAlphabet.begin(), byAlphabet.end(), size_t{0});
  std::stable_sort(byAlphabet.begin(), byAlphabet.end(),
                   [&](size_t a, size_t b) { return lowered(column.words[a]) < lowered(column.words[b]); });
  std::vector<double> rank(column.words.size());
  for (size_t at = 0; at < byAlphabet.size(); ++at) {
    const bool same = at > 0 && lowered(column.words[byAlphabet[at]]) == lowered(column.words[byAlphabet[at - 1]]);
    rank[byAlphabet[at]] = same ? rank[byAlphabet[at - 1]] : double(at);
  }
  std::vector<double> keys(column.values);
  for (double& key : keys)
    if (!std::isnan(key)) key = rank[static_cast<size_t>(key)];
  return keys;
}

}  // namespace

SheetRows sheetRows(const Sheet& sheet, const SheetOrder& order, std::string_view search) {
  SheetRows result;
  for (uint32_t row = 0; row < sheet.rowCount(); ++row)
    if (sheet.inArea.empty() || sheet.inArea[row]) result.rows.push_back(row);
  result.inArea = result.rows.size();

  for (const Term& term : parseSearch(sheet, search)) keepMatching(sheet, term, result.rows);

  if (order.column >= sheet.columns.size() || !sheet.columns[order.column].known) return result;
  const std::vector<double> keys = sortKeys(sheet.columns[order.column]);
  std::stable_sort(result.rows.begin(), result.rows.end(), [&](uint32_t a, uint32_t b) {
    if (std::isnan(keys[a]) || std::isnan(keys[b])) return !std::isnan(keys[a]) && std::isnan(keys[b]);
    return order.falling ? keys[a] > keys[b] : keys[a] < keys[b];
  });
  return result;
}

static std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

std::string sheetCsv(const Sheet& sheet, std::span<const uint32_t> rows) {
  std::string text;
  const auto endField = [&](size_t column) { text += column + 1 < sheet.columns.size() ? "," : "\r\n"; };
  for (size_t column = 0; column < sheet.columns.size(); ++column) text += csvField(sheet.columns[column].title), endField(column);
  for (const uint32_t row : rows)
    for (size_t column = 0; column < sheet.columns.size(); ++column)
      text += csvField(sheetPlainText(sheet.columns[column], row)), endField(column);
  return text;
}

std::string csvText(std::span<const std::vector<std::string>> rows) {
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    for (size_t field = 0; field < row.size(); ++field) text += (field == 0 ? "" : ",") + csvField(row[field]);
    text += "\r\n";
  }
  return text;
}

std::string csvName(const std::string& scene, const std::string& table) {
  const std::string stem = std::filesystem::path(scene).stem().string();
  return (stem.empty() ? "scene" : stem) + "_" + table + ".csv";
}

}  // namespace gridscope
