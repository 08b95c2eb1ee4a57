// What the gap-filled hits bring back.
#ifdef __cplusplus
{.name = "voxel",
 .title = "Gap-filled hits",
 .unit = "",
 .about = "Only rays that ended in a saturated cell without a triangle, as they are shaded; everything else is dimmed.",
 .scope = ViewScope::ray},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (hits[pixel].kind == kHitVoxel) return colourElement(toneMapped(bounceLight(pixel, seen.depth, 0.0)));
  if (seen.reference == kNoReference) return noElement();
  return litElement(paintedElement(colourElement(unpackColour(kColourLine)), seen), 0.5);
}
#endif
