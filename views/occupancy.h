// How full the cells are that hold the surfaces seen.
#ifdef __cplusplus
{.name = "occupancy",
 .title = "References stored in the cell at the surface",
 .unit = "references",
 .about = "The brighter a surface, the more triangles share its cell; a hatched cell was full and refused some.",
 .scope = ViewScope::surface,
 .range = ViewRange::capacity,
 .needsGrid = true,
 .marks = "saturated"},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  ivec3 cell = surfaceCell(seen);
  if (!gridContains(gridParameters(), cell)) return noElement();
  return paintedElement(occupancyElement(cell), seen);
}
#endif
