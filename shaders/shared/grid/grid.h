// The grid's door, where nothing is read: which cell holds a point, where a cell lies, its number, its list. Nobody outside the grid's rooms
// knows how a grid is stored (layout.h); what reads a cell is in cell.h.
// Source: Abdollah-shamshir-saz, Hybrid Ray/Voxel-Tracing Fixed Capacity Grids, 2020.
#ifndef GRIDSCOPE_SHARED_GRID_H
#define GRIDSCOPE_SHARED_GRID_H

#include "shaders/shared/grid/parameters.h"

BEGIN_SHARED

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

// A cell's references, one after another: listReference() reads one.
struct CellList {
  ivec3 cell;
  int most;  // references that it can hold: a loop over more was not cut short
};

SHARED CellList cellList(GridParameters grid, ivec3 cell) {
  CellList list;
  list.cell = cell;
  list.most = grid.capacity;
  return list;
}

// Cells of the grid.
SHARED uint cellCountOf(GridParameters grid) { return uint(grid.cellCount.x) * uint(grid.cellCount.y) * uint(grid.cellCount.z); }

// No cell's number.
const uint kNoCell = 0xFFFFFFFFu;

// A cell's place in lists with an element a cell: x fastest, then y, then z.
SHARED uint cellNumber(GridParameters grid, ivec3 cell) {
  return (uint(cell.z) * uint(grid.cellCount.y) + uint(cell.y)) * uint(grid.cellCount.x) + uint(cell.x);
}

END_SHARED

#endif
