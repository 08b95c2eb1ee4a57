// One element of a view, in the language that C++ and GLSL share: what a view's function returns, and how it becomes a colour.
#ifndef GRIDSCOPE_SHARED_VIEW_ELEMENT_H
#define GRIDSCOPE_SHARED_VIEW_ELEMENT_H

#include "shaders/shared/views/palette.h"

BEGIN_SHARED

const uint kElementNothing = 0u;  // nothing seen, no ray: the background
const uint kElementValue = 1u;    // payload: a float's bits, coloured by the map over the range
const uint kElementMarked = 2u;   // payload: a float's bits; saturated or beyond capacity: pink with hatch, never the map's colour
const uint kElementColour = 3u;   // payload: sRGB, 8 bits each, red lowest

struct ViewElement {
  uint kind;
  uint payload;
  uint shadow;  // 0..255: how much of the colour's brightness the surface's shading takes away; 0 where colours are read exactly
};

SHARED ViewElement makeElement(uint kind, uint payload) {
  ViewElement element;
  element.kind = kind;
  element.payload = payload;
  element.shadow = 0u;
  return element;
}

SHARED ViewElement noElement() { return makeElement(kElementNothing, 0u); }
SHARED ViewElement valueElement(float value) { return makeElement(kElementValue, floatBitsToUint(value)); }
SHARED ViewElement markedElement(float value) { return makeElement(kElementMarked, floatBitsToUint(value)); }
SHARED ViewElement colourElement(vec3 srgb) { return makeElement(kElementColour, packBytes(srgb)); }

// The element as a surface shows it: `light` 1 leaves it as it is, 0 makes it black.
SHARED ViewElement litElement(ViewElement element, float light) {
  element.shadow = uint((1.0f - clamp(light, 0.0f, 1.0f)) * 255.0f + 0.5f);
  return element;
}

// sRGB colour of an element that is drawn at `pixel`, values from `low` to `high` over the map.
SHARED vec3 elementColour(ViewElement element, float low, float high, uint map, uvec2 pixel) {
  float x = (uintBitsToFloat(element.payload) - low) / max(high - low, kTiny);
  vec3 colour = unpackColour(kColourWindow);
  if (element.kind == kElementValue) colour = colourMap(map, x);
  if (element.kind == kElementMarked) colour = markedColour(x, pixel);
  if (element.kind == kElementColour) colour = unpackBytes(element.payload);
  return colour * (1.0f - float(element.shadow) * (1.0f / 255.0f));
}

// A slice shows one layer of cells as a person stands before it: row 0 is the top. Across x and z up is y; across y (from above) the
// rows run along z.
SHARED int sliceColumnAxis(int sliceAxis) { return sliceAxis == 0 ? 2 : 0; }
SHARED int sliceRowAxis(int sliceAxis) { return sliceAxis == 1 ? 2 : 1; }

// Columns and rows of a slice's image: ViewParameters' width and height.
SHARED uvec2 sliceSize(ivec3 cellCount, int sliceAxis) {
  return uvec2(uint(cellCount[sliceColumnAxis(sliceAxis)]), uint(cellCount[sliceRowAxis(sliceAxis)]));
}

// The cell of an element of a slice.
SHARED ivec3 sliceCell(ivec3 cellCount, int sliceAxis, int sliceIndex, uint element) {
  uvec2 size = sliceSize(cellCount, sliceAxis);
  int row = int(element / size.x);
  ivec3 cell = ivec3(sliceIndex, sliceIndex, sliceIndex);
  cell[sliceColumnAxis(sliceAxis)] = int(element % size.x);
  cell[sliceRowAxis(sliceAxis)] = sliceAxis == 1 ? row : int(size.y) - 1 - row;
  return cell;
}

END_SHARED

#endif
