// The story of a pixel: its sentences name mesh, triangle, cell and step, and its parts lead to them.
#include "app/pixel_story.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/truth_scene.h"

namespace gridscope {
namespace {

std::vector<StoryPart> storyOf(const ToldScene& told, const CaptureNames& names, bool proven = true) {
  const TruthInput input = told.input();
  const Proof proof = proveRay(input, told.rays[0], told.exact[0], told.truths[0]);
  return tellPixel({.truth = input, .names = names, .pixel = 0, .width = 5, .ray = told.rays[0], .traced = told.hits[0],
                    .exact = told.exact[0], .told = told.truths[0], .proof = proven ? &proof : nullptr});
}

TruthScene refusedScene() {
  TruthScene scene{.scene = emptyScene(), .rays = rayBundle(), .grid = unitCells(2)};
  placeMesh(scene.scene, addMesh(scene.scene, meshOf(clutterAt(5.0f))));
  placeMesh(scene.scene, addMesh(scene.scene, meshOf({panelAt(5.5f)})));
  return scene;
}

const CaptureNames kNames{.scene = "test", .meshes = {"clutter", "panel"}, .instances = {}, .materials = {}};

TEST(PixelStory, ARefusedSurfaceIsToldWithItsCellAndWhatHoldsTheSlots) {
  const ToldScene told(refusedScene());
  const std::string text = plainText(storyOf(told, kNames));
  for (const char* piece : {"Pixel (0, 0): voxel right, refused in cell (6, 3, 3); the surface is triangle 0 of panel.",
                            "5 cell edges along the ray", "step 5", "asked to take 4 references, holds 2 and refused 2",
                            "Its slots hold 2 of clutter.", "without that event alone, the ray agrees"})
    EXPECT_NE(text.find(piece), std::string::npos) << piece << "\n" << text;
}

TEST(PixelStory, PartsLeadToTriangleMeshCellAndStep) {
  const ToldScene told(refusedScene());
  const std::vector<StoryPart> parts = storyOf(told, kNames);
  const auto find = [&](StoryPart::Kind kind) { return std::ranges::find(parts, kind, &StoryPart::kind); };
  ASSERT_NE(find(StoryPart::Kind::triangle), parts.end());
  EXPECT_EQ(find(StoryPart::Kind::triangle)->reference, makeReference(1, 0));
  EXPECT_EQ(find(StoryPart::Kind::mesh)->reference, makeReference(1, 0));
  EXPECT_EQ(find(StoryPart::Kind::cell)->cell, told.truths[0].cell);
  EXPECT_EQ(find(StoryPart::Kind::step)->segment, 5);
}

TEST(PixelStory, AGateIsToldWithTheWayFromTheLaunchingSurfaceAndItsProofAsAChain) {
  TruthScene scene = refusedScene();
  scene.rays = rayBundle(vec3(0.0f, 1.0f, 0.0f));
  const std::string text = plainText(storyOf(ToldScene(scene), kNames));
  for (const char* piece : {"hole, gate in cell", "leaves the grid", "0 cell edges from the plane", "beyond 1.75 cell edges",
                            "one after the other, the ray agrees: gate in cell"})
    EXPECT_NE(text.find(piece), std::string::npos) << piece << "\n" << text;
}

TEST(PixelStory, AnAgreeingRayAndAPixelWithoutOneAreToldInAFewWords) {
  TruthScene scene{.scene = sceneOf({panelAt(5.5f)}), .rays = rayBundle()};
  EXPECT_NE(plainText(storyOf(ToldScene(scene), kNames, false)).find("Pixel (0, 0): agrees. "), std::string::npos);
  scene.rays[0].valid = 0u;
  EXPECT_EQ(plainText(storyOf(ToldScene(scene), kNames, false)), "Pixel (0, 0): no ray. The pixel has no ray.\n");
}

}  // namespace
}  // namespace gridscope
