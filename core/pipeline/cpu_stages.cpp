// See cpu_stages.h.
#include "core/pipeline/cpu_stages.h"

#include <cstring>

#include "core/base/error.h"
#include "core/grid/derive.h"

namespace gridscope {

CpuStages::CpuStages(PipelineInputs inputs)
    : scene_(std::move(inputs.numbered)),
      parameters_(inputs.parameters),
      mode_(inputs.settings.grid.update),
      worldTriangles_(scene_.triangleCount) {
  checkGridFits(inputs.settings.grid, parameters_.grid, {});
}

void CpuStages::build() {
  BuildReport report;
  grid_ = buildGrid(parameters_.grid, scene_, worldTriangles_, report);
  dynamicAdded_ = false;
}

void CpuStages::update(std::span<const Instance> instances) {
  CHECK_EQ(instances.size(), scene_.instances.size());
  std::vector<uint32_t> moved;
  for (uint32_t i = scene_.staticInstanceCount; i < instances.size(); ++i)
    if (std::memcmp(&instances[i], &scene_.instances[i], sizeof(Instance)) != 0) moved.push_back(i);
  scene_.instances.assign(instances.begin(), instances.end());
  if (!dynamicAdded_ || mode_ == UpdateMode::all)
    updateAll(scene_, worldTriangles_, grid_);
  else
    updateMoved(scene_, moved, worldTriangles_, grid_);
  dynamicAdded_ = true;
}

void CpuStages::useGrid(std::span<const uint32_t> words) {
  grid_ = {parameters_.grid, {words.begin(), words.end()}};
  transformTriangles(scene_, {0, scene_.instanceCount()}, worldTriangles_);
}

void CpuStages::trace(bool counting) {
  hits_.assign(rays_.size(), Hit{});
  counters_.assign(counting ? rays_.size() : 0, RayCounters{});
  traceRays({grid_, scene_, worldTriangles_, parameters_.trace}, rays_, hits_, counters_);
}

}  // namespace gridscope
