// Compares a pipeline's products with the C++ path, run beside it stage by stage.
#pragma once

#include <string>

#include "core/pipeline/pipeline.h"

namespace gridscope {

// Call afterBuild(), afterUpdate() and afterTrace() behind each of the pipeline's stages. A text names the first difference (cell and slot
// with both references, or pixel with both hits) and how many there are; empty: equal. Invariants of the grid are checked too.
class CpuCheck {
 public:
  explicit CpuCheck(Pipeline& pipeline) : pipeline_(pipeline) {}
  std::string afterBuild();
  std::string afterUpdate();
  std::string afterTrace(bool counted);

 private:
  std::string compareGrid(const char* stage);

  Pipeline& pipeline_;
  Grid grid_;
  std::vector<Triangle> worldTriangles_;
};

}  // namespace gridscope
