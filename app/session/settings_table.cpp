// See settings_table.h.
#include "app/session/settings_table.h"

#include "app/base/text.h"

namespace gridscope {

namespace {

std::string vectorText(const vec3& v) { return printed("%.6g, %.6g, %.6g", double(v.x), double(v.y), double(v.z)); }
std::string numberText(float value) { return printed("%g", double(value)); }

std::string cellsText(const GridSettings& grid) { return grid.cellEdge > 0.0f ? "by cell edge" : std::to_string(grid.cells); }
std::string edgeText(const GridSettings& grid) { return grid.cellEdge > 0.0f ? numberText(grid.cellEdge) : "by cells"; }
std::string boundsText(const GridSettings& grid) {
  return grid.bounds ? vectorText(grid.bounds->low) + " to " + vectorText(grid.bounds->high) : "the scene's";
}
std::string stretchText(const GridSettings& grid) {
  return grid.stretch == Stretch::automatic ? "auto" : std::string(1, "xyz"[uint32_t(grid.stretch)]);
}

// One row: the same text function for the value and its default.
template <class Part, class Text>
SettingText setting(const char* option, const Part& part, Text textOf, const char* about) {
  return {option, textOf(part), textOf(Part{}), about};
}

void addGrid(std::vector<SettingText>& rows, const GridSettings& grid) {
  using G = GridSettings;
  rows.push_back(setting("--cells", grid, cellsText, "along the longest side"));
  rows.push_back(setting("--cell-edge", grid, edgeText, "world units"));
  rows.push_back(setting(
      "--capacity", grid, [](const G& g) { return std::to_string(g.capacity); }, "slots of a cell"));
  rows.push_back(setting("--bounds", grid, boundsText, "what the grid covers, world units"));
  rows.push_back(setting("--stretch", grid, stretchText, "axis along which a cell's slots lie"));
  rows.push_back(setting(
      "--builder", grid, [](const G& g) { return std::string(builderWord(g.builder)); }, "both make the same bits"));
  rows.push_back(setting(
      "--insertion", grid, [](const G& g) { return std::string(insertionWord(g.insertion)); }, "which references a full cell keeps"));
  rows.push_back(setting(
      "--overlap", grid, [](const G& g) { return std::string(overlapWord(g.overlap)); }, "test of triangle and cell"));
  rows.push_back(setting(
      "--enlargement", grid, [](const G& g) { return numberText(g.enlargement); }, "of the cell in that test"));
  rows.push_back(setting(
      "--number-by", grid, [](const G& g) { return std::string(numberingWord(g.numberBy)); }, "order of the references"));
  rows.push_back(setting(
      "--update", grid, [](const G& g) { return std::string(updateWord(g.update)); }, "what an update adds again"));
}

void addTrace(std::vector<SettingText>& rows, const TraceSettings& trace) {
  using T = TraceSettings;
  rows.push_back(setting(
      "--traversal", trace, [](const T& t) { return std::string(traversalWord(t.traversal)); }, "how a ray finds its cells"));
  rows.push_back(setting(
      "--back", trace, [](const T& t) { return numberText(t.back); }, "reach of a segment, cell edges"));
  rows.push_back(setting(
      "--ahead", trace, [](const T& t) { return numberText(t.ahead); }, "likewise beyond its end"));
  rows.push_back(setting(
      "--tmin", trace, [](const T& t) { return numberText(t.tMin); }, "nearest hit that counts, cell edges"));
  rows.push_back(setting(
      "--gap-fill", trace, [](const T& t) { return std::string(t.gapFill ? "on" : "off"); }, "voxel hits in saturated cells"));
  rows.push_back(setting(
      "--gate", trace, [](const T& t) { return numberText(t.gate); }, "no voxel hit nearer to the launching surface, cell edges"));
  rows.push_back(setting(
      "--max-segments", trace, [](const T& t) { return t.maxSegments == 0 ? "to cross the grid" : std::to_string(t.maxSegments); },
      "after which a ray ends"));
}

}  // namespace

std::vector<SettingText> settingTexts(const FrameSettings& settings) {
  std::vector<SettingText> rows;
  addGrid(rows, settings.grid);
  addTrace(rows, settings.trace);
  rows.push_back(setting(
      "--seed", settings.bounce, [](const BounceSettings& b) { return std::to_string(b.seed); }, "of the glossy bounce"));
  rows.push_back(setting(
      "--roughness", settings.bounce, [](const BounceSettings& b) { return numberText(b.roughness); },
      "most that the bounce gives a material"));
  rows.push_back(setting(
      "--size", settings, [](const FrameSettings& s) { return printed("%ux%u", s.width, s.height); }, "pixels of the frame"));
  rows.push_back(setting(
      "--texture-size", settings, [](const FrameSettings& s) { return std::to_string(s.textureSize); }, "texels of a diffuse map's side"));
  const CameraPose& camera = settings.camera;
  rows.push_back(
      {"--camera", vectorText(camera.eye) + " to " + vectorText(camera.target) + printed(", %g degrees", double(camera.verticalFovDegrees)),
       "", camera.name.empty() ? "eye, target, vertical field of view" : "\"" + camera.name + "\": eye, target, vertical field of view"});
  return rows;
}

std::string refusedFirst(const GridSettings& settings) {
  if (settings.insertion == kInsertionFirstCome) return "refused first: whatever comes last in the race";
  if (settings.numberBy == NumberBy::area) return "refused first: the smallest triangles, then dynamic instances";
  return "refused first: the highest ids: late meshes, then dynamic instances";
}

}  // namespace gridscope
