// The short story of a pixel: what its ray should have shown, what kept it from that, how it ended.
#include "app/report/pixel_brief.h"

#include <gtest/gtest.h>

#include "tests/truth/scene.h"

namespace gridscope {
namespace {

const CaptureNames kNames{.scene = "test", .meshes = {"clutter", "panel"}, .instances = {}, .materials = {}};

std::string briefOf(const ToldScene& told) {
  const TruthInput input = told.input();
  return plainText(tellBriefly({.truth = input,
                                .names = kNames,
                                .pixel = 0,
                                .width = 5,
                                .ray = told.rays[0],
                                .traced = told.hits[0],
                                .exact = told.exact[0],
                                .told = told.truths[0]}));
}

TruthScene refusedScene() {
  TruthScene scene{.scene = emptyScene(), .rays = rayBundle(), .grid = unitCells(2)};
  placeMesh(scene.scene, addMesh(scene.scene, meshOf(clutterAt(5.0f))));
  placeMesh(scene.scene, addMesh(scene.scene, meshOf({panelAt(5.5f)})));
  return scene;
}

TEST(PixelBrief, ARefusedSurfaceTakesThreeSentences) {
  EXPECT_EQ(briefOf(ToldScene(refusedScene())),
            "The reflection should show panel, triangle 0. That triangle was refused by cell (6, 3, 3): 4 references tried, 2 stored. "
            "Step 5 filled the gap 0.50 cells behind the surface.");
}

TEST(PixelBrief, AClosedGateIsToldWithBothDistances) {
  TruthScene scene = refusedScene();
  scene.rays = rayBundle(vec3(0.0f, 1.0f, 0.0f));
  const std::string text = briefOf(ToldScene(scene));
  EXPECT_NE(text.find("Its gap was not filled: the ray was only 0.00 cells from the surface that it left, and the gate is 1.75 cells."),
            std::string::npos)
      << text;
  EXPECT_TRUE(text.ends_with("The ray met nothing and left the grid.")) << text;
}

TEST(PixelBrief, AnAgreeingRayAndAPixelWithoutOneTakeOne) {
  TruthScene scene{.scene = sceneOf({panelAt(5.5f)}), .rays = rayBundle()};
  EXPECT_TRUE(briefOf(ToldScene(scene)).ends_with(", triangle 0, as it should."));
  scene.rays[0].valid = 0u;
  EXPECT_EQ(briefOf(ToldScene(scene)), "The pixel has no ray.");
}

TEST(PixelBrief, EveryCauseHasWordsForItsProof) {
  for (uint32_t cause = 0; cause < kCauseCount; ++cause) EXPECT_TRUE(std::string(proofWords(cause)).starts_with("With"));
}

}  // namespace
}  // namespace gridscope
