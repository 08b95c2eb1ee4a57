// The left panel: the scene, and everything that a frame depends on. A change reruns only the stages that it feeds. settings_view.cpp has
// what changes the picture alone: overlays, camera, bookmarks.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/base/text.h"
#include "app/model/flow.h"
#include "app/ui/shell/layout.h"
#include "app/ui/widgets/action_button.h"
#include "app/ui/widgets/rows.h"
#include "core/grid/derive.h"

namespace gridscope {

namespace {

// --- Scene ------------------------------------------------------------------------------------------------------------------------

// A number that is taken over when it is entered, not while it is typed: true then.
bool enteredNumber(const char* id, int& value, int step = 0) {
  ImGui::PushFont(windowFonts().mono);
  const bool entered = ImGui::InputInt(id, &value, step, 4 * step, ImGuiInputTextFlags_EnterReturnsTrue);
  const bool left = entered || ImGui::IsItemDeactivatedAfterEdit();
  ImGui::PopFont();
  whyLocked();
  return left;
}

// Added teapots, and how many of them move. Both load the scene again.
void drawTeapots(WindowModel& model) {
  static constexpr int kMostTeapots = 64;
  FrameSource& source = model.request.source;
  static int teapots = 0, moving = 0;
  if (!ImGui::IsAnyItemActive()) teapots = int(source.teapots), moving = int(source.moving.value_or(source.teapots));
  rowLabel("Teapots", "Animated teapots to add; the scene is loaded again");
  if (enteredNumber("##teapots", teapots, 1)) {
    teapots = std::clamp(teapots, 0, kMostTeapots);
    if (source.moving && int(*source.moving) > teapots) source.moving.reset();
    source.teapots = uint32_t(teapots);
  }
  if (source.teapots == 0) return;
  rowLabel("Of them moving", "The others stand still and belong to the static grid");
  if (!enteredNumber("##moving", moving, 1)) return;
  moving = std::clamp(moving, 0, int(source.teapots));
  source.moving = moving == int(source.teapots) ? std::nullopt : std::optional(uint32_t(moving));
}

void takeSize(WindowModel& model, int width, int height) {
  static constexpr int kMostPixels = 16384;  // a side; what the device can't hold it refuses by name
  const auto w = uint32_t(std::clamp(width, 1, kMostPixels)), h = uint32_t(std::clamp(height, 1, kMostPixels));
  const FrameSettings& now = *model.request.settings;
  if (w != now.width || h != now.height) model.changeSettings([&](FrameSettings& settings) { settings.width = w, settings.height = h; });
}

// Width and height, to type or to take from a list.
void drawSize(WindowModel& model) {
  static constexpr std::pair<int, int> kSizes[] = {{160, 90}, {320, 180}, {640, 360}, {960, 540}, {1280, 720}, {1920, 1080}};
  static int width = 0, height = 0;
  const FrameSettings& settings = *model.request.settings;
  if (!ImGui::IsAnyItemActive()) width = int(settings.width), height = int(settings.height);
  rowLabel("Frame size", "Pixels of the frame, one ray each");
  const float arrow = ImGui::GetFrameHeight(), gap = unit(4),
              each = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - arrow - 2.0f * gap));
  ImGui::SetNextItemWidth(each);
  if (enteredNumber("##width", width)) takeSize(model, width, height);
  whyTooltip("Width, pixels");
  ImGui::SameLine(0.0f, gap);
  ImGui::SetNextItemWidth(each);
  if (enteredNumber("##height", height)) takeSize(model, width, height);
  whyTooltip("Height, pixels");
  ImGui::SameLine(0.0f, gap);
  if (!ImGui::BeginCombo("##sizes", "", ImGuiComboFlags_NoPreview | ImGuiComboFlags_PopupAlignLeft)) return;
  for (const auto& [w, h] : kSizes)
    if (ImGui::Selectable(printed("%d x %d", w, h).c_str(), int(settings.width) == w && int(settings.height) == h)) takeSize(model, w, h);
  ImGui::EndCombo();
}

