// Which triangles cost rays.
#ifdef __cplusplus
{.name = "lost",
 .title = "Rays lost to the triangle",
 .unit = "rays",
 .about = "A triangle is the brighter, the more rays should have hit it and did not; dark surfaces lost none.",
 .scope = ViewScope::surface,
 .range = ViewRange::automatic,
 .need = ViewNeed::triangleCosts},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  uint cost = costOf(seen.reference);
  if (cost == 0u) return litElement(paintedElement(colourElement(unpackColour(kColourLine)), seen), 0.5);
  return paintedElement(valueElement(float(cost)), seen);
}
#endif
