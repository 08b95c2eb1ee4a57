// How often the cells at the surfaces are asked.
#ifdef __cplusplus
{.name = "rays",
 .title = "Rays that read the cell at the surface",
 .unit = "rays",
 .about = "Rays of the frame that tested the references of the surface's cell.",
 .scope = ViewScope::surface,
 .range = ViewRange::automatic,
 .needsGrid = true,
 .need = ViewNeed::cellRays},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  ivec3 cell = surfaceCell(seen);
  if (!gridContains(gridParameters(), cell)) return noElement();
  return paintedElement(valueElement(float(raysOf(cell).read)), seen);
}
#endif