void drawScene(WindowModel& model) {
  const FrameSnapshot& frame = *model.frame;
  const SceneFacts& facts = *frame.scene;
  if (!sectionHeader("Scene", facts.name)) return;
  factRow("Triangles", grouped(facts.numbered.triangleCount));
  const auto dynamic = facts.numbered.dynamicInstanceCount();
  factRow("Instances", printed("%u static, %u dynamic", facts.numbered.staticInstanceCount, dynamic));
  if (facts.captureFrames > 0)
    factRow("Captured", printed("%u frame%s", facts.captureFrames, facts.captureFrames == 1 ? "" : "s"));
  else
    factRow("Animation", facts.duration > 0.0 ? printed("%.2f s", facts.duration) : "none");
  if (!facts.note.empty()) ImGui::TextWrapped("%s", facts.note.c_str());
  if (facts.captureFrames == 0) drawTeapots(model);
  {
    const Locked locked(model.request.source.rays.empty() ? "" : "As many pixels as the file has rays");
    drawSize(model);
  }
  {
    const Locked locked(facts.captureFrames > 0 ? "A capture holds no diffuse maps" : "");
    rowLabel("Texture size", "Texels of a diffuse map's side on the device; the scene is prepared again");
    choiceRow<uint32_t>(model, "##texture", model.request.settings->textureSize,
                        {{"64", 64}, {"128", 128}, {"256", 256}, {"512", 512}, {"1024", 1024}, {"2048", 2048}},
                        [](FrameSettings& s, uint32_t v) { s.textureSize = v; });
  }
  for (const std::string& warning : facts.warnings) {
    swatch(kColourVoxelHit);
    ImGui::TextWrapped("%s", warning.c_str());
  }
  if (!model.request.edits.empty() && ImGui::Button(printed("Undo %zu edits of instances", model.request.edits.size()).c_str()))
    model.request.edits.clear();
}

// --- Grid -------------------------------------------------------------------------------------------------------------------------

// Cells along the longest side, or their edge: what was changed last counts, the other follows from it.
void drawCellSize(WindowModel& model, const GridParameters& shape) {
  const GridSettings& grid = model.request.settings->grid;
  const bool byEdge = grid.cellEdge > 0.0f;
  // A cell more lies on each side of the bounds.
  const int longest = std::max({shape.cellCount.x, shape.cellCount.y, shape.cellCount.z}) - 2;
  rowLabel("Cells, longest side", byEdge ? "What the cell edge below gives; dragging it sets the number instead" : "");
  sliderRow(model, "##cells", byEdge ? std::max(longest, 2) : int(grid.cells), {8, 1024, true}, {2, 4096},
            [](FrameSettings& s, int v) { s.grid.cells = uint32_t(v), s.grid.cellEdge = 0.0f; });
  rowLabel("Cell edge", byEdge ? "World units" : "World units; what the number of cells gives. Dragging it sets the edge instead");
  const float edge = byEdge ? grid.cellEdge : shape.cellEdge;
  numberRow(model, "##edge", edge, 0.005f * edge, {1e-6f, 1e6f}, "%.4g", [](FrameSettings& s, float v) { s.grid.cellEdge = v; });
}

// The scene's bounds, or a person's.
void drawBounds(WindowModel& model) {
  const GridSettings& grid = model.request.settings->grid;
  rowLabel("Bounds", "What the grid covers; triangles outside are not tried, and counted");
  choiceRow<bool>(model, "##bounds", grid.bounds.has_value(), {{"Of the scene", false}, {"Typed", true}},
                  [&](FrameSettings& s, bool typed) { s.grid.bounds = typed ? std::optional(model.frame->scene->bounds) : std::nullopt; });
  if (!grid.bounds) return;
  static constexpr const char* kNames[2] = {"Low", "High"};
  for (int end = 0; end < 2; ++end) {
    vec3 corner = end == 0 ? grid.bounds->low : grid.bounds->high;
    rowLabel(kNames[end]);
    ImGui::PushID(end);
    ImGui::PushFont(windowFonts().mono);
    const bool changed = ImGui::DragFloat3("##corner", &corner.x, 0.05f * model.frame->parameters.grid.cellEdge, 0.0f, 0.0f, "%.2f");
    ImGui::PopFont();
    ImGui::PopID();
    whyLocked();
    Bounds wanted = *grid.bounds;
    (end == 0 ? wanted.low : wanted.high) = corner;
    const bool holds = glm::all(glm::lessThan(wanted.low, wanted.high)) && glm::all(glm::lessThan(glm::abs(corner), vec3(1e6f)));
    applyChange(model, changed && holds, [&](FrameSettings& settings) { settings.grid.bounds = wanted; });
  }
}

