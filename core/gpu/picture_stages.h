// What makes and shows pictures on the device: gather, bounce, and views.
#pragma once

#include <string>

#include "core/gpu/program.h"
#include "core/gpu/scene_buffers.h"

namespace gridscope {

class PictureStages {
 public:
  PictureStages(GpuPrograms& programs, SceneBuffers& scene);

  static PassDescription gatherPass();

  // Allocates what a frame of that size needs. Throws Error when the device's images are smaller.
  void makeTargets(uint32_t width, uint32_t height);

  // These return milliseconds of GPU time.
  double gather();
  double bounce();
  double view(const std::string& stem, uint32_t width, uint32_t height);

  // Room for the elements of a view.
  void reserveElements(uint64_t count);

 private:
  GpuPrograms& programs_;
  SceneBuffers& scene_;
  GpuImage depth_;
};

}  // namespace gridscope
