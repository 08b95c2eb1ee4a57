// What every command on a scene begins with: the scene or the capture, the device, rays of one's own, the pipeline.
#pragma once

#include "app/base/progress.h"
#include "app/session/load_rays.h"
#include "app/session/load_scene.h"
#include "app/session/options.h"
#include "core/capture/capture.h"
#include "core/gpu/context.h"
#include "core/pipeline/pipeline.h"

namespace gridscope {

class Session {
 public:
  // Loads and uploads; warnings of the scene go to standard error. Throws Error.
  Session(const Options& options, Progress& progress);

  Pipeline& pipeline() { return pipeline_; }
  const Pipeline& pipeline() const { return pipeline_; }
  const Scene& scene() const { return loaded_.scene; }  // of a capture: its name, materials and warnings alone
  GpuContext& gpu() { return gpu_; }
  const Capture* capture() const { return capture_ ? &*capture_ : nullptr; }  // nullptr: runs on a scene
  CaptureNames names() const;
  Bounds bounds() const;           // that the grid is made for
  std::string builtBy() const;     // the other program that built a capture's grid; empty: this one builds it
  std::string deviceName() const;  // that runs build, update and trace
  const DeviceReport& deviceReport() const { return gpu_.report(); }
  uint32_t validationMessages() const { return gpu_.validationMessages(); }
  float frameTime(uint32_t frame) const;  // seconds
  uint32_t frameCount() const;            // of a capture's sequence; without a capture 1

  // The grid: a capture's own where it holds one.
  void build();
  void update(uint32_t frame);

  // Build and update from the instances, whatever grid a capture holds. Throws Error for a foreign grid, as mustRebuild() does beforehand.
  void rebuild(uint32_t frame);
  void mustRebuild() const;
  bool canRebuild() const;  // false: the grid is another program's

  // Gather, then the rays: the bounce's, the capture's, or the person's own.
  void makeRays(uint32_t frame);

  // After a trace: the hits that a captured frame holds take the place of the trace's, for they are what is judged. Returns how many of them
  // are not what the trace ended with (another engine's, say); nothing where no hits were captured.
  std::optional<uint64_t> useCapturedHits(uint32_t frame);
  bool hasCapturedHits(uint32_t frame) const { return capture_ && !capturedFrame(frame).hits.empty(); }

 private:
  const CaptureFrame& capturedFrame(uint32_t frame) const { return capture_->frames[frame % capture_->frames.size()]; }

  const Options& options_;
  std::optional<Capture> capture_;
  LoadedScene loaded_;
  LoadedRays rays_;
  GpuContext gpu_;
  Pipeline pipeline_;
};

// "12 of the capture's hits are not what this trace ends with; they are taken as they are".
std::string foreignHitsText(uint64_t count);

}  // namespace gridscope
