// Between a pipeline and a capture: its present products into a frame, and a captured frame's inputs back into what a pipeline takes.
#pragma once

#include <vector>

#include "core/capture/capture.h"
#include "core/pipeline/pipeline.h"

namespace gridscope {

// What a person calls the scene's things.
CaptureNames namesOf(const Scene& scene);

// A capture of what the pipeline runs on, without frames. `bounds`: the scene's over its whole animation.
Capture startCapture(const Pipeline& pipeline, CaptureNames names, const Bounds& bounds);

// The pipeline's present frame: its instances, and the chosen products, which its stages must have made.
CaptureFrame takeFrame(Pipeline& pipeline, const CaptureProducts& products, float timeSeconds);

// The product `exact` of rays: C++ on every machine, so that its bits are the same on all. Of `input`'s grid only the parameters are used.
std::vector<ExactHit> traceExactHits(const TraceInput& input, std::span<const Ray> rays);

// A captured frame for the pipeline that runs without a scene.
PipelineInputs pipelineInputs(const Capture& capture, size_t frame);

// After a trace: captured hits take the place of the pipeline's, for they are what is looked into. Returns how many of them are not what the trace ended
// with (another engine's, say).
uint64_t useCapturedHits(Pipeline& pipeline, const std::vector<Hit>& captured);

// All instances with the frame's transforms, as an update takes them.
std::vector<Instance> frameInstances(const Capture& capture, size_t frame);

// Made by this program: its grid is what the build makes of the scene. Another engine's grid is its own; build and update do not apply.
bool builtHere(const Capture& capture);

// Surfaces showed diffuse maps, which a capture does not hold: it shows them in their base colour.
bool lacksDiffuseMaps(const Capture& capture);

// The part of a capture's `writer` that says so.
inline constexpr const char* kWriterName = "gridscope ";

}  // namespace gridscope
