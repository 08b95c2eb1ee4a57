// Colour maps, fixed colours, hatch. Colour vision deficiencies are simulated after Machado, Oliveira and Fernandes, A Physiologically-
// based Model for Simulation of Color Vision Deficiency, 2009 (severity 1); distances are CIE 1976 colour differences.
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "shaders/shared/grid/slice.h"
#include "shaders/shared/views/element_colour.h"
#include "shaders/shared/views/palette.h"
#include "shaders/shared/views/truth_colours.h"

namespace gridscope {
namespace {

struct Named {
  const char* name;
  uint32_t colour;
};

using Matrix = std::array<vec3, 3>;
const Matrix kNormal{vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};
const Matrix kProtanopia{vec3(0.152286f, 1.052583f, -0.204868f), vec3(0.114503f, 0.786281f, 0.099216f),
                         vec3(-0.003882f, -0.048116f, 1.051998f)};
const Matrix kDeuteranopia{vec3(0.367322f, 0.860646f, -0.227968f), vec3(0.280085f, 0.672501f, 0.047413f),
                           vec3(-0.011820f, 0.042940f, 0.968881f)};

const Matrix kTritanopia{vec3(1.255528f, -0.076749f, -0.178779f), vec3(-0.078411f, 0.930809f, 0.147602f),
                         vec3(0.004733f, 0.691367f, 0.303900f)};

vec3 times(const Matrix& matrix, vec3 v) { return {glm::dot(matrix[0], v), glm::dot(matrix[1], v), glm::dot(matrix[2], v)}; }

// CIE L*a*b* (white: D65) of an sRGB colour.
vec3 labOf(vec3 srgb, const Matrix& eye = kNormal) {
  const Matrix toXyz{vec3(0.4124f, 0.3576f, 0.1805f), vec3(0.2126f, 0.7152f, 0.0722f), vec3(0.0193f, 0.1192f, 0.9505f)};
  vec3 seen = glm::clamp(times(eye, srgbDecode(srgb)), 0.0f, 1.0f);
  vec3 xyz = times(toXyz, seen) / vec3(0.9505f, 1.0f, 1.089f);
  auto f = [](float t) { return t > 0.008856f ? std::cbrt(t) : 7.787f * t + 16.0f / 116.0f; };
  return {116.0f * f(xyz.y) - 16.0f, 500.0f * (f(xyz.x) - f(xyz.y)), 200.0f * (f(xyz.y) - f(xyz.z))};
}

float difference(vec3 a, vec3 b, const Matrix& eye = kNormal) { return glm::distance(labOf(a, eye), labOf(b, eye)); }

std::string hex(vec3 colour) {
  char text[8];
  uint32_t bytes = packBytes(colour);
  std::snprintf(text, sizeof text, "%02X%02X%02X", bytes & 255u, (bytes >> 8) & 255u, (bytes >> 16) & 255u);
  return text;
}

TEST(Palette, MapsHaveTheEndPointsOfTheOriginals) {
  EXPECT_EQ(hex(colourMap(kColourMapViridis, 0.0f)), "440154");
  EXPECT_EQ(hex(colourMap(kColourMapViridis, 1.0f)), "FDE725");
  EXPECT_EQ(hex(colourMap(kColourMapCividis, 0.0f)), "00224E");
  EXPECT_EQ(hex(colourMap(kColourMapCividis, 1.0f)), "FEE838");
  EXPECT_EQ(hex(colourMap(kColourMapMagma, 0.0f)), "000004");
  EXPECT_EQ(hex(colourMap(kColourMapMagma, 1.0f)), "FCFDBF");
  EXPECT_EQ(hex(colourMap(kColourMapGrey, 0.0f)), "000000");
  EXPECT_EQ(hex(colourMap(kColourMapGrey, 1.0f)), "FFFFFF");
}

TEST(Palette, ViridisIsWithinTwo255thsOfMatplotlibBetweenItsKnots) {
  // Entries 20, 75, 130, 185 and 240 of matplotlib's _viridis_data.
  struct Entry {
    int index;
    vec3 colour;
  };
  const Entry entries[] = {{20, {0.283197f, 0.115680f, 0.436115f}},
                           {75, {0.208623f, 0.367752f, 0.552675f}},
                           {130, {0.125394f, 0.574318f, 0.549086f}},
                           {185, {0.311925f, 0.767822f, 0.415586f}},
                           {240, {0.845561f, 0.887322f, 0.099702f}}};
  for (const Entry& entry : entries) {
    vec3 error = glm::abs(colourMap(kColourMapViridis, static_cast<float>(entry.index) / 255.0f) - entry.colour);
    EXPECT_LE(std::max({error.x, error.y, error.z}), 2.0f / 255.0f) << "entry " << entry.index;
  }
}

TEST(Palette, EveryMapGrowsLighterFromEndToEndForEveryEye) {
  for (uint32_t map = 0; map < kColourMapCount; ++map)
    for (const Matrix& eye : {kNormal, kProtanopia, kDeuteranopia}) {
      float last = -1.0f;
      for (int i = 0; i <= 64; ++i) {
        float lightness = labOf(colourMap(map, static_cast<float>(i) / 64.0f), eye).x;
        EXPECT_GT(lightness, last - 0.35f) << "map " << map << " at " << i << "/64";
        last = std::max(last, lightness);
      }
      EXPECT_GT(last, 85.0f) << "map " << map;
    }
}

TEST(Palette, ValuesOutsideTheMapTakeItsEnds) {
  EXPECT_EQ(colourMap(kColourMapMagma, -3.0f), colourMap(kColourMapMagma, 0.0f));
  EXPECT_EQ(colourMap(kColourMapMagma, 7.0f), colourMap(kColourMapMagma, 1.0f));
  EXPECT_EQ(colourMap(kColourMapMagma, NAN), colourMap(kColourMapMagma, 0.0f));
  EXPECT_EQ(colourMap(kColourMapMagma, INFINITY), colourMap(kColourMapMagma, 1.0f));
}

TEST(Palette, KindsOfHitDifferByAtLeast25ForEveryEye) {
  const std::vector<Named> together{
      {"triangle hit", kColourTriangleHit}, {"voxel hit", kColourVoxelHit}, {"miss", kColourMiss}, {"nothing", kColourWindow}};
  for (size_t i = 0; i < together.size(); ++i)
    for (size_t k = 0; k < i; ++k)
      for (const Matrix& eye : {kNormal, kProtanopia, kDeuteranopia})
        EXPECT_GE(difference(unpackColour(together[i].colour), unpackColour(together[k].colour), eye), 25.0f)
            << together[i].name << " and " << together[k].name;
}

// Expects any two of the colours, and each and the background, to differ for every kind of colour vision.
void expectApart(const std::vector<Named>& colours, float least) {
  for (size_t i = 0; i < colours.size(); ++i)
    for (const Matrix& eye : {kNormal, kProtanopia, kDeuteranopia, kTritanopia}) {
      EXPECT_GE(difference(unpackColour(colours[i].colour), unpackColour(kColourWindow), eye), least) << colours[i].name << " and nothing";
      for (size_t k = 0; k < i; ++k)
        EXPECT_GE(difference(unpackColour(colours[i].colour), unpackColour(colours[k].colour), eye), least)
            << colours[i].name << " and " << colours[k].name;
    }
}

TEST(Palette, VerdictsDifferByAtLeast16ForEveryEye) {
  std::vector<Named> verdicts;
  for (uint32_t verdict = kVerdictHole; verdict < kVerdictCount; ++verdict) verdicts.push_back({"a verdict", verdictColour(verdict)});
  expectApart(verdicts, 16.0f);
}

// Refused is hatched, so that its lightness tells it apart.
TEST(Palette, CausesDifferByAtLeast18ForEveryEye) {
  std::vector<Named> causes;
  for (uint32_t cause = kCauseNone + 1; cause < kCauseCount; ++cause)
    if (cause != kCauseRefused) causes.push_back({"a cause", causeColour(cause)});
  expectApart(causes, 18.0f);
  EXPECT_EQ(causeColour(kCauseRefused), kColourSaturated);
  EXPECT_EQ(causeColour(kCauseSteppedOver), kColourHole);
  EXPECT_EQ(causeColour(kCauseRevisit), kColourRevisit);
  EXPECT_EQ(causeColour(kCauseGate), kColourGate);
}

TEST(Palette, WhatChangesFromBuildToBuildDiffersByAtLeast25ForEveryEye) {
  expectApart({{"ray", kColourRayChanges}, {"set", kColourSetDiffers}, {"order", kColourOrderDiffers}}, 25.0f);
}

// note: for a deuteranope the pink itself is the blue of a miss (difference 2). What tells them apart is the hatch.
TEST(Palette, TheHatchShowsForEveryEye) {
  for (float x : {0.0f, 0.5f, 1.0f})
    for (const Matrix& eye : {kNormal, kProtanopia, kDeuteranopia}) {
      vec3 light = labOf(markedColour(x, uvec2(0u, 0u)), eye);
      vec3 dark = labOf(markedColour(x, uvec2(4u, 0u)), eye);
      EXPECT_GE(light.x - dark.x, 15.0f) << "lightness, marked at " << x;
    }
}

TEST(Palette, WhatIsSaturatedNeverLooksLikeAMap) {
  for (uint32_t map : {kColourMapViridis, kColourMapCividis, kColourMapGrey})
    for (int i = 0; i <= 255; ++i) {
      vec3 onMap = colourMap(map, static_cast<float>(i) / 255.0f);
      for (float x : {0.0f, 0.5f, 1.0f})
        for (uint32_t pixel : {0u, 4u}) {
          vec3 marked = markedColour(x, uvec2(pixel, 0u));
          ASSERT_NE(hex(marked), hex(onMap));
          ASSERT_GE(difference(marked, onMap), 12.0f) << "map " << map << " at " << i << "/255, marked at " << x;
        }
    }
}

TEST(Palette, TheHatchRisesToTheRightAtFortyFiveDegrees) {
  for (uint32_t y = 1; y < 20; ++y)
    for (uint32_t x = 0; x < 20; ++x) EXPECT_EQ(hatchLine(uvec2(x, y)), hatchLine(uvec2(x + 1, y - 1)));
  int dark = 0;
  for (uint32_t x = 0; x < 60; ++x) dark += hatchLine(uvec2(x, 7));
  EXPECT_EQ(dark, 20);
}

TEST(Palette, IdsHaveSteadyMutedAndManyColours) {
  std::set<std::string> seen;
  for (uint32_t id = 0; id < 1000; ++id) {
    vec3 colour = idColour(id);
    EXPECT_EQ(colour, idColour(id));
    EXPECT_GE(std::max({colour.x, colour.y, colour.z}), 0.59f);
    EXPECT_GE(std::min({colour.x, colour.y, colour.z}), 0.2f);
    EXPECT_LE(std::max({colour.x, colour.y, colour.z}), 0.97f);
    seen.insert(hex(colour));
  }
  EXPECT_GT(seen.size(), 900u);
}

TEST(Palette, SrgbSurvivesDecodingAndEncoding) {
  for (uint32_t byte = 0; byte < 256; ++byte) {
    uint32_t grey = byte | (byte << 8) | (byte << 16);
    EXPECT_EQ(packBytes(srgbEncode(srgbDecode(unpackBytes(grey)))), grey);
  }
}

TEST(Element, ValueTakesTheMapMarkedTakesPinkColourStaysAsItIs) {
  uvec2 place(0u, 0u);
  EXPECT_EQ(elementColour(valueElement(3.0f), 1.0f, 5.0f, kColourMapViridis, place), colourMap(kColourMapViridis, 0.5f));
  EXPECT_EQ(hex(elementColour(markedElement(9.0f), 1.0f, 5.0f, kColourMapViridis, place)), "F06EB8");
  EXPECT_EQ(hex(elementColour(colourElement(unpackColour(0x123456)), 0.0f, 1.0f, kColourMapViridis, place)), "123456");
  EXPECT_EQ(hex(elementColour(noElement(), 0.0f, 1.0f, kColourMapViridis, place)), "14171B");
}

TEST(Element, LightScalesTheColourAndFullLightChangesNothing) {
  ViewElement element = colourElement(vec3(0.8f, 0.4f, 0.2f));
  vec3 full = elementColour(element, 0.0f, 1.0f, 0, uvec2(0u, 0u));
  EXPECT_EQ(elementColour(litElement(element, 1.0f), 0.0f, 1.0f, 0, uvec2(0u, 0u)), full);
  vec3 half = elementColour(litElement(element, 0.5f), 0.0f, 1.0f, 0, uvec2(0u, 0u));
  EXPECT_NEAR(half.x, 0.5f * full.x, 0.003f);
}

TEST(Element, ASliceStandsUprightAndNamesEachCellOnce) {
  ivec3 cells(3, 4, 5);
  EXPECT_EQ(sliceSize(cells, 0), uvec2(5u, 4u));
  EXPECT_EQ(sliceSize(cells, 1), uvec2(3u, 5u));
  EXPECT_EQ(sliceSize(cells, 2), uvec2(3u, 4u));
  EXPECT_EQ(sliceCell(cells, 0, 2, 0), ivec3(2, 3, 0));  // top row: highest y
  EXPECT_EQ(sliceCell(cells, 1, 2, 0), ivec3(0, 2, 0));
  EXPECT_EQ(sliceCell(cells, 2, 1, 11), ivec3(2, 0, 1));  // last element: lowest y
  for (int axis = 0; axis < 3; ++axis) {
    std::set<std::array<int, 3>> seen;
    uvec2 size = sliceSize(cells, axis);
    for (uint32_t element = 0; element < size.x * size.y; ++element) {
      ivec3 cell = sliceCell(cells, axis, 1, element);
      EXPECT_EQ(cell[axis], 1);
      seen.insert({cell.x, cell.y, cell.z});
    }
    EXPECT_EQ(seen.size(), size_t{size.x} * size.y);
  }
}

}  // namespace
}  // namespace gridscope
