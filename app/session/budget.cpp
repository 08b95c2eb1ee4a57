// See budget.h.
#include "app/session/budget.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/base/text.h"
#include "app/session/option_values.h"
#include "app/session/options.h"
#include "core/base/error.h"

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

// Paths of everything that a budget may name, "cells.saturated".
struct Figures {
  std::vector<std::string> named;   // numbers, yes and no, and figures without a value here: a short name may mean them
  std::vector<std::string> listed;  // what lies in lists
};

void listFigures(const Json& json, const std::string& path, bool inList, Figures& figures) {
  if (json.is_structured()) {
    for (const auto& [name, value] : json.items())
      listFigures(value, path.empty() ? name : path + "." + name, inList || json.is_array(), figures);
  } else if (!json.is_string()) {
    (inList ? figures.listed : figures.named).push_back(path);
  }
}

// What lies at a path. Nothing: it leads nowhere; `intoEmptyList` says that it does so through a list without elements.
const Json* find(const Json& results, const std::string& path, bool* intoEmptyList = nullptr) {
  const Json* json = &results;
  for (const std::string& name : splitText(path, '.')) {
    if (intoEmptyList && json->is_array() && json->empty()) *intoEmptyList = true;
    if (json->is_object() && json->contains(name))
      json = &json->at(name);
    else if (json->is_array() && !name.empty() && name.size() < 9 && name.find_first_not_of("0123456789") == std::string::npos &&
             std::stoul(name) < json->size())
      json = &json->at(std::stoul(name));
    else
      return nullptr;
  }
  return json;
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

// Is some part of the path one of these groups?
bool liesIn(const std::string& path, std::initializer_list<std::string> groups) {
  return std::ranges::any_of(
      groups, [&](const std::string& group) { return path.starts_with(group) || path.find("." + group) != std::string::npos; });
}

// Counts of rays by verdict or cause: a short name like `refused` does not mean them where something else has it.
bool tellsTruth(const std::string& path) {
  return liesIn(path, {"agree.", "verdicts.", "causes.", "rays."}) || lastName(path) == "wrong" || lastName(path) == "raysChange";
}

bool countsRays(const std::string& path) {
  const std::string_view last = lastName(path);
  return tellsTruth(path) || liesIn(path, {"hits."}) || (last == "rays" && path != last) || last == "foreignHits" || last == "notConfirmed";
}

bool isShare(const std::string& path) { return lastName(path) == "share" || path.ends_with("Share"); }

// Whole paths that a key may mean.
std::vector<std::string> pathsMeant(const std::string& key, const Json& results) {
  const Json* whole = find(results, key);
  if (whole && !whole->is_structured() && !whole->is_string()) return {key};
  Figures figures;
  listFigures(results, "", false, figures);
  std::vector<std::string> ends, plain;
  std::ranges::copy_if(figures.named, std::back_inserter(ends), [&](const std::string& path) { return path.ends_with("." + key); });
  std::ranges::copy_if(ends, std::back_inserter(plain), [](const std::string& path) { return !tellsTruth(path); });
  return plain.empty() ? ends : plain;
}

[[noreturn]] void refuseKey(const Budget& budget, const Json& results) {
  const std::string start = "--fail-if " + budget.text + ": ";
  if (const Json* group = find(results, budget.key); group && group->is_array() && !group->empty())
    throw Error(start + budget.key + " is a list; give one of it: " + budget.key + ".0 to " + budget.key + "." +
                std::to_string(group->size() - 1));
  Figures figures;
  listFigures(results, "", false, figures);
  std::vector<std::string> all = figures.named;
  all.insert(all.end(), figures.listed.begin(), figures.listed.end());
  throw Error(start + "the results have no figure '" + budget.key + "'; the nearest are " + nearestNames(all, budget.key));
}

// The whole path of a figure.
std::string findFigure(const Budget& budget, const Json& results) {
  const std::vector<std::string> paths = pathsMeant(budget.key, results);
  if (paths.empty()) refuseKey(budget, results);
  if (paths.size() > 1)
    throw Error("--fail-if " + budget.text + ": '" + budget.key + "' may be " + joined(paths, " or ") + "; give the whole name");
  if (find(results, paths.front())->is_null())
    throw Error("--fail-if " + budget.text + ": " + paths.front() + " has no value here: this grid does not count it");
  return paths.front();
}

// What a percentage is taken of.
struct Whole {
  double count = 0.0;
  const char* words = "";
};

std::string groupOf(const std::string& path) { return path.substr(0, path.rfind('.') == std::string::npos ? 0 : path.rfind('.')); }

// A number of a group, or what it counts.
std::optional<double> findIn(const Json& results, const std::string& group, const char* name) {
  const Json& json = group.empty() ? results : *find(results, group);
  if (!json.is_object()) return std::nullopt;
  const auto found = json.find(name);
  if (found == json.end()) return std::nullopt;
  if (found->is_number()) return found->get<double>();
  return found->is_object() && found->contains("count") ? std::optional(found->at("count").get<double>()) : std::nullopt;
}

// The rays of the figure's group, or of one above it.
std::optional<double> raysAround(const Json& results, std::string path) {
  if (lastName(path) == "rays") path = groupOf(path);
  while (!path.empty()) {
    path = groupOf(path);
    if (const std::optional<double> rays = findIn(results, path, "rays")) return rays;
  }
  return std::nullopt;
}

Whole wholeOf(const Budget& budget, const Json& results, const std::string& path) {
  // Proofs: lists that end with how many there were.
  if (liesIn(path, {"confirmed.", "control.causes.", "controlChain.causes."}) && find(results, groupOf(path))->is_array())
    return {find(results, groupOf(path))->back().get<double>(), "rays of that cause"};
  if (countsRays(path)) {
    if (const std::optional<double> rays = raysAround(results, path)) return {*rays, "rays"};
  } else if (const std::optional<double> tried = findIn(results, groupOf(path), "tried")) {
    return {*tried, "references tried"};
  } else if (const std::optional<double> cells = findIn(results, groupOf(path), "occupied")) {
    return {*cells, "occupied cells"};
  } else if (const std::optional<double> total = findIn(results, groupOf(path), "total")) {
    return {*total, "in all"};
  }
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
  if (packed[sign] == '>')
    budget.relation = orEqual ? Relation::atLeast : Relation::above;
  else
    budget.relation = orEqual ? Relation::atMost : Relation::below;
  std::string number = packed.substr(sign + (orEqual ? 2 : 1));
  budget.percent = number.ends_with('%');
  if (budget.percent) number.pop_back();
  if (!looksLikeNumber(number)) throw Error("--fail-if " + text + ": " + kShape);
  budget.limit = parseNumber("--fail-if " + text, number, {-1e18, 1e18});
  return budget;
}

BudgetResult judgeBudget(const Budget& budget, const Json& results) {
  const std::string path = findFigure(budget, results);
  const Json& figure = *find(results, path);
  const double value = figure.is_boolean() ? double(figure.get<bool>()) : figure.get<double>();
  BudgetResult result;
  result.line = budget.text + ": " + path + " is " + figureText(value);
  if (!budget.percent || isShare(path)) {
    result.broken = holds(budget.percent ? 100.0 * value : value, budget.relation, budget.limit);
    if (budget.percent) result.line += printed(" (%.4g %%)", 100.0 * value);
    return result;
  }
  const Whole whole = wholeOf(budget, results, path);
  const double percentage = whole.count > 0.0 ? 100.0 * value / whole.count : 0.0;
  result.broken = holds(percentage, budget.relation, budget.limit);
  result.line += " of " + figureText(whole.count) + " " + whole.words + printed(" (%.4g %%)", percentage);
  return result;
}

void checkBudgets(const std::vector<Budget>& budgets, const Json& shape) {
  for (const Budget& budget : budgets) {
    bool intoEmptyList = false;
    if (find(shape, budget.key, &intoEmptyList) || !intoEmptyList) judgeBudget(budget, shape);
  }
}

bool haveFigures(const std::vector<Budget>& budgets, const Json& shape) {
  return std::ranges::none_of(budgets, [&](const Budget& budget) {
    bool intoEmptyList = false;
    return pathsMeant(budget.key, shape).empty() && !find(shape, budget.key, &intoEmptyList) && !intoEmptyList;
  });
}

BudgetResult judgeFrames(const Budget& budget, const std::vector<Json>& frames) {
  BudgetResult first;
  size_t broken = 0;
  bool same = true;  // the figure is no frame's own
  for (size_t frame = 0; frame < frames.size(); ++frame) {
    BudgetResult result = judgeBudget(budget, frames[frame]);
    if (!result.broken) continue;
    if (broken++ > 0)
      same = same && first.line.ends_with(result.line);
    else
      first = {true, printed("frame %zu: ", frame) + result.line};
  }
  if (broken == 0) return first;
  if (same && broken == frames.size())
    first.line = first.line.substr(first.line.find(": ") + 2);
  else if (broken > 1)
    first.line += printed("; likewise %zu more of %zu frames", broken - 1, frames.size());
  return first;
}

void addBudgetOption(CLI::App& command, Options& options) {
  CLI::Option* option = command.add_option_function<std::vector<std::string>>(
      "--fail-if",
      [&options](const std::vector<std::string>& given) {
        options.budgets.clear();
        for (const std::string& text : given) options.budgets.push_back(parseBudget(text));
      },
      "Exit 1, and one line, when it is so: wrong>1%, saturated>500, refused>10%; any figure of the JSON (of a list: worstCells.0.rays); "
      "percent of rays, of references tried, of occupied cells; of several frames each is judged. May be given more than once");
  option->type_name("\"FIGURE>N[%]\"")->group("Results")->expected(1)->take_all();
}

int judgeBudgets(const Options& options, const std::vector<Json>& frames) {
  int code = kExitDone;
  for (const Budget& budget : options.budgets) {
    const BudgetResult result = judgeFrames(budget, frames);
    if (!result.broken) continue;
    std::fprintf(textStream(options), "%s\n", result.line.c_str());
    code = kExitDifferent;
  }
  return code;
}

}  // namespace gridscope
