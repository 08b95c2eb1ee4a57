// One element of a view: what a view's function returns. shaders/shared/views/element_colour.h turns it into a colour.
#ifndef GRIDSCOPE_SHARED_VIEW_ELEMENT_H
#define GRIDSCOPE_SHARED_VIEW_ELEMENT_H

#include "shaders/shared/base/language.h"

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

END_SHARED

#endif
