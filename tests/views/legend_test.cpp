// Legends: size at every width, ticks, and the words of each kind of view.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "shaders/shared/views/palette.h"
#include "views/fonts.h"
#include "views/legend.h"

namespace gridscope {
namespace {

const std::vector<std::string> kLines{"sponza.glb \u00b7 128 \u00d7 54 \u00d7 79 cells, capacity 32",
                                      "refused first: late meshes (highest ids), then dynamic ones"};

Legend legendOf(const View& view) { return {.view = &view, .range = {0.0f, 32.0f}, .note = {}, .lines = kLines}; }

uint32_t pixelAt(const Picture& picture, uint32_t x, uint32_t y) {
  const uint8_t* pixel = &picture.rgba[4 * (size_t{y} * picture.width + x)];
  return static_cast<uint32_t>(pixel[0]) << 16 | static_cast<uint32_t>(pixel[1]) << 8 | pixel[2];
}

std::set<uint32_t> coloursOf(const Picture& picture) {
  std::set<uint32_t> colours;
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x) colours.insert(pixelAt(picture, x, y));
  return colours;
}

TEST(Legend, HasThePicturesWidthAndNothingIsCutAtAnyWidth) {
  for (const View& view : allViews())
    for (uint32_t width : {1u, 24u, 160u, 320u, 640u, 839u, 840u, 1920u}) {
      Picture strip = drawLegend(legendOf(view), width);
      ASSERT_EQ(strip.width, width);
      ASSERT_EQ(strip.rgba.size(), size_t{4} * strip.width * strip.height);

      // The margins are empty on every side; row 0 is the line on top.
      if (width < 160) continue;
      for (uint32_t y = 1; y < strip.height; ++y)
        for (uint32_t x : {0u, 8u, width - 8u, width - 1u})
          ASSERT_EQ(pixelAt(strip, x, y), kColourPanel) << view.name << " at width " << width << ", pixel " << x << ", " << y;
      for (uint32_t x = 0; x < width; ++x)
        ASSERT_EQ(pixelAt(strip, x, strip.height - 2), kColourPanel) << view.name << " at width " << width;
    }
}

TEST(Legend, GrowsDownwardsWhereItIsNarrow) {
  const View& view = *findView("occupancy");
  EXPECT_GT(drawLegend(legendOf(view), 320).height, drawLegend(legendOf(view), 1920).height);
  EXPECT_LT(drawLegend(legendOf(view), 1920).height, 80u);
  EXPECT_LT(drawLegend(legendOf(view), 320).height, 180u);
}

TEST(Legend, ShowsTheMapsEndsAndForSaturatedCellsHatchedPink) {
  std::set<uint32_t> colours = coloursOf(drawLegend(legendOf(*findView("slice")), 640));
  EXPECT_TRUE(colours.contains(kColourSaturated));
  EXPECT_TRUE(colours.contains(0x78375Cu)) << "the hatch's dark lines";
  EXPECT_FALSE(coloursOf(drawLegend(legendOf(*findView("visits")), 640)).contains(kColourSaturated));
}

TEST(Legend, ShowsASwatchForEachKindOfHit) {
  std::set<uint32_t> colours = coloursOf(drawLegend(legendOf(*findView("hit-kind")), 320));
  EXPECT_TRUE(colours.contains(kColourTriangleHit));
  EXPECT_TRUE(colours.contains(kColourVoxelHit));
  EXPECT_TRUE(colours.contains(kColourMiss));
}

TEST(Legend, KnowsAMeaningForEveryMarkOfEveryView) {
  for (const View& view : allViews()) {
    size_t marks = view.marks.empty() ? 0 : 1 + static_cast<size_t>(std::count(view.marks.begin(), view.marks.end(), ','));
    EXPECT_EQ(viewMeanings(view).size(), marks) << view.name;
  }
}

TEST(Legend, IsTallerWithMoreLinesAndSurvivesWordsWithoutSpaces) {
  const View& view = *findView("final");
  Legend legend = legendOf(view);
  uint32_t before = drawLegend(legend, 320).height;
  legend.lines.push_back(std::string(500, 'W'));
  EXPECT_EQ(drawLegend(legend, 320).height, before + 18u);
  legend.lines.push_back("\xFF\xC3 damaged \xE2\x80");
  EXPECT_GT(drawLegend(legend, 320).height, before + 18u);
}

TEST(Legend, SetBelowKeepsThePictureAndGrowsIt) {
  Picture picture = makePicture(320, 20, 0x123456);
  Picture strip = drawLegend(legendOf(*findView("depth")), 320);
  Picture both = setBelow(picture, strip);
  EXPECT_EQ(both.height, picture.height + strip.height);
  EXPECT_TRUE(std::equal(picture.rgba.begin(), picture.rgba.end(), both.rgba.begin()));
}

TEST(Legend, TicksHaveBothEndsAndWholeStepsBetween) {
  EXPECT_EQ(tickValues(0.0f, 32.0f, 6), (std::vector<float>{0, 8, 16, 24, 32}));
  EXPECT_EQ(tickValues(0.0f, 40.0f, 6), (std::vector<float>{0, 10, 20, 30, 40}));
  EXPECT_EQ(tickValues(0.0f, 47.0f, 6), (std::vector<float>{0, 10, 20, 30, 40, 47}));
  EXPECT_EQ(tickValues(5.0f, 5.0f, 6), (std::vector<float>{5}));
  EXPECT_EQ(tickValues(0.0f, INFINITY, 6), (std::vector<float>{0}));
  for (float high : {1e-6f, 0.37f, 1.0f, 3.0f, 999.0f, 150000.0f, 1e12f})
    for (int most : {1, 2, 3, 6, 20}) {
      std::vector<float> values = tickValues(0.0f, high, most);
      EXPECT_LE(static_cast<int>(values.size()), std::max(most, 2)) << high;
      EXPECT_EQ(values.front(), 0.0f);
      EXPECT_EQ(values.back(), high);
      EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    }
}

TEST(Legend, NumbersHaveCommasAndOnlyTheDecimalsTheyNeed) {
  EXPECT_EQ(tickText(0.0f, 10.0f), "0");
  EXPECT_EQ(tickText(150000.0f, 50000.0f), "150,000");
  EXPECT_EQ(tickText(-1234567.0f, 1.0f), "-1,234,567");
  EXPECT_EQ(tickText(0.2f, 0.2f), "0.2");
  EXPECT_EQ(tickText(0.25f, 0.05f), "0.25");
  EXPECT_EQ(tickText(23.7f, 5.0f), "23.7");
  EXPECT_EQ(tickText(123.0f, 5.0f), "123");
}

TEST(Text, IsWiderWhenLongerAndShortenedToFit) {
  TextStyle style{.font = Font::sans, .size = 13.0f, .colour = kColourText};
  EXPECT_EQ(textWidth("", style), 0.0f);
  EXPECT_GT(textWidth("cells and slots", style), textWidth("cells", style));
  std::string shorter = shortenText("references refused by the cell", 80.0f, style);
  EXPECT_LE(textWidth(shorter, style), 80.0f);
  EXPECT_TRUE(shorter.ends_with("\u2026"));
  EXPECT_EQ(shortenText("cells", 80.0f, style), "cells");
  EXPECT_EQ(shortenText("cells", 2.0f, style), "");
}

TEST(Text, ADrawnLetterIsCrispAndStaysInsideThePicture) {
  TextStyle style{.font = Font::mono, .size = 12.0f, .colour = 0xFFFFFF};
  Picture picture = makePicture(20, 20, 0x000000);
  drawText(picture, "H", 4.0f, 15, style);
  drawText(picture, "HHHHHHHH", -30.0f, 4, style);
  uint8_t brightest = 0;
  for (uint32_t x = 0; x < 20; ++x) brightest = std::max(brightest, picture.rgba[4 * (12 * 20 + x)]);
  EXPECT_GT(brightest, 150);
}

}  // namespace
}  // namespace gridscope
