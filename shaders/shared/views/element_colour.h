// Elements of views made from values, marks and colours, and the colour that each becomes, in C++ and GLSL alike.
#ifndef GRIDSCOPE_SHARED_ELEMENT_COLOUR_H
#define GRIDSCOPE_SHARED_ELEMENT_COLOUR_H

#include "shaders/shared/base/view_element.h"
#include "shaders/shared/views/palette.h"

BEGIN_SHARED

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

END_SHARED

#endif
