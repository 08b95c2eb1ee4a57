// Which stages a change of the request feeds, edits of instances, the steps that keys go to, and what is kept between runs.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "app/frame/changes.h"
#include "app/frame/scene_edits.h"
#include "app/model/flow.h"
#include "app/model/preferences.h"
#include "core/scene/built_in_scenes.h"

namespace gridscope {
namespace {

FrameRequest plainRequest() {
  FrameRequest request;
  request.settings = FrameSettings{};
  return request;
}

TEST(FrameChanges, NothingChangesBetweenEqualRequests) { EXPECT_FALSE(changesBetween(plainRequest(), plainRequest()).any()); }

TEST(FrameChanges, ATraceSettingRunsTheTraceAlone) {
  FrameRequest after = plainRequest();
  after.settings->trace.ahead = 0.5f;
  const FrameChanges changes = changesBetween(plainRequest(), after);
  EXPECT_EQ(changes, (FrameChanges{.trace = true}));
}

TEST(FrameChanges, ACapacityBuildsAndTracesButKeepsTheRays) {
  FrameRequest after = plainRequest();
  after.settings->grid.capacity = 7;
  EXPECT_EQ(changesBetween(plainRequest(), after), (FrameChanges{.grid = true, .build = true, .update = true, .trace = true}));
}

TEST(FrameChanges, ACameraGathersAndTracesButKeepsTheGrid) {
  FrameRequest after = plainRequest();
  after.settings->camera.eye.x = 3.0f;
  EXPECT_EQ(changesBetween(plainRequest(), after), (FrameChanges{.gather = true, .bounce = true, .trace = true}));
}

TEST(FrameChanges, AnOffsetMovesWithoutANewNumbering) {
  FrameRequest before = plainRequest(), after = plainRequest();
  before.edits = after.edits = {{.sceneInstance = 1, .kind = InstanceEdit::Kind::makeDynamic}};
  after.edits[0].offset = vec3(1, 0, 0);
  const FrameChanges changes = changesBetween(before, after);
  EXPECT_FALSE(changes.scene);
  EXPECT_TRUE(changes.update && changes.gather && changes.trace);
}

TEST(SceneEdits, WhatIsHiddenIsNotNumbered) {
  const Scene scene = makeBuiltInScene("hall");
  const InstanceEdit edit{.sceneInstance = 0, .kind = InstanceEdit::Kind::hide};
  Scene edited = scene;
  applyEdits(edited, scene.instances, std::span(&edit, 1));
  EXPECT_EQ(edited.instances.size(), scene.instances.size());
  const NumberedScene numbered = numberScene(edited, NumberBy::file);
  for (const InstanceSource& source : numbered.sources) EXPECT_NE(source.sceneInstance, 0u);
}

TEST(SceneEdits, WhatIsMadeDynamicMovesByItsOffsetInTheWorld) {
  const Scene scene = makeBuiltInScene("hall");
  const InstanceEdit edit{.sceneInstance = 0, .kind = InstanceEdit::Kind::makeDynamic, .offset = vec3(0.0f, 2.0f, 0.0f)};
  Scene edited = scene;
  applyEdits(edited, scene.instances, std::span(&edit, 1));
  const mat4 before = nodeTransforms(scene, 0.0f)[scene.instances[0].node] * scene.instances[0].local;
  const mat4 after = nodeTransforms(edited, 0.0f)[edited.instances[0].node] * edited.instances[0].local;
  EXPECT_TRUE(edited.instances[0].dynamic);
  EXPECT_NEAR(after[3].y, before[3].y + 2.0f, 1e-4f);
}

TEST(SceneEdits, TakenBackTheyLeaveTheInstancesAsLoaded) {
  const Scene scene = makeBuiltInScene("hall");
  const std::vector<InstanceEdit> edits = {{.sceneInstance = 0, .kind = InstanceEdit::Kind::hide},
                                           {.sceneInstance = 1, .kind = InstanceEdit::Kind::makeDynamic, .offset = vec3(1.0f)}};
  Scene edited = scene;
  applyEdits(edited, scene.instances, edits);
  const size_t meshes = edited.meshes.size();
  applyEdits(edited, scene.instances, edits);
  EXPECT_EQ(edited.meshes.size(), meshes) << "one empty mesh is enough";
  applyEdits(edited, scene.instances, {});
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    EXPECT_EQ(edited.instances[i].mesh, scene.instances[i].mesh);
    EXPECT_EQ(edited.instances[i].local, scene.instances[i].local);
    EXPECT_EQ(edited.instances[i].dynamic, scene.instances[i].dynamic);
  }
}

TEST(SceneEdits, ThoseOfInstancesThatAreGoneAreLeftOut) {
  const std::vector<InstanceEdit> edits = {{.sceneInstance = 7}, {.sceneInstance = 2}, {.sceneInstance = 3}};
  EXPECT_EQ(editsWithin(edits, 3), (std::vector<InstanceEdit>{{.sceneInstance = 2}}));
}

TEST(ModelFlow, UndoTakesBackTheLastSetting) {
  WindowModel model;
  model.request.settings = FrameSettings{};
  model.changeSettings([](FrameSettings& settings) { settings.grid.capacity = 5; });
  EXPECT_EQ(model.request.settings->grid.capacity, 5u);
  undoSetting(model);
  EXPECT_EQ(model.request.settings->grid.capacity, FrameSettings{}.grid.capacity);
}

TEST(Preferences, AreWrittenWhileTheProgramRunsOnceTheyChanged) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "gridscope_keeper_test" / "window.json";
  WindowModel model;
  PreferenceKeeper keeper(model, file);
  model.now = 10.0;
  keeper.look(model);
  EXPECT_FALSE(std::filesystem::exists(file)) << "nothing changed";
  model.splits.left = 222.0f;
  model.now = 11.0;
  keeper.look(model);
  EXPECT_FALSE(std::filesystem::exists(file)) << "a splitter may still be dragged";
  model.now = 14.0;
  keeper.look(model);
  WindowModel read;
  readPreferences(read, file);
  EXPECT_EQ(read.splits.left, 222.0f);
  std::filesystem::remove_all(file.parent_path());
}

TEST(Preferences, ComeBackAsTheyWereWritten) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "gridscope_preferences_test" / "window.json";
  WindowModel model;
  model.splits.left = 321.0f;
  model.theme = Theme::light;
  model.recentFiles = {"a.glb"};
  model.savedBookmarks["hall"].push_back({"door", {.name = "door", .eye = vec3(1, 2, 3)}});
  writePreferences(preferencesText(model), file);
  WindowModel read;
  readPreferences(read, file);
  EXPECT_EQ(read.splits.left, 321.0f);
  EXPECT_EQ(read.theme, Theme::light);
  EXPECT_EQ(read.recentFiles, model.recentFiles);
  ASSERT_EQ(read.savedBookmarks["hall"].size(), 1u);
  EXPECT_EQ(read.savedBookmarks["hall"][0].pose.eye, vec3(1, 2, 3));

  // A damaged file changes nothing that it can't say.
  std::ofstream(file) << "{\"left\": \"wide\"";
  WindowModel damaged;
  readPreferences(damaged, file);
  EXPECT_EQ(damaged.splits.left, Splits{}.left);
  std::filesystem::remove_all(file.parent_path());
}

}  // namespace
}  // namespace gridscope
