// Colours: the colour maps, the colours with a fixed meaning, colours for ids, and the hatch of what is saturated. All of them are
// sRGB, components 0..1, ready to store; only srgbEncode and srgbDecode know linear light.
// Sources: viridis and magma, Smith and van der Walt, matplotlib, 2015; cividis, Nunez, Anderton and Renslow, 2018.
#ifndef GRIDSCOPE_SHARED_PALETTE_H
#define GRIDSCOPE_SHARED_PALETTE_H

#include "shaders/shared/base/hash.h"

// A constant array is spelled differently in the two languages.
#ifdef __cplusplus
#define LIST_BEGIN(type, count) {
#define LIST_END }
namespace gridscope {
using glm::pow;
}
#else
#define LIST_BEGIN(type, count) type[count](
#define LIST_END )
#endif

BEGIN_SHARED

const uint kColourMapViridis = 0u;
const uint kColourMapCividis = 1u;
const uint kColourMapMagma = 2u;
const uint kColourMapGrey = 3u;
const uint kColourMapCount = 4u;

// Every eighth of each map's 256 entries, 0xRRGGBB. Linear between them, viridis and magma are within 2/255 of the original; cividis
// within 6/255, at the kink that its blue has near the dark end.
const int kMapKnots = 33;
const uint kMapColours[99] = LIST_BEGIN(uint, 99)
    // viridis
    0x440154u,
           0x470D60u, 0x48186Au, 0x482374u, 0x472D7Bu, 0x453681u, 0x424086u, 0x3F4989u, 0x3B528Bu, 0x375A8Du, 0x33638Du, 0x2F6A8Eu,
           0x2C728Eu, 0x297A8Eu, 0x26818Eu, 0x23898Eu, 0x21908Cu, 0x1F988Bu, 0x1F9F88u, 0x21A685u, 0x28AE80u, 0x31B57Bu, 0x3EBC74u,
           0x4CC26Cu, 0x5DC963u, 0x6ECE58u, 0x82D34Cu, 0x96D83Fu, 0xABDC32u, 0xC0DF24u, 0xD5E21Au, 0xEAE51Au, 0xFDE725u,
           // cividis
    0x00224Eu, 0x00285Bu, 0x002E6Au, 0x043371u, 0x1A386Fu, 0x273E6Eu, 0x32436Du, 0x3B496Cu, 0x434E6Cu, 0x4B546Cu, 0x52596Du, 0x5A5F6Eu,
           0x61656Fu, 0x686A71u, 0x6F7073u, 0x757676u, 0x7C7B78u, 0x848179u, 0x8B8778u, 0x938D78u, 0x9B9376u, 0xA39A75u, 0xABA072u,
           0xB3A670u, 0xBBAD6Cu, 0xC3B469u, 0xCCBA64u, 0xD4C15Fu, 0xDDC958u, 0xE6D051u, 0xEFD748u, 0xF8DF3Cu, 0xFEE838u,
           // magma
    0x000004u, 0x030311u, 0x0A0822u, 0x130D33u, 0x1D1146u, 0x28115Au, 0x36106Au, 0x430F76u, 0x50127Cu, 0x5D177Fu, 0x691C81u, 0x762181u,
           0x822681u, 0x8F2A81u, 0x9C2E7Fu, 0xA9327Du, 0xB63779u, 0xC33B75u, 0xCF4170u, 0xDB486Au, 0xE65163u, 0xEE5C5Eu, 0xF5695Cu,
           0xF9785Du, 0xFB8761u, 0xFD9668u, 0xFEA571u, 0xFEB47Bu, 0xFEC387u, 0xFED194u, 0xFDE0A2u, 0xFCEEB0u, 0xFCFDBFu LIST_END;

// Colours with one meaning everywhere (dark theme), 0xRRGGBB. Colour never stands alone: a shape, a hatch or a word goes with it.
const uint kColourTriangleHit = 0x2FB58Cu;  // also: confirmed, ok
const uint kColourVoxelHit = 0xF0B429u;
const uint kColourMiss = 0x5F86B3u;
const uint kColourSaturated = 0xF06EB8u;  // also: refused; always hatched
const uint kColourTested = 0x4FA3D9u;     // tested, no hit
const uint kColourRevisit = 0xA99BE0u;
const uint kColourEmpty = 0x8A95A1u;
const uint kColourSelected = 0xFFFFFFu;
const uint kColourHole = 0xF05A28u;  // also: stepped over
const uint kColourVoxelRight = 0x5F5A20u;
const uint kColourVoxelWrong = 0xFFD43Bu;
const uint kColourTooFar = 0x3A8FDEu;
const uint kColourTooNear = 0xA6DCF7u;
const uint kColourGate = 0xC58A5Cu;

