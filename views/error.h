// How far each ray's hit is from the exact one.
#ifdef __cplusplus
{.name = "error",
 .title = "Error of the hit's distance",
 .unit = "cell edges",
 .about = "Between the hit and the exact hit, along the ray; dark where either of them is missing.",
 .scope = ViewScope::ray,
 .range = ViewRange::automatic,
 .need = ViewNeed::truth},
#else
ViewElement viewElement(uint pixel) {
  RayTruth truth = truthOf(pixel);
  bool both = truth.exactReference != kNoReference && (hits[pixel].kind == kHitTriangle || hits[pixel].kind == kHitVoxel);
  return both ? valueElement(abs(truth.error)) : noElement();
}
#endif