void drawGrid(WindowModel& model) {
  const GridParameters& shape = model.frame->parameters.grid;
  const SceneFacts& facts = *model.frame->scene;
  if (!sectionHeader("Grid", printed("%d x %d x %d", shape.cellCount.x, shape.cellCount.y, shape.cellCount.z))) return;
  {
    const Locked locked(facts.foreign ? "Another engine's grid: it is shown as it is" : "");
    const GridSettings& grid = model.request.settings->grid;
    drawCellSize(model, shape);
    rowLabel("Capacity", "Slots of a cell");
    sliderRow(model, "##capacity", int(grid.capacity), {1, 512, true}, {1, 4096},
              [](FrameSettings& s, int v) { s.grid.capacity = uint32_t(v); });
    rowLabel("Overlap", "The test that lets a cell take a triangle");
    choiceRow<uint32_t>(model, "##overlap", grid.overlap, {{"Plane (paper)", kOverlapPlane}, {"Exact", kOverlapExact}},
                        [](FrameSettings& s, uint32_t v) { s.grid.overlap = v; });
    rowLabel("Enlargement", "Of the cell in the overlap test");
    sliderRow(model, "##enlargement", grid.enlargement, {1.0f, 1.25f}, {0.01f, 10.0f}, "%.3f",
              [](FrameSettings& s, float v) { s.grid.enlargement = v; });
    rowLabel("Insertion", "Sorted: the same grid in every run; first come: the paper's");
    choiceRow<uint32_t>(model, "##insertion", grid.insertion, {{"Sorted", kInsertionSorted}, {"First come (paper)", kInsertionFirstCome}},
                        [](FrameSettings& s, uint32_t v) { s.grid.insertion = v; });
    {
      const Locked numbers(facts.captureFrames > 0 && !facts.foreign ? "A capture's references keep their numbers" : "");
      rowLabel("Numbering", "Order of the references: full cells refuse the last");
      choiceRow<NumberBy>(model, "##number", grid.numberBy, {{"File order", NumberBy::file}, {"Falling area", NumberBy::area}},
                          [](FrameSettings& s, NumberBy v) { s.grid.numberBy = v; });
    }
    rowLabel("Builder", "Both make the same bits");
    choiceRow<Builder>(model, "##builder", grid.builder, {{"Compute", Builder::compute}, {"Raster (paper)", Builder::raster}},
                       [](FrameSettings& s, Builder v) { s.grid.builder = v; });
    rowLabel("Update", "All: every dynamic instance anew; moved: only what moved");
    choiceRow<UpdateMode>(model, "##update", grid.update, {{"All (paper)", UpdateMode::all}, {"Moved", UpdateMode::moved}},
                          [](FrameSettings& s, UpdateMode v) { s.grid.update = v; });
    rowLabel("Stretched axis", "Axis of the image along which a cell's slots lie");
    choiceRow<Stretch>(model, "##stretch", grid.stretch,
                       {{"Automatic", Stretch::automatic}, {"x", Stretch::x}, {"y", Stretch::y}, {"z", Stretch::z}},
                       [](FrameSettings& s, Stretch v) { s.grid.stretch = v; });
    drawBounds(model);
  }
  const StorageFacts storage = storageFacts(shape);
  factRow("Image", printed("%d x %d x %d (%c)", storage.extent.x, storage.extent.y, storage.extent.z, storage.stretchedAxis));
  factRow("Memory", byteText(gridByteCount(shape)));
}

// --- Rays -------------------------------------------------------------------------------------------------------------------------

// The bounce's, or those of a .npy file.
void drawRays(WindowModel& model) {
  static std::string path;
  static bool typing = false;
  if (!typing) path = model.request.source.rays;
  rowLabel("Rays",
           "Of the glossy bounce; or a .npy file with rays of your own, origin and direction: type its path and press Enter, or drop it on "
           "the window");
  const bool entered = ImGui::InputTextWithHint("##rays", "of the bounce", &path, ImGuiInputTextFlags_EnterReturnsTrue);
  typing = ImGui::IsItemActive();
  whyTooltip(path.c_str());
  whyLocked();
  if (entered) useRaysOf(model, path);
}

