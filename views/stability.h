// What depends on the order in which references arrive.
#ifdef __cplusplus
{.name = "stability",
 .title = "What changes from build to build",
 .unit = "",
 .about = "First-come builds of the same scene compared: rays whose result changes, and cells at the surface; dimmed where all are alike.",
 .scope = ViewScope::surface,
 .needsGrid = true,
 .need = ViewNeed::stability,
 .marks = "ray changes, set differs, order differs"},
#else
ViewElement viewElement(uint pixel) {
  if (rayChanges(pixel)) return colourElement(unpackColour(kColourRayChanges));
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  ivec3 cell = surfaceCell(seen);
  uint stability = gridContains(gridParameters(), cell) ? stabilityOf(cell) : kStable;
  if (stability == kStable) return litElement(colourElement(toneMapped(finalLight(pixel))), 1.0 / 3.0);
  return paintedElement(colourElement(unpackColour(stability == kUnstable ? kColourSetDiffers : kColourOrderDiffers)), seen);
}
#endif
