// What the last update changed in one layer of cells.
#ifdef __cplusplus
{.name = "update-slice",
 .title = "Cells of a layer that the last update changed",
 .unit = "",
 .about =
     "In the colour of the instance that caused it: filled cells; darker, cells that were only cleared; dim, cells that hold what they "
     "held.",
 .scope = ViewScope::slice,
 .need = ViewNeed::cellUpdates,
 .marks = "filled, cleared dark, kept"},
#else
ViewElement viewElement(uint element) {
  ivec3 cell = sliceCell(gridParameters().cellCount, parameters.view.sliceAxis, parameters.view.sliceIndex, element);
  if (!gridContains(gridParameters(), cell)) return noElement();
  CellUpdate update = updateOf(cell);
  if (update.instance == kNoReference) return noElement();
  return updateElement(update, uvec2(4u, 0u));
}
#endif
