// The fixed-capacity grid: which cell holds a point, which texel holds a slot. Everything that reads or writes a grid goes through
// these few functions; nothing else knows the layout.
// Source: Abdollah-shamshir-saz, Hybrid Ray/Voxel-Tracing Fixed Capacity Grids, 2020.
#ifndef GRIDSCOPE_SHARED_GRID_H
#define GRIDSCOPE_SHARED_GRID_H

#include "shaders/shared/pipeline/parameters.h"

BEGIN_SHARED

SHARED uint makeReference(uint instance, uint triangle) { return (instance << 16) | triangle; }
SHARED uint referenceInstance(uint reference) { return reference >> 16; }
SHARED uint referenceTriangle(uint reference) { return reference & 0xFFFFu; }

// References at or above this one belong to dynamic instances.
SHARED uint firstDynamicReference(GridParameters grid) { return grid.staticInstanceCount << 16; }

// Cell coordinate of a world coordinate on one axis; -1 below the grid, cellCount above it.
SHARED int gridCoordinate(float position, float origin, float inverseCellEdge, int cellCount) {
  float cell = floor((position - origin) * inverseCellEdge);
  return int(clamp(cell, -1.0f, float(cellCount)));
}

// The cell that holds a point; outside the grid some component is -1 or cellCount.
SHARED ivec3 gridCell(GridParameters grid, vec3 point) {
  return ivec3(gridCoordinate(point.x, grid.origin.x, grid.inverseCellEdge, grid.cellCount.x),
               gridCoordinate(point.y, grid.origin.y, grid.inverseCellEdge, grid.cellCount.y),
               gridCoordinate(point.z, grid.origin.z, grid.inverseCellEdge, grid.cellCount.z));
}

SHARED bool gridContains(GridParameters grid, ivec3 cell) {
  return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < grid.cellCount.x && cell.y < grid.cellCount.y && cell.z < grid.cellCount.z;
}

// World coordinate of the face of a cell with the lower coordinate.
SHARED float gridFace(GridParameters grid, int axis, int cell) { return grid.origin[axis] + float(cell) * grid.cellEdge; }

SHARED vec3 gridCellCentre(GridParameters grid, ivec3 cell) {
  return vec3(grid.origin.x + (float(cell.x) + 0.5f) * grid.cellEdge, grid.origin.y + (float(cell.y) + 0.5f) * grid.cellEdge,
              grid.origin.z + (float(cell.z) + 0.5f) * grid.cellEdge);
}

// Texel of a cell's slot; slots at and beyond the capacity are the reserved texels.
SHARED ivec3 gridTexel(GridParameters grid, ivec3 cell, int slot) {
  ivec3 texel = cell;
  texel[grid.stretchAxis] = cell[grid.stretchAxis] * grid.stride + slot;
  return texel;
}

// Texel that counts the static or dynamic references a cell refused (two reserved texels).
SHARED ivec3 gridRefusedTexel(GridParameters grid, ivec3 cell, bool isDynamic) {
  return gridTexel(grid, cell, grid.capacity + (isDynamic ? 1 : 0));
}

SHARED ivec3 gridTexelCount(GridParameters grid) {
  ivec3 count = grid.cellCount;
  count[grid.stretchAxis] = count[grid.stretchAxis] * grid.stride;
  return count;
}

END_SHARED

#endif
