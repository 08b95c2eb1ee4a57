// How many references the cells refused that hold the surfaces seen.
#ifdef __cplusplus
{.name = "saturation",
 .title = "References refused by the cell at the surface",
 .unit = "references",
 .about = "Hatched surfaces lie in cells that were full: the brighter, the more triangles are missing there. Dark: none.",
 .scope = ViewScope::surface,
 .range = ViewRange::automatic,
 .needsGrid = true,
 .marks = "saturated, none refused"},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  ivec3 cell = surfaceCell(seen);
  if (!gridContains(gridParameters(), cell)) return noElement();
  uint refused = cellRefused(cell, cellStored(cell));
  if (refused == 0u) return paintedElement(colourElement(unpackColour(kColourLine)), seen);
  return paintedElement(markedElement(float(refused)), seen);
}
#endif
