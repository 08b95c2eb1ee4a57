// What keys reach: tabs, views and rows, and under which name a scene's bookmarks are kept.
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "app/model/flow.h"
#include "views/view.h"

namespace gridscope {

namespace {

TEST(ModelKeys, TabsGoAroundAtBothEnds) {
  WindowModel model;
  model.bottomTab = BottomTab::steps;
  stepTab(model, -1);
  EXPECT_EQ(model.bottomTab, BottomTab::log);
  stepTab(model, 1);
  EXPECT_EQ(model.bottomTab, BottomTab::steps);
  stepTab(model, 1);
  EXPECT_EQ(model.bottomTab, BottomTab::cells);
}

TEST(ModelKeys, ViewsOfTheActivePaneGoAroundThroughAllOfThem) {
  WindowModel model;
  model.activePane = 1;
  const std::string first = model.panes[1].view;
  std::set<std::string> seen;
  for (size_t i = 0; i < allViews().size(); ++i) stepView(model, 1), seen.insert(model.panes[1].view);
  EXPECT_EQ(seen.size(), allViews().size());
  EXPECT_EQ(model.panes[1].view, first);
  stepView(model, 1);
  stepView(model, -1);
  EXPECT_EQ(model.panes[1].view, first);
  EXPECT_EQ(model.panes[0].view, WindowModel().panes[0].view);
}

TEST(ModelKeys, RowsStopAtTheEndsAndBeginWhereNothingIsSelected) {
  EXPECT_EQ(rowBeside(std::nullopt, 1, 5), 0u);
  EXPECT_EQ(rowBeside(std::nullopt, -1, 5), 4u);
  EXPECT_EQ(rowBeside(1, 1, 5), 2u);
  EXPECT_EQ(rowBeside(4, 1, 5), 4u);
  EXPECT_EQ(rowBeside(3, -10, 5), 0u);
  EXPECT_EQ(rowBeside(0, 1, 0), std::nullopt);
  EXPECT_EQ(rowBeside(2, 0, 5), std::nullopt);
}

TEST(ModelKeys, TimeOfACaptureOfOneFrameCannotGoOn) {
  WindowModel model;
  EXPECT_NE(whyNoTime(model), "");
  auto facts = std::make_shared<SceneFacts>();
  auto frame = std::make_shared<FrameSnapshot>();
  frame->scene = facts;
  model.frame = frame;
  EXPECT_EQ(whyNoTime(model), "");
  facts->captureFrames = 1;
  EXPECT_EQ(whyNoTime(model), "The capture holds one frame alone");
  facts->captureFrames = 8;
  EXPECT_EQ(whyNoTime(model), "");
}

TEST(ModelKeys, ASequenceIsSeenFromItsOwnCamerasUntilAPersonMovesAway) {
  WindowModel model;
  auto facts = std::make_shared<SceneFacts>();
  facts->captureFrames = 3;
  for (int i = 0; i < 3; ++i) facts->cameras.push_back({.eye = vec3(float(i), 0, 0), .target = vec3(0, 0, -1)});
  auto frame = std::make_shared<FrameSnapshot>();
  frame->scene = facts;
  model.frame = frame;
  model.camera.pose = facts->cameras[0];
  stepTime(model, 1);
  EXPECT_EQ(model.camera.pose.eye.x, 1.0f);
  stepTime(model, -2);
  EXPECT_EQ(model.request.frame, 2u);
  EXPECT_EQ(model.camera.pose.eye.x, 2.0f);
  model.camera.pose.eye.y = 5.0f;
  stepTime(model, 1);
  EXPECT_EQ(model.camera.pose.eye, vec3(2, 5, 0));
}

TEST(ModelKeys, OneFileKeepsItsBookmarksHoweverItsPathIsTyped) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("gridscope_bookmarks_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "sub");
  std::ofstream(folder / "hall.glb") << "x";
  const std::string key = bookmarkKey((folder / "hall.glb").string());
  EXPECT_EQ(bookmarkKey((folder / "sub" / ".." / "hall.glb").string()), key);
  EXPECT_EQ(bookmarkKey(std::filesystem::relative(folder / "hall.glb").string()), key);
  EXPECT_EQ(bookmarkKey("hall"), "hall");
  std::filesystem::remove_all(folder);
}

}  // namespace

}  // namespace gridscope
