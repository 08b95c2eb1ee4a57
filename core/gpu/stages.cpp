// See stages.h.
#include "core/gpu/stages.h"

#include "core/gpu/grid/device_grid.h"
#include "core/gpu/picture_stages.h"
#include "core/gpu/shader_code.h"
#include "core/gpu/trace_stages.h"
#include "shaders/shared/gpu/bindings.h"

namespace gridscope {

struct GpuStages::Parts {
  GpuPrograms programs;
  SceneBuffers scene;
  DeviceGrid grid;
  TraceStages trace;
  PictureStages pictures;
  FrameParameters parameters{};

  Parts(GpuDevice& gpu, std::span<const Image> images, const NumberedScene& numbered, uint32_t textureSize)
      : programs(gpu), scene(programs, images, numbered, textureSize), grid(programs, scene), trace(programs), pictures(programs, scene) {
    programs.bound().makeBuffer(kBindParameters, "parameters", sizeof(FrameParameters));
  }
  void writeParameters(const FrameParameters& values) { programs.write(kBindParameters, std::span(&values, 1)); }
};

GpuStages::GpuStages(GpuContext& gpu, std::span<const Image> images, const NumberedScene& numbered, const FrameSettings& settings)
    : parts_(std::make_unique<Parts>(gpu.device(), images, numbered, settings.textureSize)) {
  makeTargets(settings.width, settings.height);
}

GpuStages::~GpuStages() = default;

void GpuStages::tryShaders(GpuContext& gpu) {
  GpuPrograms programs(gpu.device());
  for (const ShaderCode& shader : allShaders())
    if (shader.source.ends_with(".comp")) programs.make(computePass(std::string(shader.stem)));
  programs.make(PictureStages::gatherPass());
  if (gpu.report().geometryStage) programs.make(DeviceGrid::rasterPass());
}

void GpuStages::makeGrid(const GridParameters& grid) { parts_->grid.make(grid); }

void GpuStages::makeTargets(uint32_t width, uint32_t height) {
  parts_->pictures.makeTargets(width, height);
  parts_->trace.makeTargets(uint64_t(width) * height);
}

void GpuStages::warm(std::span<const std::string> stems) {
  Parts& parts = *parts_;
  parts.writeParameters({});
  GpuCommands commands(parts.programs.gpu());
  parts.programs.zero(commands, kBindBigDispatch);
  commands.barrier();
  bool cold = false;
  for (const std::string& stem : stems) cold |= parts.programs.warm(commands, stem);
  if (cold) commands.run();
  parts.writeParameters(parts.parameters);
}

void GpuStages::setParameters(const FrameParameters& parameters) {
  parts_->parameters = parameters;
  parts_->grid.setParameters(parameters.grid);
  parts_->trace.setParameters(parameters.trace);
  parts_->writeParameters(parameters);
}

void GpuStages::setInstances(std::span<const Instance> instances) { parts_->scene.setInstances(instances); }

BuildReport GpuStages::build(Builder builder, BuildTimes& times, const std::function<bool(float)>& goesOn) {
  return parts_->grid.build(builder, times, goesOn);
}
UpdateReport GpuStages::updateAll(Builder builder, BuildTimes& times) { return parts_->grid.updateAll(builder, times); }
UpdateReport GpuStages::updateMoved(std::span<const uint32_t> moved, BuildTimes& times) { return parts_->grid.updateMoved(moved, times); }
GridTotals GpuStages::countGrid() { return parts_->grid.count(); }

void GpuStages::transformAll() { parts_->scene.transformAll(); }
double GpuStages::gather() { return parts_->pictures.gather(); }
double GpuStages::bounce() { return parts_->pictures.bounce(); }
double GpuStages::trace(uint32_t firstRay, uint32_t endRay, bool counting) { return parts_->trace.trace(firstRay, endRay, counting); }
RayRecord GpuStages::record(uint32_t pixel) { return parts_->trace.record(pixel); }

double GpuStages::view(const std::string& stem, uint32_t width, uint32_t height) {
  parts_->pictures.reserveElements(uint64_t(width) * height);
  warm(std::span(&stem, 1));
  return parts_->pictures.view(stem, width, height);
}

std::vector<uint32_t> GpuStages::readGrid() { return parts_->grid.read(); }
void GpuStages::writeGrid(std::span<const uint32_t> words) { parts_->grid.write(words); }
bool GpuStages::hasGrid() const { return parts_->grid.made(); }

void GpuStages::readBytes(int binding, std::span<std::byte> bytes) const {
  downloadBytes(parts_->programs.gpu(), parts_->programs.bound().buffer(binding), bytes);
}

void GpuStages::writeBytes(int binding, std::span<const std::byte> bytes) {
  uploadBytes(parts_->programs.gpu(), parts_->programs.bound().buffer(binding), bytes);
}

void GpuStages::reserve(int binding, const std::string& name, uint64_t byteCount) {
  BoundResources& bound = parts_->programs.bound();
  if (bound.byteCount(binding) < byteCount) bound.makeBuffer(binding, name, byteCount);
}

}  // namespace gridscope
