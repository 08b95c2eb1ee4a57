// Scenes of a few triangles for tests of the truth: unit cells, a bundle of rays along +x at a panel inside one cell; and a scene taken
// through build, trace, exact hits, causes and proofs.
#pragma once

#include <functional>

#include "core/truth/ledger.h"
#include "core/truth/proof.h"
#include "tests/small_scene.h"

namespace gridscope {

// A triangle across the ray bundle at that x, inside the cell of y and z from 2 to 3.
inline Triangle panelAt(float x) { return {vec3(x, 2.1f, 2.1f), vec3(x, 2.9f, 2.1f), vec3(x, 2.5f, 2.9f)}; }

// Triangles that fill the cell at x (and y, z from 2 to 3) below the ray bundle.
inline std::vector<Triangle> clutterAt(float x, uint32_t count = 3) {
  std::vector<Triangle> triangles;
  for (uint32_t i = 0; i < count; ++i) {
    const float y = 2.05f + 0.02f * float(i);
    triangles.push_back({vec3(x + 0.4f, y, 2.4f), vec3(x + 0.6f, y, 2.4f), vec3(x + 0.5f, y, 2.6f)});
  }
  return triangles;
}

// Rays along +x from x = 0.5 through the middle of the cells of y and z from 2 to 3, leaving a surface that faces along them.
inline std::vector<Ray> rayBundle(const vec3& launchNormal = vec3(1.0f, 0.0f, 0.0f)) {
  std::vector<Ray> rays;
  for (int y = 0; y < 5; ++y)
    for (int z = 0; z < 5; ++z)
      rays.push_back(makeRay(vec3(0.5f, 2.43f + 0.03f * float(y), 2.36f + 0.03f * float(z)), vec3(1.0f, 0.0f, 0.0f), launchNormal));
  return rays;
}

// Unit cells over x 0..8, y and z 0..4.
inline GridSettings unitCells(uint32_t capacity = 8) {
  GridSettings settings;
  settings.cellEdge = 1.0f;
  settings.capacity = capacity;
  settings.bounds = Bounds{.low = vec3(0.0f), .high = vec3(8.0f, 4.0f, 4.0f)};
  return settings;
}

// What a test starts from.
struct TruthScene {
  Scene scene;
  std::vector<Ray> rays;
  GridSettings grid = unitCells();
  TraceSettings trace;
  std::function<void(BuiltScene&)> damage;                       // of the grid or the scene, before the trace
  std::function<std::vector<Hit>(BuiltScene&)> tracedElsewhere;  // replaces the trace's hits
};

// A scene all the way to its proofs.
struct ToldScene {
  BuiltScene built;
  std::vector<Ray> rays;
  TraceInput trace;
  std::vector<Hit> hits;
  Demand demand;
  ExactReference reference;
  std::vector<Hit> exact;
  std::vector<RayTruth> truths;
  TruthTotals totals;

  explicit ToldScene(const TruthScene& given)
      : built(damaged(given)),
        rays(given.rays),
        trace(built.traceInput(given.trace)),
        hits(tracedHits(given)),
        demand(built.grid.parameters, built.numbered, built.worldTriangles),
        reference(trace),
        exact(reference.trace(rays)),
        truths(tellTruth(input(), reference, rays, hits)),
        totals(countTruths(truths)) {}

  TruthInput input() const { return {trace, demand}; }
  ProofTotals proofs() const { return proveFrame(input(), {rays, hits, exact, truths}); }
  ivec3 cellAt(const vec3& point) const { return gridCell(built.grid.parameters, point); }

 private:
  static BuiltScene damaged(const TruthScene& given) {
    BuiltScene scene(given.scene, given.grid);
    if (given.damage) given.damage(scene);
    return scene;
  }
  std::vector<Hit> tracedHits(const TruthScene& given) {
    if (given.tracedElsewhere) return given.tracedElsewhere(built);
    std::vector<Hit> traced(rays.size());
    traceRays(trace, rays, traced, {});
    return traced;
  }
};

}  // namespace gridscope
