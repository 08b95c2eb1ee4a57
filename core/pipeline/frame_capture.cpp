// See frame_capture.h.
#include "core/pipeline/frame_capture.h"

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/trace/exact.h"

namespace gridscope {

CaptureNames namesOf(const Scene& scene) {
  CaptureNames names{.scene = scene.name, .meshes = {}, .instances = {}, .materials = {}};
  for (const Mesh& mesh : scene.meshes) names.meshes.push_back(mesh.name);
  for (const SceneInstance& instance : scene.instances) names.instances.push_back(instance.name);
  for (const Material& material : scene.materials) names.materials.push_back(material.name);
  return names;
}

Capture startCapture(const Pipeline& pipeline, CaptureNames names, const Bounds& bounds) {
  Capture capture;
  capture.settings = pipeline.settings();
  capture.grid = pipeline.parameters().grid;
  capture.trace = pipeline.parameters().trace;
  capture.bounds = bounds;
  capture.scene = pipeline.numbered();
  capture.names = std::move(names);
  return capture;
}

CaptureFrame takeFrame(Pipeline& pipeline, const CaptureProducts& products, float timeSeconds) {
  const FrameParameters& parameters = pipeline.parameters();
  CaptureFrame frame{.timeSeconds = timeSeconds, .camera = parameters.camera, .bounce = parameters.bounce, .view = parameters.view};
  frame.rows = rowsOf(pipeline.numbered().instances);

  // What the last view left there is no part of the frame.
  frame.view.width = parameters.camera.width;
  frame.view.height = parameters.camera.height;
  if (products.grid) frame.grid = pipeline.grid().words;
  if (products.gather) frame.gather = pipeline.gatherPixels();
  if (products.rays) frame.rays = pipeline.rays();
  if (products.hits) frame.hits = pipeline.hits();
  if (products.counters) frame.counters = pipeline.counters();
  if (products.exact) {
    const Grid shape{parameters.grid, {}};
    const std::vector<Triangle> triangles = pipeline.worldTriangles();
    frame.exact = traceExactHits({shape, pipeline.numbered(), triangles, parameters.trace}, pipeline.rays());
  }
  return frame;
}

std::vector<ExactHit> traceExactHits(const TraceInput& input, std::span<const Ray> rays) {
  std::vector<ExactHit> exact;
  exact.reserve(rays.size());
  for (const Hit& hit : ExactReference(input).trace(rays))
    exact.push_back(hit.kind == kHitTriangle ? ExactHit{hit.t, hit.reference} : ExactHit{0.0f, kNoReference});
  return exact;
}

PipelineInputs pipelineInputs(const Capture& capture, size_t frame) {
  PipelineInputs inputs{.name = capture.names.scene,
                        .numbered = frameScene(capture, frame),
                        .settings = capture.settings,
                        .parameters = frameParameters(capture, frame),
                        .bounds = capture.bounds};

  // Diffuse maps are not in the capture: surfaces show their base colour.
  for (TraceMaterial& material : inputs.numbered.materials) material.layer = kNoLayer;
  return inputs;
}

uint64_t useCapturedHits(Pipeline& pipeline, const std::vector<Hit>& captured) {
  const std::vector<Hit> traced = pipeline.hits();
  CHECK_EQ(traced.size(), captured.size());
  uint64_t different = 0;
  for (size_t i = 0; i < traced.size(); ++i) different += std::memcmp(&traced[i], &captured[i], sizeof(Hit)) != 0 ? 1 : 0;
  pipeline.useHits(captured);
  return different;
}

std::vector<Instance> frameInstances(const Capture& capture, size_t frame) {
  std::vector<Instance> instances = capture.scene.instances;
  const std::vector<InstanceRows>& rows = capture.frames[frame].rows;
  CHECK_EQ(rows.size(), instances.size());
  for (size_t i = 0; i < instances.size(); ++i)
    instances[i].row0 = rows[i].row0, instances[i].row1 = rows[i].row1, instances[i].row2 = rows[i].row2;
  return instances;
}

bool builtHere(const Capture& capture) { return gridAbilities(capture.grid).built && capture.writer.starts_with(kWriterName); }

bool lacksDiffuseMaps(const Capture& capture) {
  return std::ranges::any_of(capture.scene.materials, [](const TraceMaterial& material) { return material.layer != kNoLayer; });
}

}  // namespace gridscope
