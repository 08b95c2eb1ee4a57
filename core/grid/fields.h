// A grid's parameters as a manifest has them: each by its name. What a file may leave out is derived as for a build here.
#pragma once

#include "core/grid/settings.h"
#include "shaders/shared/grid/parameters.h"

namespace gridscope {

// Throw Error, "grid.capacity is not from 1 to 16384", for what no grid can have: its shape alone, and all of it.
void checkGridShape(const GridParameters& grid);
void checkGridParameters(const GridParameters& grid);

// What derives from shape and settings, by the formulas of deriveGrid().
void deriveForeignGrid(const GridSettings& settings, GridParameters& grid);

// What no grid can do without.
template <class Fields>
void describeShape(Fields& field, GridParameters& grid) {
  field("origin", grid.origin);
  field("cellEdge", grid.cellEdge);
  field("cellCount", grid.cellCount);
  field("capacity", grid.capacity);
  field("reserved", grid.reserved);
  field.choice("stretchAxis", grid.stretchAxis, {"x", "y", "z"});
}

template <class Fields>
void describeDerived(Fields& field, GridParameters& grid) {
  field("stride", grid.stride);
  field("inverseCellEdge", grid.inverseCellEdge);
  field("planeRadiusSquared", grid.planeRadiusSquared);
  field("boxHalfEdge", grid.boxHalfEdge);
  field.choice("overlap", grid.overlap, {"plane", "exact"});
  field.choice("insertion", grid.insertion, {"sorted", "first-come"});
  field("staticInstanceCount", grid.staticInstanceCount);
  field("instanceCount", grid.instanceCount);
  field("staticTriangleCount", grid.staticTriangleCount);
  field("triangleCount", grid.triangleCount);
  field("cellsPerInvocation", grid.cellsPerInvocation);
}

// Reads a manifest's grid: what describeShape() names must be there, the rest has defaults. Throws Error.
template <class Fields>
void readGridFields(const Fields& field, const GridSettings& settings, GridParameters& grid) {
  field.require({"origin", "cellEdge", "cellCount", "capacity", "reserved", "stretchAxis"});
  describeShape(field, grid);
  checkGridShape(grid);
  deriveForeignGrid(settings, grid);
  describeDerived(field, grid);
  checkGridParameters(grid);
}

}  // namespace gridscope
