// The grid on the device: its storage, and the passes that clear, build, update and count it, to which core/grid gives all that depends on how
// cells lie in that storage. core/grid/build.h is the same in C++, and says what each stage leaves in the grid.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/scene_buffers.h"
#include "core/gpu/times.h"
#include "core/grid/build.h"
#include "core/grid/invariants.h"
#include "core/grid/settings.h"
#include "core/grid/storage.h"

namespace gridscope {

class DeviceGrid {
 public:
  DeviceGrid(GpuPrograms& programs, SceneBuffers& scene);

  // The graphics pass that builds (Builder::raster): for devices with a geometry stage.
  static PassDescription rasterPass();

  // Allocates the storage; its preflight is checkGridFits().
  void make(const GridParameters& grid);
  bool made() const;
  // Of the stages that run next; the storage must be of the same shape.
  void setParameters(const GridParameters& grid);

  // Build of the static instances into an empty grid. Throws Error (kExitDevice) when a loop was cut short, and when `goesOn`, which is told
  // how much is done (0..1), says no.
  BuildReport build(Builder builder, BuildTimes& times, const std::function<bool(float)>& goesOn = {});
  // Update of the dynamic instances, whose new transforms are in the instances already.
  UpdateReport updateAll(Builder builder, BuildTimes& times);
  UpdateReport updateMoved(std::span<const uint32_t> moved, BuildTimes& times);
  GridTotals count();

  // The storage's words, x fastest.
  std::vector<uint32_t> read() const;
  void write(std::span<const uint32_t> words);

 private:
  void walk(GpuCommands& commands, const std::string& operation, InstanceRange range, uint32_t take);
  void walkBig(GpuCommands& commands, const std::string& operation, PassArguments arguments);
  void buildRaster(GpuCommands& commands, InstanceRange range);
  void add(GpuCommands& commands, Builder builder, InstanceRange range);
  BuildReport readReport(const char* stage);

  GpuPrograms& programs_;
  SceneBuffers& scene_;
  GridParameters grid_{};
};

}  // namespace gridscope
