// The story of a pixel: its sentences name mesh, triangle, cell and step, and its parts lead to them.
#include "app/report/pixel_story.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/truth/scene.h"

namespace gridscope {
namespace {

std::vector<StoryPart> storyOf(const ToldScene& told, const CaptureNames& names, bool proven = true) {
  const TruthInput input = told.input();
  const Proof proof = proveRay(input, told.rays[0], told.hits[0], told.exact[0], told.truths[0]);
  return tellPixel({.truth = input,
                    .names = names,
                    .pixel = 0,
                    .width = 5,
                    .ray = told.rays[0],
                    .traced = told.hits[0],
                    .exact = told.exact[0],
                    .told = told.truths[0],
                    .proof = proven ? &proof : nullptr});
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
  for (const char* piece :
       {"Pixel (0, 0): voxel right, refused in cell (6, 3, 3); the surface is triangle 0 of panel.", "5 cell edges along the ray", "step 5",
        "asked to take 4 references, holds 2 and refused 2", "Its slots hold 2 of clutter.", "without that event alone, the ray agrees"})
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
  for (const char* piece :
       {"hole, gate in cell", "leaves the grid", "0 cell edges from the plane", "beyond 1.75 cell edges",
        "with these 2 events taken away, one after the other, the ray agrees: gate in cell (6, 3, 3); refused in cell (6, 3, 3)."})
    EXPECT_NE(text.find(piece), std::string::npos) << piece << "\n" << text;
}

TEST(PixelStory, EveryLinkOfALongChainIsTold) {
  // Ten full cells before the panel, each of which fills its gap.
  TruthScene scene{.scene = emptyScene(), .rays = rayBundle(), .grid = unitCells(2)};
  scene.grid.bounds = Bounds{.low = vec3(0.0f), .high = vec3(16.0f, 4.0f, 4.0f)};
  for (int x = 3; x < 13; ++x) placeMesh(scene.scene, addMesh(scene.scene, meshOf(clutterAt(float(x)))));
  placeMesh(scene.scene, addMesh(scene.scene, meshOf({panelAt(14.5f)})));
  const ToldScene told(scene);
  const Proof proof = proveRay(told.input(), told.rays[0], told.hits[0], told.exact[0], told.truths[0]);
  ASSERT_TRUE(proof.confirmed);
  ASSERT_EQ(proof.links.size(), 10u);
  const std::string text = plainText(storyOf(told, kNames));
  EXPECT_NE(text.find("with these 10 events taken away"), std::string::npos) << text;
  for (const TruthEvent& link : proof.links)
    EXPECT_NE(text.find("filled early in cell (" + std::to_string(link.cell.x)), std::string::npos) << text;
}

TEST(PixelStory, TheCaseOfACauseIsTold) {
  const std::string refused = plainText(storyOf(ToldScene(refusedScene()), kNames));
  EXPECT_NE(refused.find("the slots hold smaller ones"), std::string::npos) << refused;
  TruthScene beyond{.scene = sceneOf({panelAt(12.5f)}), .rays = rayBundle(), .grid = unitCells(2)};
  EXPECT_NE(plainText(storyOf(ToldScene(beyond), kNames)).find("The surface lies beyond the grid."), std::string::npos);
  for (Ray& ray : beyond.rays) ray.origin.x = 10.0f;
  EXPECT_NE(plainText(storyOf(ToldScene(beyond), kNames)).find("The ray never meets the grid."), std::string::npos);
  TruthScene left{.scene = sceneOf({panelAt(5.9f)}), .rays = rayBundle(), .grid = unitCells()};
  left.grid.enlargement = 0.3f;
  EXPECT_NE(plainText(storyOf(ToldScene(left), kNames)).find("The overlap test keeps it out"), std::string::npos);
  TruthScene cut{.scene = sceneOf({panelAt(5.2f)}), .rays = rayBundle(), .grid = unitCells()};
  cut.trace.back = 0.0f;
  EXPECT_NE(plainText(storyOf(ToldScene(cut), kNames)).find("The hit lies before the part of the ray"), std::string::npos);
  // Along the diagonal, 0.05 edges off the corner line: a blade in the cell that is cut between x and z.
  const vec3 direction = glm::normalize(vec3(1.0f, 0.0f, 1.0f)), middle = vec3(0.5f, 2.5f, 0.45f) + 3.57f * direction,
             across(0.011f, 0.0f, -0.011f);
  const vec3 up(0.0f, 0.3f, 0.0f);
  TruthScene edge{.scene = sceneOf({{middle - across - up, middle + across - up, middle + up}}),
                  .rays = {makeRay(vec3(0.5f, 2.4f, 0.45f), direction)}};
  EXPECT_NE(plainText(storyOf(ToldScene(edge), kNames)).find("An edge of the cell was cut."), std::string::npos);
}

TEST(PixelStory, AHitThatNoRuleMakesIsToldAsNotConfirmed) {
  TruthScene scene{.scene = sceneOf({panelAt(5.5f)}), .rays = rayBundle(), .grid = unitCells()};
  scene.tracedElsewhere = [&scene](BuiltScene&) {
    return std::vector<Hit>(scene.rays.size(), Hit{kHitMiss, 0.0f, kNoReference, 0.0f, 0.0f});
  };
  const std::string text = plainText(storyOf(ToldScene(scene), kNames));
  EXPECT_NE(text.find("Not confirmed: traced again with that rule changed, the ray does not end as the frame's hit does"),
            std::string::npos)
      << text;
}

TEST(PixelStory, AnAgreeingRayAndAPixelWithoutOneAreToldInAFewWords) {
  TruthScene scene{.scene = sceneOf({panelAt(5.5f)}), .rays = rayBundle()};
  EXPECT_NE(plainText(storyOf(ToldScene(scene), kNames, false)).find("Pixel (0, 0): agrees. "), std::string::npos);
  scene.rays[0].valid = 0u;
  EXPECT_EQ(plainText(storyOf(ToldScene(scene), kNames, false)), "Pixel (0, 0): no ray. The pixel has no ray.\n");
}

}  // namespace
}  // namespace gridscope
