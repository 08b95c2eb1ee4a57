// From elements to pictures: ranges, marks, slices, and the list of views.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "shaders/shared/views/element_colour.h"
#include "views/picture.h"

namespace gridscope {
namespace {

std::vector<ViewElement> values(std::initializer_list<float> list) {
  std::vector<ViewElement> elements;
  for (float value : list) elements.push_back(valueElement(value));
  return elements;
}

uint32_t pixelAt(const Picture& picture, uint32_t x, uint32_t y) {
  const uint8_t* pixel = &picture.rgba[4 * (size_t{y} * picture.width + x)];
  return static_cast<uint32_t>(pixel[0]) | static_cast<uint32_t>(pixel[1]) << 8 | static_cast<uint32_t>(pixel[2]) << 16;
}

TEST(Views, AreListedOnceEachAndFoundByName) {
  std::set<std::string_view> names;
  for (const View& view : allViews()) {
    names.insert(view.name);
    EXPECT_EQ(findView(view.name), &view);
    EXPECT_FALSE(view.title.empty() || view.about.empty()) << view.name;
    EXPECT_EQ(view.unit.empty(), view.range == ViewRange::none) << view.name;
    EXPECT_EQ(view.scope == ViewScope::slice, view.name == "slice" || view.name.ends_with("-slice")) << view.name;
  }
  EXPECT_EQ(names.size(), allViews().size());
  EXPECT_EQ(std::ranges::count(allViews(), ViewNeed::nothing, &View::need), 14);
  EXPECT_EQ(allViews().front().name, "final");
  EXPECT_EQ(findView("finale"), nullptr);
  EXPECT_EQ(findView(""), nullptr);
}

TEST(ViewRange, AutomaticIsZeroToThe99thPercentileAndAtLeastOne) {
  const View& view = *findView("visits");
  std::vector<ViewElement> elements;
  for (int i = 1; i <= 200; ++i) elements.push_back(valueElement(static_cast<float>(i)));
  EXPECT_EQ(viewRange(view, elements, 0), (ValueRange{0.0f, 198.0f}));
  EXPECT_EQ(viewRange(view, values({0.1f, 0.2f}), 0), (ValueRange{0.0f, 1.0f}));
  EXPECT_EQ(viewRange(view, values({7.0f}), 0), (ValueRange{0.0f, 7.0f}));
  EXPECT_EQ(viewRange(view, {}, 0), (ValueRange{0.0f, 1.0f}));
}

TEST(ViewRange, CountsMarkedValuesAndLeavesOutColoursAndWhatIsNotFinite) {
  std::vector<ViewElement> elements{markedElement(9.0f), colourElement(vec3(1.0f)), noElement(), valueElement(NAN), valueElement(INFINITY)};
  EXPECT_EQ(viewRange(*findView("saturation"), elements, 0), (ValueRange{0.0f, 9.0f}));
}

TEST(ViewRange, ExtentIsLowestToHighestAndNeverEmpty) {
  const View& view = *findView("depth");
  EXPECT_EQ(viewRange(view, values({3.0f, 2.0f, 8.5f}), 0), (ValueRange{2.0f, 8.5f}));
  for (float value : {0.0f, 5.0f, -7.0f, 1e9f, -1e30f}) {
    ValueRange range = viewRange(view, values({value, value}), 0);
    EXPECT_LT(range[0], range[1]) << value;
    EXPECT_TRUE(std::isfinite(range[1]));
  }
}

TEST(ViewRange, CapacityIsTheGrids) { EXPECT_EQ(viewRange(*findView("occupancy"), values({3.0f}), 32), (ValueRange{0.0f, 32.0f})); }

TEST(ViewPicture, AGivenRangeReplacesTheViewsOwnAndIsReturned) {
  const View& view = *findView("visits");
  ViewPictureSettings settings{.range = ValueRange{10.0f, 20.0f}, .legend = false};
  ViewPicture result = makeViewPicture(view, values({0.0f, 10.0f, 20.0f, 40.0f}), 4, 1, settings);
  EXPECT_EQ(result.range, (ValueRange{10.0f, 20.0f}));
  uint32_t low = packBytes(colourMap(kColourMapViridis, 0.0f));
  uint32_t high = packBytes(colourMap(kColourMapViridis, 1.0f));
  EXPECT_EQ(pixelAt(result.picture, 0, 0), low);
  EXPECT_EQ(pixelAt(result.picture, 1, 0), low);
  EXPECT_EQ(pixelAt(result.picture, 2, 0), high);
  EXPECT_EQ(pixelAt(result.picture, 3, 0), high);
}

TEST(ViewPicture, AFullCellAndASaturatedOneDifferInEveryPixelOfTheHatch) {
  std::vector<ViewElement> elements(12, valueElement(32.0f));
  std::vector<ViewElement> marked(12, markedElement(32.0f));
  const View& view = *findView("occupancy");
  Picture full = makeViewPicture(view, elements, 12, 1, {.legend = false, .capacity = 32}).picture;
  Picture saturated = makeViewPicture(view, marked, 12, 1, {.legend = false, .capacity = 32}).picture;
  std::set<uint32_t> colours;
  for (uint32_t x = 0; x < 12; ++x) {
    EXPECT_NE(pixelAt(full, x, 0), pixelAt(saturated, x, 0));
    colours.insert(pixelAt(saturated, x, 0));
  }
  EXPECT_EQ(colours.size(), 2u) << "pink and the hatch's dark lines";
}

TEST(ViewPicture, EveryPixelIsOpaqueAndTheLegendGrowsThePictureDownwards) {
  std::vector<ViewElement> elements(size_t{320} * 10, valueElement(4.0f));
  for (const View& view : allViews()) {
    if (view.scope == ViewScope::slice) continue;
    Picture plain = makeViewPicture(view, elements, 320, 10, {.legend = false, .capacity = 32}).picture;
    Picture whole = makeViewPicture(view, elements, 320, 10, {.capacity = 32, .lines = {"a scene"}}).picture;
    EXPECT_EQ(plain.height, 10u);
    EXPECT_EQ(whole.width, 320u);
    EXPECT_GT(whole.height, 40u);
    EXPECT_TRUE(std::equal(plain.rgba.begin(), plain.rgba.end(), whole.rgba.begin())) << view.name;
    for (size_t i = 3; i < whole.rgba.size(); i += 4) ASSERT_EQ(whole.rgba[i], 255);
  }
}

TEST(ViewPicture, AnotherColourMapChangesValuesAndLeavesColours) {
  std::vector<ViewElement> elements{valueElement(16.0f), colourElement(vec3(0.2f, 0.4f, 0.6f))};
  const View& view = *findView("occupancy");
  ViewPictureSettings settings{.legend = false, .capacity = 32};
  Picture viridis = makeViewPicture(view, elements, 2, 1, settings).picture;
  settings.colourMap = kColourMapMagma;
  Picture magma = makeViewPicture(view, elements, 2, 1, settings).picture;
  EXPECT_NE(pixelAt(viridis, 0, 0), pixelAt(magma, 0, 0));
  EXPECT_EQ(pixelAt(viridis, 1, 0), pixelAt(magma, 1, 0));
}

TEST(ViewPicture, ALayerIsEnlargedByAWholeFactorToAboutTheFrame) {
  std::vector<ViewElement> elements;
  for (int i = 0; i < 16 * 8; ++i) elements.push_back(colourElement(idColour(static_cast<uint32_t>(i))));
  ViewPictureSettings settings{.legend = false, .capacity = 32, .frameWidth = 640, .frameHeight = 360};
  Picture picture = makeViewPicture(*findView("slice"), elements, 16, 8, settings).picture;
  uint32_t factor = picture.width / 16;
  EXPECT_EQ(picture.width % 16, 0u);
  EXPECT_EQ(picture.height, 8 * factor);
  EXPECT_GE(picture.width, 480u);
  EXPECT_LE(picture.width, 800u);
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x)
      ASSERT_EQ(pixelAt(picture, x, y), elements[y / factor * 16 + x / factor].payload) << "nearest element";
}

TEST(ViewPicture, ALayerOfFewCellsStillHasAReadableLegend) {
  std::vector<ViewElement> elements(6, valueElement(1.0f));
  for (auto [width, height] : {std::pair{1u, 6u}, {6u, 1u}, {2u, 3u}}) {
    ViewPictureSettings settings{.capacity = 4, .frameWidth = 160, .frameHeight = 90, .sliceAxis = 0, .sliceIndex = 0, .sliceCount = 1};
    Picture picture = makeViewPicture(*findView("slice"), elements, width, height, settings).picture;
    EXPECT_GE(picture.width, 320u);
  }
}

TEST(ViewPicture, ALayerOfManyCellsIsNotEnlarged) {
  std::vector<ViewElement> elements(size_t{1000} * 2, valueElement(1.0f));
  ViewPictureSettings settings{.legend = false, .capacity = 4, .frameWidth = 640, .frameHeight = 360};
  Picture picture = makeViewPicture(*findView("slice"), elements, 1000, 2, settings).picture;
  EXPECT_EQ(picture.width, 1000u);
}

}  // namespace
}  // namespace gridscope
