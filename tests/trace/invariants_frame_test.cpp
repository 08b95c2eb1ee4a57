// The one list of what must hold of a frame: complete, and of another program's grid only what every grid must keep to.
#include "core/trace/invariants_frame.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/grid_words.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

struct Crowd {
  BuiltScene built;
  Demand demand;
  Crowd() : built(crowdedScene(), {.cells = 6, .capacity = 8}), demand(built.grid.parameters, built.numbered, built.worldTriangles) {}
  static Scene crowdedScene() {
    Scene scene = emptyScene();
    placeMesh(scene, addMesh(scene, meshOf(randomTriangles(100, 1.0f, 0.4f, 7))));
    placeMesh(scene, addMesh(scene, meshOf(randomTriangles(40, 1.0f, 0.4f, 8))), vec3(0.0f), true);
    return scene;
  }
  std::vector<Invariant> test(const std::string& builtBy = "") const {
    return testGrid({.grid = built.grid, .scene = built.numbered, .demand = &demand, .tried = demand.total(), .builtBy = builtBy});
  }
};

const Invariant& one(const std::vector<Invariant>& invariants, const std::string& key) {
  return *std::ranges::find(invariants, key, &Invariant::key);
}

TEST(FrameInvariants, AllHoldOfAGridThatWasBuiltHere) {
  const std::vector<Invariant> invariants = Crowd().test();
  EXPECT_EQ(faultsOf(invariants), std::vector<std::string>{});
  for (const char* key : {"noBlankBefore", "staticFirst", "noDuplicate", "inRange", "refusedWhenFull", "sum", "nothingStale", "placed"})
    EXPECT_EQ(one(invariants, key).whyNot, "") << key;
}

TEST(FrameInvariants, ATriangleWhereItDoesNotBelongIsSaidUnlessAnotherProgramPutItThere) {
  Crowd crowd;
  // Two cells change their contents: each still looks sound by itself.
  std::vector<ivec3> cells;
  forEachCell(crowd.built.grid.parameters, [&](const ivec3& cell) {
    if (!storedReferences(crowd.built.grid, cell).empty()) cells.push_back(cell);
  });
  const ivec3 a = cells.front(), b = cells.back();
  ASSERT_NE(storedReferences(crowd.built.grid, a), storedReferences(crowd.built.grid, b));
  for (int texel = 0; texel < crowd.built.grid.parameters.stride; ++texel)
    std::swap(slotAt(crowd.built.grid, a, texel), slotAt(crowd.built.grid, b, texel));
  const std::vector<Invariant> invariants = crowd.test();
  EXPECT_NE(one(invariants, "placed").fault.find("(" + std::to_string(a.x) + ", " + std::to_string(a.y) + ", " + std::to_string(a.z) + ")"),
            std::string::npos)
      << one(invariants, "placed").fault;

  const std::vector<Invariant> foreign = crowd.test("engine 7");
  EXPECT_EQ(faultsOf(foreign), std::vector<std::string>{});
  for (const char* key : {"placed", "nothingStale", "staticFirst"})
    EXPECT_NE(one(foreign, key).whyNot.find("engine 7"), std::string::npos) << key;
}

TEST(FrameInvariants, HitsAreTestedTooCapturedOnesAlike) {
  const Crowd crowd;
  const TraceInput input = crowd.built.traceInput({});
  const std::vector<Ray> rays = {makeRay(vec3(0.0f), vec3(1, 0, 0))};
  EXPECT_EQ(
      faultsOf(testFrameHits(crowd.built.numbered, input.parameters, rays, std::vector{Hit{kHitMiss, 0.0f, kNoReference, 0.0f, 0.0f}}))
          .size(),
      0u);
  const std::vector<std::string> faults =
      faultsOf(testFrameHits(crowd.built.numbered, input.parameters, rays, std::vector{Hit{kHitTriangle, 1.0f, 99u << 16, 0.0f, 0.0f}}));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults.front().find("ray 0"), std::string::npos);
}

}  // namespace
}  // namespace gridscope