// --- Trace ------------------------------------------------------------------------------------------------------------------------

void drawTrace(WindowModel& model) {
  const FrameSettings& settings = *model.request.settings;
  const TraceSettings& trace = settings.trace;
  if (!sectionHeader("Trace", printed("%u x %u", settings.width, settings.height))) return;
  rowLabel("Traversal", "Segment: cell-sized steps, the paper's; dda: every cell that the ray pierces");
  choiceRow<uint32_t>(model, "##traversal", trace.traversal, {{"Segment (paper)", kTraversalSegment}, {"DDA", kTraversalDda}},
                      [](FrameSettings& s, uint32_t v) { s.trace.traversal = v; });
  {
    const Locked locked(trace.traversal == kTraversalDda ? "Means nothing to DDA: it asks every cell that the ray pierces" : "");
    rowLabel("Reach ahead", "How far a segment reaches beyond its end, in cell edges");
    sliderRow(model, "##ahead", trace.ahead, {0.0f, 4.0f}, {0.0f, 100.0f}, "%.2f cells",
              [](FrameSettings& s, float v) { s.trace.ahead = v; });
    rowLabel("Reach back", "How far it reaches back, in cell edges");
    sliderRow(model, "##back", trace.back, {0.0f, 4.0f}, {0.0f, 100.0f}, "%.2f cells", [](FrameSettings& s, float v) { s.trace.back = v; });
  }
  rowLabel("Gap-filling", "Voxel hits in saturated cells where no triangle was hit");
  choiceRow<bool>(model, "##gap", trace.gapFill, {{"On", true}, {"Off", false}}, [](FrameSettings& s, bool v) { s.trace.gapFill = v; });
  {
    const Locked locked(trace.gapFill ? "" : "Gap-filling is off");
    rowLabel("Gate", "No voxel hit nearer than this to the surface that the ray leaves");
    sliderRow(model, "##gate", trace.gate, {0.0f, 5.0f}, {0.0f, 100.0f}, "%.2f cells", [](FrameSettings& s, float v) { s.trace.gate = v; });
  }
  rowLabel("Self-hit offset", "Nearest hit that counts");
  numberRow(model, "##tmin", trace.tMin, 0.0002f, {0.0f, 10.0f}, "%.4f cells", [](FrameSettings& s, float v) { s.trace.tMin = v; });
  rowLabel("Most segments", "0: enough to cross the grid");
  numberRow(model, "##segments", int(trace.maxSegments), 1.0f, {0, 100000}, trace.maxSegments == 0 ? "enough" : "%d",
            [](FrameSettings& s, int v) { s.trace.maxSegments = uint32_t(v); });
  const bool captured = model.frame->scene->captureFrames > 0, ownRays = !model.request.source.rays.empty();
  {
    const Locked locked(captured ? "A capture has rays of its own" : "");
    drawRays(model);
  }
  const Locked bounce(ownRays ? "The rays come from a file, not from the bounce" : "");
  rowLabel("Roughness", "The most that the bounce gives a material; 1 leaves their own");
  sliderRow(model, "##roughness", settings.bounce.roughness, {0.0f, 1.0f}, {0.0f, 1.0f}, "%.3f",
            [](FrameSettings& s, float v) { s.bounce.roughness = v; });
  rowLabel("Seed", "Of the glossy bounce");
  numberRow(model, "##seed", int(settings.bounce.seed), 0.2f, {0, 1 << 30}, "%d",
            [](FrameSettings& s, int v) { s.bounce.seed = uint32_t(v); });
}

void drawBack(WindowModel& model) {
  if (!ImGui::Button("Back to the scene's own settings")) return;
  const FrameSettings own = model.frame->scene->ownSettings;
  model.changeSettings([&](FrameSettings& s) { s = own; });
}

}  // namespace

void drawSettingsPanel(WindowModel& model) {
  if (!model.frame || !model.frame->scene || !model.request.settings)
    return emptyState(model.work ? model.work->what.c_str() : "Starting the device...");
  drawScene(model);
  drawGrid(model);
  drawTrace(model);
  drawBack(model);
  drawViewSettings(model);
}

}  // namespace gridscope
