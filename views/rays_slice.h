// How often the cells of one layer are asked.
#ifdef __cplusplus
{.name = "rays-slice",
 .title = "Rays that asked a layer's cells",
 .unit = "rays",
 .about = "Rays that read the cell; of an empty cell, in half the brightness, rays that found it empty; nearly black: none.",
 .scope = ViewScope::slice,
 .range = ViewRange::automatic,
 .need = ViewNeed::cellRays},
#else
ViewElement viewElement(uint element) {
  ivec3 cell = sliceCell(gridParameters().cellCount, parameters.view.sliceAxis, parameters.view.sliceIndex, element);
  if (!gridContains(gridParameters(), cell)) return noElement();
  CellRays asked = raysOf(cell);
  if (asked.read != 0u) return valueElement(float(asked.read));
  return litElement(valueElement(float(asked.empty)), asked.empty != 0u ? 0.5 : 0.3);
}
#endif
