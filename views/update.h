// What the last update changed in the cells at the surfaces.
#ifdef __cplusplus
{.name = "update",
 .title = "Cells that the last update changed",
 .unit = "",
 .about =
     "In the colour of the instance that caused it: filled cells; hatched, cells that were only cleared; dim, cells that hold what they "
     "held. Elsewhere the picture is dimmed.",
 .scope = ViewScope::surface,
 .needsGrid = true,
 .need = ViewNeed::cellUpdates,
 .marks = "filled, cleared, kept"},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  ivec3 cell = surfaceCell(seen);
  CellUpdate update = CellUpdate(0u, 0u, 0u, kNoReference);
  if (gridContains(gridParameters(), cell)) update = updateOf(cell);
  if (update.instance == kNoReference) return litElement(colourElement(toneMapped(finalLight(pixel))), 1.0 / 3.0);
  return paintedElement(updateElement(update, uvec2(pixel % parameters.view.width, pixel / parameters.view.width)), seen);
}
#endif
