// A colour for each instance.
#ifdef __cplusplus
{.name = "instance",
 .title = "Instance",
 .unit = "",
 .about = "One colour for each instance, the high half of a reference.",
 .scope = ViewScope::surface},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  return paintedElement(colourElement(idColour(referenceInstance(seen.reference))), seen);
}
#endif
