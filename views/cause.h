// Why each ray differs from the exact one.
#ifdef __cplusplus
{.name = "cause",
 .title = "Why the ray differs",
 .unit = "",
 .about = "The first event along the ray that makes it differ from the exact hit; where it agrees the picture is dimmed.",
 .scope = ViewScope::ray,
 .need = ViewNeed::truth,
 .marks =
     "refused, stepped over, revisit, segment end, accepted early, gate, filled early, alpha, self-hit, outside, left out, "
     "stale, not inserted, segment limit, numeric"},
#else
ViewElement viewElement(uint pixel) {
  uint cause = truthOf(pixel).cause;
  if (cause == kCauseNone) return litElement(colourElement(toneMapped(finalLight(pixel))), 1.0 / 3.0);
  return cause == kCauseRefused ? markedElement(1.0) : colourElement(unpackColour(causeColour(cause)));
}
#endif
