// Budgets: what figures of a command's results must keep to, for scripts. --fail-if "wrong>1%" ends the command with exit code 1 when
// more than one ray in a hundred is wrong.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace CLI {
class App;
}

namespace gridscope {

struct Options;

// One condition that must not come true.
struct Budget {
  enum class Relation { above, atLeast, below, atMost };
  std::string text;  // as it was given
  std::string key;   // a figure of the results: "cells.saturated", or the end of that path where only one has it; what
                     // lies in a list by its whole path, places from 0: "confirmed.refused.0"
  Relation relation = Relation::above;
  double limit = 0.0;    // of the figure itself, or of its percentage
  bool percent = false;  // of rays, of references tried, or of occupied cells, as fits the figure; of a share, itself
};

// FIGURE>NUMBER[%]; the operators are > >= < <=. Throws Error.
Budget parseBudget(const std::string& text);

// What the results say to a budget.
struct BudgetResult {
  bool broken = false;
  std::string line;  // "wrong>1%: wrong is 1,200 of 57,600 rays (2.08 %)"
};

// Throws Error for a figure that the results do not have (naming the nearest ones), that is ambiguous, that is no number or has no value
// here (null), and for a percentage of nothing known.
BudgetResult judgeBudget(const Budget& budget, const nlohmann::ordered_json& results);

// Before the work: throws Error where results of this shape (their keys, with any numbers) can't be judged. Lists that are still empty may
// hold anything.
void checkBudgets(const std::vector<Budget>& budgets, const nlohmann::ordered_json& shape);

// Do results of this shape have every budget's figure? false: more must be found out.
bool haveFigures(const std::vector<Budget>& budgets, const nlohmann::ordered_json& shape);

// Of the results of several frames: broken when those of any frame are. The line names the first such frame, and how many there are.
BudgetResult judgeFrames(const Budget& budget, const std::vector<nlohmann::ordered_json>& frames);

// Offers --fail-if, any number of times.
void addBudgetOption(CLI::App& command, Options& options);

// Prints one line for each budget that is broken; kExitDifferent when one is, else kExitDone. `frames`: the results of one frame or more.
// Throws Error.
int judgeBudgets(const Options& options, const std::vector<nlohmann::ordered_json>& frames);

}  // namespace gridscope
