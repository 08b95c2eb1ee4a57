// Colour of the material alone.
#ifdef __cplusplus
{.name = "albedo",
 .title = "Albedo",
 .unit = "",
 .about = "Base colour times vertex colour times diffuse map, without light.",
 .scope = ViewScope::surface},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return noElement();
  return colourElement(srgbEncode(gatheredSurface(seen).albedo));
}
#endif
