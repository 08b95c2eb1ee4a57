// How far each ray went.
#ifdef __cplusplus
{.name = "hit-distance",
 .title = "Distance of the hit along the ray",
 .unit = "world units",
 .about = "From where the ray starts to its triangle or voxel hit; a miss is dark.",
 .scope = ViewScope::ray,
 .range = ViewRange::automatic},
#else
ViewElement viewElement(uint pixel) {
  Hit hit = hits[pixel];
  return hit.kind == kHitTriangle || hit.kind == kHitVoxel ? valueElement(hit.t) : noElement();
}
#endif
