// See budget.h.
#include "app/budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/option_values.h"
#include "app/options.h"
#include "app/report.h"
#include "app/text.h"
#include "core/error.h"

namespace gridscope {

namespace {

using Json = nlohmann::ordered_json;
using Relation = Budget::Relation;

constexpr const char* kShape = "give a figure, > >= < or <=, and a number or a percentage: wrong>1% say";

std::string withoutSpaces(const std::string& text) {
  std::string packed;
  for (char letter : text)
    if (letter != ' ' && letter != '\t') packed += letter;
  return packed;
}

bool holds(double value, Relation relation, double limit) {
  switch (relation) {
    case Relation::above: return value > limit;
    case Relation::atLeast: return value >= limit;
    case Relation::below: return value < limit;
    case Relation::atMost: return value <= limit;
  }
  return false;
}

// Paths of all numbers and of yes and no, "cells.saturated"; lists are no figures.
void listFigures(const Json& json, const std::string& path, std::vector<std::string>& paths) {
  if (json.is_object())
    for (const auto& [name, value] : json.items()) listFigures(value, path.empty() ? name : path + "." + name, paths);
  else if (json.is_number() || json.is_boolean())
    paths.push_back(path);
}

const Json& at(const Json& results, const std::string& path) {
  const Json* json = &results;
  for (const std::string& name : splitText(path, '.')) json = &json->at(name);
  return *json;
}

// Least number of letters to change, add or drop (Levenshtein).
size_t editsBetween(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t i = 0; i <= b.size(); ++i) row[i] = i;
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i + 1;
    for (size_t k = 0; k < b.size(); ++k) {
      const size_t changed = diagonal + (std::tolower(a[i]) == std::tolower(b[k]) ? 0 : 1);
      diagonal = row[k + 1];
      row[k + 1] = std::min({changed, row[k] + 1, row[k + 1] + 1});
    }
  }
  return row.back();
}

std::string_view lastName(std::string_view path) { return path.substr(path.rfind('.') + 1); }

std::string nearestNames(const std::vector<std::string>& paths, const std::string& key) {
  std::vector<std::string> sorted = paths;
  const auto distance = [&](const std::string& path) { return std::min(editsBetween(path, key), editsBetween(lastName(path), key)); };
  std::ranges::stable_sort(sorted, {}, distance);
  sorted.resize(std::min<size_t>(sorted.size(), 4));
  return joined(sorted, ", ");
}

// Counts of rays, by verdict or cause say: a short name like `refused` does not mean them.
bool countsRays(const std::string& path) {
  for (const char* group : {"agree.", "verdicts.", "causes.", "rays."})
    if (path.starts_with(group) || path.find("." + std::string(group)) != std::string::npos) return true;
  return lastName(path) == "wrong" || lastName(path) == "raysChange";
}

// The whole path of a figure.
std::string findFigure(const Budget& budget, const Json& results) {
  std::vector<std::string> paths, ends;
  listFigures(results, "", paths);
  if (std::ranges::find(paths, budget.key) != paths.end()) return budget.key;
  for (const std::string& path : paths)
    if (path.ends_with("." + budget.key)) ends.push_back(path);
  std::vector<std::string> plain;
  std::ranges::copy_if(ends, std::back_inserter(plain), [](const std::string& path) { return !countsRays(path); });
  if (!plain.empty()) ends = plain;
  if (ends.size() == 1) return ends.front();
  if (ends.empty()) throw Error("--fail-if " + budget.text + ": the results have no figure '" + budget.key + "'; the nearest are " + nearestNames(paths, budget.key));
  throw Error("--fail-if " + budget.text + ": '" + budget.key + "' may be " + joined(ends, " or ") + "; give the whole name");
}

// What a percentage is taken of.
struct Whole {
  double count = 0.0;
  const char* words = "";
};

std::string groupOf(const std::string& path) { return path.substr(0, path.rfind('.') == std::string::npos ? 0 : path.rfind('.')); }

// A number of a group, or what it counts.
std::optional<double> findIn(const Json& results, const std::string& group, const char* name) {
  const Json& json = group.empty() ? results : at(results, group);
  const auto found = json.find(name);
  if (found == json.end()) return std::nullopt;
  if (found->is_number()) return found->get<double>();
  return found->is_object() && found->contains("count") ? std::optional(found->at("count").get<double>()) : std::nullopt;
}

