// The stages of a frame on the Vulkan device, for those who see no Vulkan. The parts: scene_buffers.h, grid/device_grid.h, trace_stages.h,
// picture_stages.h.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/context.h"
#include "core/gpu/times.h"
#include "core/grid/build.h"
#include "core/grid/invariants.h"
#include "core/scene/numbering.h"
#include "core/scene/scene.h"
#include "core/trace/settings.h"
#include "core/trace/trace.h"
#include "shaders/shared/trace/frame.h"

namespace gridscope {

class GpuStages {
 public:
  // Uploads the scene and allocates what a frame of its size needs. `numbered` must outlive the stages.
  GpuStages(GpuContext& gpu, std::span<const Image> images, const NumberedScene& numbered, const FrameSettings& settings);
  ~GpuStages();

  // Makes every pass from its present shader, and lets go of it. Throws Error for the first that the device refuses.
  static void tryShaders(GpuContext& gpu);

  // Allocates the grid; its preflight is checkGridFits().
  void makeGrid(const GridParameters& grid);
  // Allocates what a frame of that size needs.
  void makeTargets(uint32_t width, uint32_t height);
  // Runs compute passes once on zeroed parameters, where each finds nothing to do: drivers compile a pass when it first runs.
  void warm(std::span<const std::string> stems);
  void setParameters(const FrameParameters& parameters);
  void setInstances(std::span<const Instance> instances);

  // Build and update: grid/device_grid.h.
  BuildReport build(Builder builder, BuildTimes& times, const std::function<bool(float)>& goesOn = {});
  UpdateReport updateAll(Builder builder, BuildTimes& times);
  UpdateReport updateMoved(std::span<const uint32_t> moved, BuildTimes& times);
  GridTotals countGrid();

  // These return milliseconds of GPU time.
  void transformAll();  // world triangles of every instance, without touching the grid
  double gather();
  double bounce();
  double trace(uint32_t firstRay, uint32_t endRay, bool counting);
  double view(const std::string& stem, uint32_t width, uint32_t height);
  RayRecord record(uint32_t pixel);

  // Products, to and from the host. Counts are the caller's to get right.
  std::vector<uint32_t> readGrid();
  void writeGrid(std::span<const uint32_t> words);
  bool hasGrid() const;
  template <typename T>
  std::vector<T> read(int binding, size_t count) {
    std::vector<T> values(count);
    readBytes(binding, std::as_writable_bytes(std::span(values)));
    return values;
  }
  template <typename T>
  void write(int binding, std::span<const T> values) {
    writeBytes(binding, std::as_bytes(values));
  }
  // The same for a buffer that is made when it is first written, or grows.
  template <typename T>
  void keep(int binding, const std::string& name, std::span<const T> values) {
    reserve(binding, name, values.size_bytes());
    write(binding, values);
  }

 private:
  struct Parts;

  void readBytes(int binding, std::span<std::byte> bytes) const;
  void writeBytes(int binding, std::span<const std::byte> bytes);
  void reserve(int binding, const std::string& name, uint64_t byteCount);

  std::unique_ptr<Parts> parts_;
};

}  // namespace gridscope
