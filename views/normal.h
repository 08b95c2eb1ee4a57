// Direction of the shading normal.
#ifdef __cplusplus
{.name = "normal",
 .title = "Shading normal",
 .unit = "",
 .about = "Red, green and blue are x, y and z in world space; -1 is black, +1 is full.",
 .scope = ViewScope::surface},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  return colourElement(0.5 + 0.5 * seen.shadingNormal);
}
#endif
