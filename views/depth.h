// Distance from the eye.
#ifdef __cplusplus
{.name = "depth",
 .title = "Distance from the eye",
 .unit = "world units",
 .about = "Straight from the eye to the surface seen.",
 .scope = ViewScope::surface,
 .range = ViewRange::extent},
#else
ViewElement viewElement(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  return seen.reference == kNoReference ? noElement() : valueElement(seen.depth);
}
#endif
