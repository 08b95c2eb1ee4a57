// A snapshot of a small scene, with hits made up, for tests of what the window makes of snapshots.
#pragma once

#include <memory>

#include "app/frame/snapshot.h"
#include "tests/small_scene.h"

namespace gridscope {

// Cells of edge 1 from (0, 0, 0), capacity 2: the cell (1, 1, 1) is asked to take 3 triangles of the floor, its neighbour 1 of the post.
struct SmallFrame {
  BuiltScene built;
  FrameSnapshot frame;

  SmallFrame() : built(scene(), settings()) {
    auto facts = std::make_shared<SceneFacts>();
    facts->name = "small";
    facts->names = {.scene = "small", .meshes = {"floor", "post"}, .instances = {"the floor", "the post"}, .materials = {"grey"}};
    facts->meshOfInstance = {"floor", "post"};
    facts->numbered = built.numbered;
    frame.scene = facts;
    frame.number = 1;
    frame.parameters.grid = built.grid.parameters;
    frame.grid = std::make_shared<const Grid>(built.grid);
    frame.worldTriangles = std::make_shared<const std::vector<Triangle>>(built.worldTriangles);
    frame.instances = std::make_shared<const std::vector<Instance>>(built.numbered.instances);
    FrameSettings wanted{.grid = settings(), .width = 4, .height = 2};
    frame.request.settings = wanted;
    frame.hits = std::make_shared<const std::vector<Hit>>(hits());
    frame.counters = std::make_shared<const std::vector<RayCounters>>(
        std::vector<RayCounters>{{0, 0}, {1, 10}, {2, 20}, {3, 30}, {4, 40}, {5, 50}, {6, 60}, {7, 70}});
  }

  // Adds the truth: pixel 3 is a hole, stepped over; 4 a voxel hit that is wrong, refused; 6 another hole, refused; the others agree.
  void tellTruth() {
    std::vector<RayTruth> truths(8);
    for (uint32_t pixel = 0; pixel < 8; ++pixel)
      truths[pixel] = {.verdict = pixel == 0 ? kVerdictNoRay : kVerdictAgrees,
                       .cause = kCauseNone,
                       .exactReference = kNoReference,
                       .cell = ivec3(-1),
                       .reference = kNoReference,
                       .segment = -1};
    truths[3].verdict = truths[6].verdict = kVerdictHole;
    truths[4].verdict = kVerdictVoxelWrong;
    truths[3].cause = kCauseSteppedOver;
    truths[4].cause = truths[6].cause = kCauseRefused;
    frame.truths = std::make_shared<const std::vector<RayTruth>>(truths);
  }

 private:
  static Scene scene() {
    Scene scene = emptyScene();
    const auto flat = [](float height) { return Triangle{{1.2f, height, 1.2f}, {1.8f, height, 1.2f}, {1.2f, height, 1.8f}}; };
    placeMesh(scene, addMesh(scene, meshOf({flat(1.4f), flat(1.5f), flat(1.6f)})));
    placeMesh(scene, addMesh(scene, meshOf({{{2.5f, 1.3f, 1.4f}, {2.5f, 1.6f, 1.4f}, {2.5f, 1.3f, 1.6f}}})));
    return scene;
  }
  static GridSettings settings() {
    GridSettings settings{.cellEdge = 1.0f, .capacity = 2, .overlap = kOverlapExact, .enlargement = 1.0f};
    settings.bounds = Bounds{vec3(1.0f), vec3(3.0f)};
    return settings;
  }
  // Kinds by pixel: no ray, triangle, triangle, miss, voxel, triangle, miss, triangle.
  static std::vector<Hit> hits() {
    std::vector<Hit> hits(8);
    const uint32_t kinds[8] = {kHitNoRay, kHitTriangle, kHitTriangle, kHitMiss, kHitVoxel, kHitTriangle, kHitMiss, kHitTriangle};
    for (uint32_t pixel = 0; pixel < 8; ++pixel) {
      const bool hit = kinds[pixel] == kHitTriangle || kinds[pixel] == kHitVoxel;
      hits[pixel] = {.kind = kinds[pixel], .t = hit ? 8.0f - float(pixel) : 0.0f, .reference = hit ? makeReference(0, 0) : kNoReference};
    }
    return hits;
  }
};

}  // namespace gridscope
