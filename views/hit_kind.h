// What each ray ended with.
#ifdef __cplusplus
{.name = "hit-kind",
 .title = "How the ray ended",
 .unit = "",
 .about = "A triangle, a gap that a saturated cell filled, or nothing.",
 .scope = ViewScope::ray,
 .marks = "triangle hit, voxel hit, miss"},
#else
ViewElement viewElement(uint pixel) {
  uint kind = hits[pixel].kind;
  if (kind == kHitNoRay) return noElement();
  if (kind == kHitTriangle) return colourElement(unpackColour(kColourTriangleHit));
  if (kind == kHitVoxel) return colourElement(unpackColour(kColourVoxelHit));
  return colourElement(unpackColour(kColourMiss));
}
#endif
