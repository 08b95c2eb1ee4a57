// The passes compiled while the program runs, from the source folder that it was built from: after an edit, F5 brings them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gridscope {

struct CompiledShaders {
  std::map<std::string, std::vector<uint32_t>> words;  // SPIR-V by stem; empty when something failed
  std::string fault;                                   // the compiler's text of the first that failed; empty: none
};

// All passes. `folder`: the source folder; by default (empty) the one of the build. `goesOn` is told how much is done (0..1); where it says no,
// that is the fault.
CompiledShaders compileShaders(const std::string& folder = "", const std::function<bool(float)>& goesOn = {});

}  // namespace gridscope
