// One layer of cells.
#ifdef __cplusplus
{.name = "slice",
 .title = "References stored in a layer's cells",
 .unit = "references",
 .about = "One layer of cells, seen from the side or from above; nearly black cells are empty, hatched ones were full and refused some.",
 .scope = ViewScope::slice,
 .range = ViewRange::capacity,
 .needsGrid = true,
 .marks = "saturated"},
#else
ViewElement viewElement(uint element) {
  ivec3 cell = sliceCell(gridParameters().cellCount, parameters.view.sliceAxis, parameters.view.sliceIndex, element);
  if (!gridContains(gridParameters(), cell)) return noElement();
  ViewElement shown = occupancyElement(cell);
  return shown.kind == kElementValue && uintBitsToFloat(shown.payload) == 0.0 ? litElement(shown, 0.3) : shown;
}
#endif
