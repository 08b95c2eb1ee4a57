// What each ray is worth beside the exact one.
#ifdef __cplusplus
{.name = "verdict",
 .title = "Verdict on the ray",
 .unit = "",
 .about = "Rays that differ from the exact hit among all triangles; where they agree the picture is dimmed.",
 .scope = ViewScope::ray,
 .need = ViewNeed::truth,
 .marks = "hole, voxel right, voxel wrong, too far, too near"},
#else
ViewElement viewElement(uint pixel) {
  uint verdict = truthOf(pixel).verdict;
  if (verdict == kVerdictNoRay || verdict == kVerdictAgrees) return litElement(colourElement(toneMapped(finalLight(pixel))), 1.0 / 3.0);
  return colourElement(unpackColour(verdictColour(verdict)));
}
#endif
