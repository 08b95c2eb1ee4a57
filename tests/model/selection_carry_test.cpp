// Selections that are carried over to another numbering or frame size, and what the window's model does with frames and requests.
#include <gtest/gtest.h>

#include "app/frame/camera_moves.h"
#include "app/model/flow.h"
#include "app/model/selected_bounds.h"
#include "app/model/selection_carry.h"
#include "core/scene/built_in_scenes.h"
#include "tests/frame/small_frame.h"

namespace gridscope {
namespace {

NumberedScene hall(NumberBy order) { return numberScene(makeBuiltInScene("hall"), order); }

TEST(SelectionCarry, ATriangleIsFoundAgainUnderItsNewReference) {
  const NumberedScene byFile = hall(NumberBy::file), byArea = hall(NumberBy::area);
  EXPECT_TRUE(sameNumbering(byFile, hall(NumberBy::file)));
  EXPECT_FALSE(sameNumbering(byFile, byArea));
  Selection selection{.last = Selected::triangle, .slot = 3, .reference = makeReference(1, 2)};
  const Selection carried = carriedToNumbering(selection, byFile, byArea);
  ASSERT_TRUE(carried.reference);
  EXPECT_FALSE(carried.slot);
  const TriangleName was = nameTriangle(byFile, *selection.reference), is = nameTriangle(byArea, *carried.reference);
  EXPECT_EQ(was.sceneInstance, is.sceneInstance);
  EXPECT_EQ(was.mesh, is.mesh);
  EXPECT_EQ(was.triangle, is.triangle);
}

TEST(SelectionCarry, WhatIsGoneIsNoLongerSelected) {
  const NumberedScene before = hall(NumberBy::file);
  NumberedScene without = before;
  for (InstanceSource& source : without.sources) source.sceneInstance += 1000;
  const Selection carried = carriedToNumbering({.last = Selected::triangle, .reference = makeReference(0, 0)}, before, without);
  EXPECT_FALSE(carried.reference);
  EXPECT_EQ(carried.last, Selected::nothing);
  EXPECT_FALSE(carriedToNumbering({.last = Selected::triangle, .reference = makeReference(60000, 5)}, before, before).reference)
      << "of neither";
}

TEST(SelectionCarry, APixelKeepsItsPlaceInThePicture) {
  const uvec2 small(320, 180), large(640, 360);
  const Selection selection{.last = Selected::step, .pixel = 100 * 320 + 50, .step = 4};
  const Selection carried = carriedToSize(selection, small, large);
  ASSERT_TRUE(carried.pixel);
  EXPECT_EQ(*carried.pixel % 640, 101u);
  EXPECT_EQ(*carried.pixel / 640, 201u);
  EXPECT_EQ(carried.step, 0u);
  EXPECT_EQ(carriedToSize(carried, large, small).pixel, selection.pixel);
  EXPECT_EQ(*carriedToSize({.last = Selected::pixel, .pixel = 320 * 180 - 1}, small, uvec2(160, 90)).pixel, 160u * 90u - 1);
  EXPECT_FALSE(carriedToSize({.last = Selected::pixel, .pixel = 320 * 180}, small, large).pixel);
}

TEST(SelectionCarry, AnAreaKeepsItsPlaceAndAtLeastAPixel) {
  const auto area = carriedToSize(PixelArea{{100, 50}, {101, 52}}, uvec2(320, 180), uvec2(32, 18));
  ASSERT_TRUE(area);
  EXPECT_EQ(area->begin, ivec2(10, 5));
  EXPECT_EQ(area->end, ivec2(11, 6));
}

void show(WindowModel& model, const FrameSnapshot& frame) { takeFrame(model, std::make_shared<const FrameSnapshot>(frame)); }

TEST(ModelFlow, TheSelectionGoesAlongWithTheSize) {
  const SmallFrame small;
  WindowModel model;
  show(model, small.frame);
  model.selection.selectPixel(5);  // (1, 1) of 4 x 2
  FrameSnapshot larger = small.frame;
  larger.request.settings->width = 8, larger.request.settings->height = 4;
  takeFrame(model, std::make_shared<const FrameSnapshot>(larger));
  EXPECT_EQ(model.selected().pixel, 3u * 8 + 3);
}

TEST(ModelFlow, AReferenceBeyondTheSceneIsNeverRead) {
  const SmallFrame small;
  WindowModel model;
  show(model, small.frame);
  model.selection.selectTriangle(makeReference(0, 60000));
  EXPECT_TRUE(selectedBounds(model).empty());
  model.selection.selectTriangle(makeReference(9, 0));
  EXPECT_TRUE(selectedBounds(model).empty());
  model.selection.selectTriangle(makeReference(0, 1));
  EXPECT_FALSE(selectedBounds(model).empty());
}

TEST(ModelFlow, WhileAnotherSceneLoadsThereIsNothingToUndo) {
  const SmallFrame small;
  WindowModel model;
  show(model, small.frame);
  model.changeSettings([](FrameSettings& settings) { settings.grid.capacity = 5; });
  openSource(model, "other.glb");
  undoSetting(model);
  EXPECT_FALSE(model.request.settings) << "the new scene comes with its own";
}

TEST(ModelFlow, AFileThatCantBeOpenedLeavesTheTime) {
  const SmallFrame small;
  FrameSnapshot playing = small.frame;
  playing.request.timeSeconds = 2.5;
  playing.request.frame = 150;
  WindowModel model;
  show(model, playing);
  openSource(model, "nowhere.glb");
  playing.fault = "nowhere.glb: can't be read";
  takeFrame(model, std::make_shared<const FrameSnapshot>(playing));
  EXPECT_EQ(model.request.timeSeconds, 2.5);
  EXPECT_EQ(model.request.frame, 150u);
  EXPECT_TRUE(model.request.settings);
}

TEST(ModelFlow, TheUndoListEnds) {
  WindowModel model;
  for (int i = 0; i < 5000; ++i) model.rememberForUndo({});
  EXPECT_LT(model.undo.size(), 1000u);
}

}  // namespace
}  // namespace gridscope
