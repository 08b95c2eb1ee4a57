// The stages of a frame on the Vulkan device: the scene's buffers, the grid image and the products, and the passes over them.
// scene.cpp uploads the scene, build.cpp builds and updates, gather.cpp gathers, bounces and fills views, trace.cpp traces.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/program.h"
#include "core/grid/build.h"
#include "core/grid/invariants.h"
#include "core/grid/settings.h"
#include "core/scene/numbering.h"
#include "core/scene/scene.h"
#include "core/trace/trace.h"
#include "shaders/shared/views/view_element.h"

namespace gridscope {

// Milliseconds of GPU time.
struct BuildTimes {
  double clear = 0.0;
  double add = 0.0;
};

class GpuStages {
 public:
  // Uploads the scene and allocates what a frame of `pixelCount` pixels needs. textureSize: texels of a diffuse map's side.
  GpuStages(GpuContext& gpu, std::span<const Image> images, const NumberedScene& numbered, const FrameSettings& settings);
  ~GpuStages();

  // Makes every pass from its present shader, and lets go of it. Throws Error for the first that the device refuses.
  static void tryShaders(GpuContext& gpu);

  // Allocates the grid image; its preflight is checkGridFits().
  void makeGrid(const GridParameters& grid);
  // Allocates what a frame of that size needs.
  void makeTargets(uint32_t width, uint32_t height);
  // Runs compute passes once on zeroed parameters, where each finds nothing to do: drivers compile a pass when it first runs.
  void warm(std::span<const std::string> stems);
  void setParameters(const FrameParameters& parameters);
  void setInstances(std::span<const Instance> instances);

  // Build of the static instances into an empty grid. Throws Error (kExitDevice) when a loop was cut short, and when `goesOn`, which is told
  // how much is done (0..1), says no.
  BuildReport build(Builder builder, BuildTimes& times, const std::function<bool(float)>& goesOn = {});
  // Update of the dynamic instances, whose new transforms are in the instances already.
  UpdateReport updateAll(Builder builder, BuildTimes& times);
  UpdateReport updateMoved(std::span<const uint32_t> moved, BuildTimes& times);
  GridTotals countGrid();

  // These return milliseconds of GPU time.
  void transformAll();  // world triangles of every instance, without touching the grid
  double gather();
  double bounce();
  double trace(uint32_t firstRay, uint32_t endRay, bool counting);
  double view(const std::string& name, uint32_t width, uint32_t height);
  RayRecord record(uint32_t pixel);

  // Products, to and from the host. Counts are the caller's to get right.
  std::vector<uint32_t> readGrid();
  void writeGrid(std::span<const uint32_t> texels);
  bool hasGrid() const { return bool(grid_); }
  template <typename T>
  std::vector<T> read(int binding, size_t count) {
    return download<T>(gpu_, buffers_[binding], count);
  }
  template <typename T>
  void write(int binding, std::span<const T> values) {
    upload(gpu_, buffers_[binding], values);
  }
  // The same for a buffer that is made when it is first written, or grows.
  template <typename T>
  void keep(int binding, const std::string& name, std::span<const T> values) {
    if (buffers_[binding].byteCount() < values.size_bytes()) makeBuffer(binding, name, values.size_bytes());
    write(binding, values);
  }

 private:
  void makeBuffer(int binding, const std::string& name, uint64_t byteCount);
  void uploadScene(const NumberedScene& numbered);
  void uploadImages(std::span<const Image> images, uint32_t textureSize);

  // Passes over instances (build.cpp).
  PassArguments argumentsFor(InstanceRange range, uint32_t take) const;
  void zero(GpuCommands& commands, int binding);
  void clearGrid(GpuCommands& commands);
  void transform(GpuCommands& commands, InstanceRange range, uint32_t take);
  void walk(GpuCommands& commands, const std::string& operation, InstanceRange range, uint32_t take);
  void walkBig(GpuCommands& commands, const std::string& operation, PassArguments arguments);
  void buildRaster(GpuCommands& commands, InstanceRange range);
  void add(GpuCommands& commands, Builder builder, InstanceRange range);
  BuildReport readReport(const char* stage);

  GpuContext& gpu_;
  const NumberedScene& numbered_;
  GpuPrograms programs_;
  FrameParameters parameters_{};
  GpuBuffer buffers_[kBindingCount];  // by binding; images have none
  GpuImage grid_;
  GpuImage visibility_;
  GpuImage depth_;
  GpuImage diffuseMaps_;
  VkSampler sampler_ = VK_NULL_HANDLE;
};

}  // namespace gridscope
