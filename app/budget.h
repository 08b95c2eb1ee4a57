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
  std::string text;                    // as it was given
  std::string key;                     // a figure of the results: "cells.saturated", or the end of that path where only one has it
  Relation relation = Relation::above;
  double limit = 0.0;                  // of the figure itself, or of its percentage
  bool percent = false;                // of rays, of references tried, or of occupied cells, as fits the figure
};

// FIGURE>NUMBER[%]; the operators are > >= < <=. Throws Error.
Budget parseBudget(const std::string& text);

// What the results say to a budget.
struct BudgetResult {
  bool broken = false;
  std::string line;                    // "wrong>1%: wrong is 1,200 of 57,600 rays (2.08 %)"
};

// Throws Error for a figure that the results do not have (naming the nearest ones), that is ambiguous or no number, and for a percentage
// of nothing known.
BudgetResult judgeBudget(const Budget& budget, const nlohmann::ordered_json& results);

// Does some budget ask for a figure of the truth: verdicts, causes, wrong rays? It costs seconds.
bool budgetsNeedTruth(const Options& options);

// Offers --fail-if, any number of times.
void addBudgetOption(CLI::App& command, Options& options);

// Prints one line for each budget that is broken; kExitDifferent when one is, else kExitDone. Throws Error.
int judgeBudgets(const Options& options, const nlohmann::ordered_json& results);

}  // namespace gridscope
