// Triangles that each ray tested.
#ifdef __cplusplus
{.name = "tests",
 .title = "Triangle tests of the ray",
 .unit = "tests",
 .about = "Triangles that the pixel's ray was tested against: what full cells cost.",
 .scope = ViewScope::ray,
 .range = ViewRange::automatic,
 .needsCounters = true},
#else
ViewElement viewElement(uint pixel) { return hits[pixel].kind == kHitNoRay ? noElement() : valueElement(float(counters[pixel].tests)); }
#endif
