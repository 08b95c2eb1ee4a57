// What every command on a scene begins with: the scene, the device, rays of one's own, the pipeline.
#pragma once

#include "app/load_rays.h"
#include "app/load_scene.h"
#include "app/options.h"
#include "app/progress.h"
#include "core/gpu_context.h"
#include "core/pipeline.h"

namespace gridscope {

class Session {
 public:
  // Loads and uploads; warnings of the scene go to standard error. Throws Error.
  Session(const Options& options, Progress& progress);

  Pipeline& pipeline() { return pipeline_; }
  const Pipeline& pipeline() const { return pipeline_; }
  const Scene& scene() const { return loaded_.scene; }
  std::string deviceName() const;                    // that runs build, update and trace
  const DeviceReport& deviceReport() const { return gpu_.report(); }
  uint32_t validationMessages() const { return gpu_.validationMessages(); }
  float frameTime(uint32_t frame) const;             // seconds

  // Gather, then the rays: the bounce's, or the person's own.
  void makeRays(uint32_t frame);

 private:
  const Options& options_;
  LoadedScene loaded_;
  LoadedRays rays_;
  GpuContext gpu_;
  Pipeline pipeline_;
};

}  // namespace gridscope
