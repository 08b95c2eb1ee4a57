// The grid on the device: its image, its parameters, and the door to what a cell holds.
#include "shaders/shared/grid/layout.h"

layout(set = 0, binding = kBindGrid, r32ui) uniform uimage3D gridImage;

layout(constant_id = kConstantOverlap) const uint kSpecializedOverlap = 0u;
layout(constant_id = kConstantInsertion) const uint kSpecializedInsertion = 0u;
layout(constant_id = kConstantStretchAxis) const int kSpecializedStretchAxis = 0;
layout(constant_id = kConstantReserved) const int kSpecializedReserved = 2;

GridParameters gridParameters() {
  GridParameters grid = parameters.grid;
  grid.overlap = kSpecializedOverlap;
  grid.insertion = kSpecializedInsertion;
  grid.stretchAxis = kSpecializedStretchAxis;
  grid.reserved = kSpecializedReserved;
  return grid;
}

uint slotLoad(ivec3 texel) { return imageLoad(gridImage, texel).x; }

#include "shaders/shared/grid/cell.h"
