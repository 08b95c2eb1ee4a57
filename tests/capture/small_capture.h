// A capture of a few KiB with every entry there is: for tests that damage it in every way, and as a seed of the fuzzers.
#pragma once

#include "core/pipeline/frame_capture.h"
#include "tests/small_scene.h"

namespace gridscope {

// One keyed material with an alpha map of 3 x 2 texels, one static and one dynamic instance.
inline Scene smallCaptureScene() {
  Scene scene = emptyScene();
  scene.images.push_back({"leaf", 3, 2, std::vector<uint8_t>(3 * 2 * 4, 200)});
  scene.images[0].rgba[3] = 0;
  scene.materials[0].name = "leaf";
  scene.materials[0].imageIndex = 0;
  scene.materials[0].alphaMode = AlphaMode::mask;
  placeMesh(scene, addMesh(scene, meshOf({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{2, 2, 0}, {0, 2, 0}, {2, 0, 0}}})));
  placeMesh(scene, addMesh(scene, meshOf({{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}})), vec3(0.0f), true);
  return scene;
}

inline void captureProducts(const Capture& capture, BuiltScene& built, CaptureFrame& frame) {
  const size_t pixels = size_t(capture.settings.width) * capture.settings.height;
  for (size_t i = 0; i < pixels; ++i) {
    frame.gather.push_back(
        {vec3(float(i), 0, 0), vec3(0, 0, 1), vec3(0, 0, 1), vec2(0.25f), 1.5f, i == 0 ? kNoReference : makeReference(0, 1), 0});
    frame.rays.push_back(makeRay(vec3(0.3f * float(i), 0.4f, 1.9f), vec3(0.01f, 0.02f, -1.0f), vec3(0, 0, 1)));
  }
  frame.rays[0].valid = 0;
  frame.hits.resize(pixels);
  frame.counters.resize(pixels);
  traceRays({built.grid, built.numbered, built.worldTriangles, capture.trace}, frame.rays, frame.hits, frame.counters);
  frame.grid = built.grid.words;
  frame.exact = traceExactHits({built.grid, built.numbered, built.worldTriangles, capture.trace}, frame.rays);
}

// As the pipeline would capture it, on the C++ path.
inline Capture makeSmallCapture(size_t frameCount = 2) {
  const Scene scene = smallCaptureScene();
  Capture capture;
  capture.writer = "gridscope test";
  capture.device = "C++";
  capture.note = "two \"quotes\" and \xC3\xA4";
  capture.settings.grid.cells = 1;
  capture.settings.grid.capacity = 1;
  capture.settings.width = 3;
  capture.settings.height = 2;
  capture.settings.camera = {.name = "front", .eye = vec3(0.1f, 0.2f, 5.0f), .target = vec3(0.0f), .up = vec3(0, 1, 0)};
  capture.bounds = sceneBounds(scene);
  BuiltScene built(scene, capture.settings.grid);
  capture.grid = built.grid.parameters;
  capture.trace = deriveTrace(capture.settings.trace, capture.grid);
  capture.scene = built.numbered;
  capture.names = {.scene = "small", .meshes = {"wall", "leaf"}, .instances = {"node 0", "node 1"}, .materials = {"leaf"}};

  // The dynamic instance rises from frame to frame.
  for (size_t i = 0; i < frameCount; ++i) {
    CaptureFrame frame;
    frame.timeSeconds = 0.1f * float(i);
    frame.camera = deriveCamera(capture.settings.camera, 3, 2, 4.0f);
    frame.bounce = {.frame = uint32_t(i), .seed = 1, .roughness = 0.15f, .originOffset = 4e-5f};
    frame.view = {.farDistance = 4.0f, .sunDirection = vec3(0, 1, 0)};
    built.numbered.instances[1].row1.w = 1.5f * float(i);  // into the next cell
    updateAll(built.numbered, built.worldTriangles, built.grid);
    frame.rows = rowsOf(built.numbered.instances);
    captureProducts(capture, built, frame);
    capture.frames.push_back(std::move(frame));
  }
  const char png[] = "\x89PNG\r\n\x1a\n";
  for (int i = 0; i < 8; ++i) capture.preview.push_back(std::byte(png[i]));
  return capture;
}

}  // namespace gridscope
