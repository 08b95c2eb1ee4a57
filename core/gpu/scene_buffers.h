// A scene on the device: triangles, corners, instances, materials, alpha maps, and the diffuse maps as layers of one array image; and the pass
// that brings its triangles into the world.
#pragma once

#include <span>

#include "core/gpu/program.h"
#include "core/grid/build.h"
#include "core/scene/numbering.h"
#include "core/scene/scene.h"

namespace gridscope {

class SceneBuffers {
 public:
  // textureSize: texels of a diffuse map's side. `numbered` must outlive the buffers; its instances may change (setInstances).
  SceneBuffers(GpuPrograms& programs, std::span<const Image> images, const NumberedScene& numbered, uint32_t textureSize);

  const NumberedScene& numbered() const { return numbered_; }
  InstanceRange staticInstances() const { return {0, numbered_.staticInstanceCount}; }
  InstanceRange dynamicInstances() const { return {numbered_.staticInstanceCount, numbered_.instanceCount()}; }

  void setInstances(std::span<const Instance> instances);
  void setMoved(std::span<const uint32_t> moved);  // numbers of the instances that passes take with kTakeMoved

  // Push constants of a pass over the instances of a range; take: kTake...
  PassArguments argumentsFor(InstanceRange range, uint32_t take) const;
  // Records the writing of their world triangles.
  void transform(GpuCommands& commands, InstanceRange range, uint32_t take);
  // Records a draw for each instance: of its world triangles, or of its object triangles.
  void drawInstances(GpuCommands& commands, InstanceRange range, bool world);
  void transformAll();

 private:
  void upload(const NumberedScene& numbered);
  void uploadImages(std::span<const Image> images, uint32_t textureSize);

  GpuPrograms& programs_;
  const NumberedScene& numbered_;
};

}  // namespace gridscope