Whole wholeOf(const Budget& budget, const Json& results, const std::string& path) {
  // The rays of the figure's group, or of one above it.
  if (countsRays(path))
    for (std::string group = path; !group.empty();) {
      group = groupOf(group);
      if (const std::optional<double> rays = findIn(results, group, "rays")) return {*rays, "rays"};
    }
  else if (const std::optional<double> tried = findIn(results, groupOf(path), "tried")) return {*tried, "references tried"};
  else if (const std::optional<double> cells = findIn(results, groupOf(path), "occupied")) return {*cells, "occupied cells"};
  throw Error("--fail-if " + budget.text + ": a percentage of what? The results have no whole for " + path + "; give a number");
}

std::string figureText(double value) {
  return value >= 0.0 && value == std::floor(value) && value < 1e15 ? grouped(uint64_t(value)) : printed("%.6g", value);
}

}  // namespace

Budget parseBudget(const std::string& text) {
  const std::string packed = withoutSpaces(text);
  const size_t sign = packed.find_first_of("<>");
  if (sign == std::string::npos || sign == 0) throw Error("--fail-if " + text + ": " + kShape);
  const bool orEqual = sign + 1 < packed.size() && packed[sign + 1] == '=';
  Budget budget{.text = text, .key = packed.substr(0, sign)};
  if (packed[sign] == '>') budget.relation = orEqual ? Relation::atLeast : Relation::above;
  else budget.relation = orEqual ? Relation::atMost : Relation::below;
  std::string number = packed.substr(sign + (orEqual ? 2 : 1));
  budget.percent = number.ends_with('%');
  if (budget.percent) number.pop_back();
  if (!looksLikeNumber(number)) throw Error("--fail-if " + text + ": " + kShape);
  budget.limit = parseNumber("--fail-if " + text, number, {-1e18, 1e18});
  return budget;
}

BudgetResult judgeBudget(const Budget& budget, const Json& results) {
  const std::string path = findFigure(budget, results);
  const Json& figure = at(results, path);
  const double value = figure.is_boolean() ? double(figure.get<bool>()) : figure.get<double>();
  BudgetResult result;
  result.line = budget.text + ": " + path + " is " + figureText(value);
  if (!budget.percent) {
    result.broken = holds(value, budget.relation, budget.limit);
    return result;
  }
  const Whole whole = wholeOf(budget, results, path);
  const double percentage = whole.count > 0.0 ? 100.0 * value / whole.count : 0.0;
  result.broken = holds(percentage, budget.relation, budget.limit);
  result.line += " of " + figureText(whole.count) + " " + whole.words + printed(" (%.4g %%)", percentage);
  return result;
}

bool budgetsNeedTruth(const Options& options) {
  return std::ranges::any_of(options.budgets, [](const Budget& budget) {
    constexpr std::array<std::string_view, 11> kNames = {"wrong", "agree", "verdicts", "causes", "hole", "voxelRight", "voxelWrong", "far", "near", "hit", "miss"};
    return std::ranges::find(kNames, splitText(budget.key, '.').front()) != kNames.end();
  });
}

void addBudgetOption(CLI::App& command, Options& options) {
  CLI::Option* option = command.add_option_function<std::vector<std::string>>(
      "--fail-if",
      [&options](const std::vector<std::string>& given) {
        options.budgets.clear();
        for (const std::string& text : given) options.budgets.push_back(parseBudget(text));
      },
      "Exit 1, and one line, when it is so: wrong>1%, saturated>500, refused>10%; any figure of the JSON; percent of rays, of references "
      "tried, of occupied cells. May be given more than once");
  option->type_name("\"FIGURE>N[%]\"")->group("Results")->expected(1)->take_all();
}

int judgeBudgets(const Options& options, const Json& results) {
  int code = kExitDone;
  for (const Budget& budget : options.budgets) {
    const BudgetResult result = judgeBudget(budget, results);
    if (!result.broken) continue;
    std::fprintf(textStream(options), "%s\n", result.line.c_str());
    code = kExitDifferent;
  }
  return code;
}

}  // namespace gridscope
