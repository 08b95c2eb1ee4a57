// A colour for each triangle.
#ifdef __cplusplus
{.name = "triangle",
 .title = "Triangle",
 .unit = "",
 .about = "One colour for each reference, instance and triangle together.",
 .scope = ViewScope::surface},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  return paintedElement(colourElement(idColour(seen.reference)), seen);
}
#endif