// Surfaces and text (dark theme).
const uint kColourWindow = 0x14171Bu;  // where there is nothing
const uint kColourPanel = 0x1A1E23u;
const uint kColourLine = 0x2E353Du;
const uint kColourText = 0xD9DFE5u;
const uint kColourDim = 0x8F9AA6u;

// From 0xRRGGBB.
SHARED vec3 unpackColour(uint colour) {
  return vec3(float((colour >> 16) & 255u), float((colour >> 8) & 255u), float(colour & 255u)) * (1.0f / 255.0f);
}

// 8 bits each, red lowest: what an image stores. Values are rounded and clamped.
SHARED uint packBytes(vec3 colour) {
  vec3 bytes = clamp(colour, vec3(0.0f, 0.0f, 0.0f), vec3(1.0f, 1.0f, 1.0f)) * 255.0f + vec3(0.5f, 0.5f, 0.5f);
  return uint(bytes.x) | (uint(bytes.y) << 8) | (uint(bytes.z) << 16);
}

SHARED vec3 unpackBytes(uint bytes) {
  return vec3(float(bytes & 255u), float((bytes >> 8) & 255u), float((bytes >> 16) & 255u)) * (1.0f / 255.0f);
}

// Colour of a map at x in 0..1; what lies outside takes the nearer end.
SHARED vec3 colourMap(uint map, float x) {
  float position = x > 0.0f ? min(x, 1.0f) : 0.0f;  // also for a NaN
  if (map >= kColourMapGrey) return vec3(position, position, position);
  position = position * float(kMapKnots - 1);
  int knot = min(int(position), kMapKnots - 2);
  vec3 low = unpackColour(kMapColours[int(map) * kMapKnots + knot]);
  vec3 high = unpackColour(kMapColours[int(map) * kMapKnots + knot + 1]);
  return low + (high - low) * (position - float(knot));
}

// Is this pixel on a dark line of the hatch? Lines rise to the right at 45 degrees, 2 of every 6 pixels.
SHARED bool hatchLine(uvec2 pixel) { return (pixel.x + pixel.y) % 6u >= 4u; }

// Colour of what is saturated, at a pixel: pink from dim (x = 0) to full (x = 1), hatched.
SHARED vec3 markedColour(float x, uvec2 pixel) {
  float strength = 0.5f + 0.5f * (x > 0.0f ? min(x, 1.0f) : 0.0f);
  return unpackColour(kColourSaturated) * (hatchLine(pixel) ? 0.5f * strength : strength);
}

// A steady colour for an id: any hue, muted, never near black or white.
SHARED vec3 idColour(uint id) {
  uint bits = hashOf(id);
  float turn = float(bits & 1023u) * (6.0f / 1024.0f);
  vec3 hue = clamp(vec3(abs(turn - 3.0f) - 1.0f, 2.0f - abs(turn - 2.0f), 2.0f - abs(turn - 4.0f)), vec3(0.0f, 0.0f, 0.0f),
                   vec3(1.0f, 1.0f, 1.0f));
  float saturation = 0.30f + 0.09f * float((bits >> 10) & 3u);
  float value = 0.60f + 0.12f * float((bits >> 12) & 3u);
  return (vec3(1.0f, 1.0f, 1.0f) + (hue - vec3(1.0f, 1.0f, 1.0f)) * saturation) * value;
}

// Linear light to sRGB and back (IEC 61966-2-1). Input is clamped to 0..1.
SHARED float srgbEncodeOne(float linear) {
  float x = clamp(linear, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}
SHARED float srgbDecodeOne(float encoded) {
  float x = clamp(encoded, 0.0f, 1.0f);
  return x <= 0.04045f ? x / 12.92f : pow((x + 0.055f) / 1.055f, 2.4f);
}
SHARED vec3 srgbEncode(vec3 linear) { return vec3(srgbEncodeOne(linear.x), srgbEncodeOne(linear.y), srgbEncodeOne(linear.z)); }
SHARED vec3 srgbDecode(vec3 encoded) { return vec3(srgbDecodeOne(encoded.x), srgbDecodeOne(encoded.y), srgbDecodeOne(encoded.z)); }

END_SHARED

#endif
