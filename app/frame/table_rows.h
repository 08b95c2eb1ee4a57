// The window's tables as sheets: cells, instances, triangles and rays of one snapshot. A rectangle of pixels marks the rows that its rays led to.
#pragma once

#include <optional>

#include "app/frame/sheet.h"
#include "app/frame/showing.h"
#include "app/frame/snapshot.h"

namespace gridscope {

enum class TableKind { cells, instances, triangles, rays };

// What one row is called, and many: "cell", "cells".
const char* tableNoun(TableKind kind, bool many);

// Row ids: a cell's number (x fastest), a scene instance, a reference, a pixel. Values that need the ledger or the truth are not known
// before these are there. Empty when the snapshot lacks what the table shows.
Sheet makeSheet(TableKind kind, const FrameSnapshot& frame, const std::optional<PixelArea>& area);

// Columns of each table, by their place.
enum class CellColumn : size_t { cell, tried, stored, refused, occupancy, readBy, raysLost };
enum class InstanceColumn : size_t { name, mesh, state, triangles, stored, lost, raysLost };
enum class TriangleColumn : size_t { reference, mesh, triangle, area, stored, lost, raysLost };
enum class RayColumn : size_t { pixel, kind, t, visits, tests, verdict, cause };

// Does the snapshot hold what the table shows? While its stages run again it may not.
bool canMakeSheet(TableKind kind, const FrameSnapshot& frame);

// The pieces of a snapshot that a table is made of: while they stay the same, so does the sheet.
std::vector<const void*> sheetSources(TableKind kind, const FrameSnapshot& frame);

// Where to look to see it: world bounds.
Bounds boundsOfTriangle(const FrameSnapshot& frame, uint32_t reference);
Bounds boundsOfInstance(const FrameSnapshot& frame, uint32_t sceneInstance);

// The frame's triangle of a reference; null for one that names none.
const Triangle* worldTriangle(const FrameSnapshot& frame, uint32_t reference);

}  // namespace gridscope
