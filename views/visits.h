// Cells that each ray read.
#ifdef __cplusplus
{.name = "visits",
 .title = "Cells visited by the ray",
 .unit = "cells",
 .about = "Cells whose first slot the pixel's ray read; an empty cell costs one read.",
 .scope = ViewScope::ray,
 .range = ViewRange::automatic,
 .needsCounters = true},
#else
ViewElement viewElement(uint pixel) { return hits[pixel].kind == kHitNoRay ? noElement() : valueElement(float(counters[pixel].visits)); }
#endif
