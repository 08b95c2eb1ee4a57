// The left panel: the scene, and everything that a frame depends on. A change reruns only the stages that it feeds.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/camera_moves.h"
#include "app/cell_boxes.h"
#include "app/model_flow.h"
#include "app/text.h"
#include "app/window_actions.h"
#include "app/window_panels.h"
#include "app/window_widgets.h"
#include "core/derive.h"

namespace gridscope {

namespace {

constexpr float kLabelWidth = 134;   // pixels at UI scale 1

// A row: the label, and the control that follows takes the rest.
void label(const char* words, const char* about = "") {
  ImGui::AlignTextToFramePadding();
  textDim(words);
  whyTooltip(about);
  ImGui::SameLine(unit(kLabelWidth));
  ImGui::SetNextItemWidth(-1);
}

// Remembers the settings for undo when a control begins to change them; `change` applies what the control holds.
template <typename Change>
void apply(WindowModel& model, bool changed, const Change& change) {
  static FrameSettings before;
  static bool kept = false;
  if (ImGui::IsItemActivated()) before = *model.request.settings, kept = true;
  if (!changed) return;
  // One entry of the undo list for one drag.
  if (kept || !ImGui::IsItemActive()) {
    model.rememberForUndo(kept ? before : *model.request.settings);
    kept = false;
  }
  change(*model.request.settings);
}

template <typename Value>
struct Choice {
  const char* name;
  Value value;
};

template <typename Value, size_t kCount, typename Change>
void choose(WindowModel& model, const char* id, Value now, const Choice<Value> (&choices)[kCount], const Change& change) {
  const char* shown = "";
  for (const auto& choice : choices)
    if (choice.value == now) shown = choice.name;
  if (!ImGui::BeginCombo(id, shown)) return;
  for (const auto& choice : choices)
    if (ImGui::Selectable(choice.name, choice.value == now) && choice.value != now) {
      const Value value = choice.value;
      model.changeSettings([&](FrameSettings& settings) { change(settings, value); });
    }
  ImGui::EndCombo();
}

template <typename Change>
void number(WindowModel& model, const char* id, float now, float speed, float low, float high, const char* format, const Change& change) {
  ImGui::PushFont(windowFonts().mono);
  const bool changed = ImGui::DragFloat(id, &now, speed, low, high, format, ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopFont();
  apply(model, changed && std::isfinite(now), [&](FrameSettings& settings) { change(settings, std::clamp(now, low, high)); });
}

template <typename Change>
void whole(WindowModel& model, const char* id, int now, float speed, int low, int high, const Change& change) {
  ImGui::PushFont(windowFonts().mono);
  const bool changed = ImGui::DragInt(id, &now, speed, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopFont();
  apply(model, changed, [&](FrameSettings& settings) { change(settings, std::clamp(now, low, high)); });
}

void drawScene(WindowModel& model) {
  const FrameSnapshot& frame = *model.frame;
  const SceneFacts& facts = *frame.scene;
  if (!sectionHeader("Scene", facts.name)) return;
  factRow("Triangles", grouped(facts.numbered.triangleCount));
  const auto dynamic = facts.numbered.dynamicInstanceCount();
  factRow("Instances", printed("%u static, %u dynamic", facts.numbered.staticInstanceCount, dynamic));
  if (facts.captureFrames > 0) factRow("Captured", printed("%u frame%s", facts.captureFrames, facts.captureFrames == 1 ? "" : "s"));
  else factRow("Animation", facts.duration > 0.0 ? printed("%.2f s", facts.duration) : "none");
  if (!facts.note.empty()) ImGui::TextWrapped("%s", facts.note.c_str());
  if (facts.captureFrames == 0) {
    label("Teapots", "Animated teapots to add; the scene is loaded again");
    static int teapots = -1;
    if (!ImGui::IsAnyItemActive()) teapots = int(model.request.source.teapots);
    ImGui::PushFont(windowFonts().mono);
    if (ImGui::InputInt("##teapots", &teapots, 1, 4, ImGuiInputTextFlags_EnterReturnsTrue)) {
      model.request.source.teapots = uint32_t(std::clamp(teapots, 0, 64));
      model.request.source.moving.reset();
    }
    ImGui::PopFont();
  }
  label("Frame size", "Pixels of the frame, one ray each");
  static constexpr Choice<int> kSizes[] = {{"160 x 90", 160}, {"320 x 180", 320}, {"640 x 360", 640}, {"960 x 540", 960}, {"1280 x 720", 1280}, {"1920 x 1080", 1920}};
  const FrameSettings& settings = *model.request.settings;
  const std::string size = printed("%u x %u", settings.width, settings.height);
  if (ImGui::BeginCombo("##size", size.c_str())) {
    for (const auto& [name, width] : kSizes)
      if (ImGui::Selectable(name, int(settings.width) == width))
        model.changeSettings([width = width](FrameSettings& s) { s.width = uint32_t(width), s.height = uint32_t(width * 9 / 16); });
    ImGui::EndCombo();
  }
  for (const std::string& warning : facts.warnings) {
    swatch(kColourVoxelHit);
    ImGui::TextWrapped("%s", warning.c_str());
  }
  if (!model.request.edits.empty() && ImGui::Button(printed("Undo %zu edits of instances", model.request.edits.size()).c_str())) model.request.edits.clear();
}

void drawGrid(WindowModel& model) {
  const GridParameters& shape = model.frame->parameters.grid;
  const GridSettings& grid = model.request.settings->grid;
  const bool foreign = model.frame->scene->foreign;
  if (!sectionHeader("Grid", printed("%d x %d x %d", shape.cellCount.x, shape.cellCount.y, shape.cellCount.z))) return;
  ImGui::BeginDisabled(foreign);
  label("Cells, longest side");
  if (grid.cellEdge > 0.0f) number(model, "##edge", grid.cellEdge, 0.001f * grid.cellEdge, 1e-6f, 1e6f, "edge %.4g", [](FrameSettings& s, float v) { s.grid.cellEdge = v; });
  else whole(model, "##cells", int(grid.cells), 0.5f, 2, 1024, [](FrameSettings& s, int v) { s.grid.cells = uint32_t(v); });
  label("Capacity", "Slots of a cell");
  whole(model, "##capacity", int(grid.capacity), 0.2f, 1, 1024, [](FrameSettings& s, int v) { s.grid.capacity = uint32_t(v); });
  label("Overlap", "The test that lets a cell take a triangle");
  choose<uint32_t>(model, "##overlap", grid.overlap, {{"Plane (paper)", kOverlapPlane}, {"Exact", kOverlapExact}}, [](FrameSettings& s, uint32_t v) { s.grid.overlap = v; });
  label("Enlargement", "Of the cell in the overlap test");
  number(model, "##enlargement", grid.enlargement, 0.002f, 0.01f, 10.0f, "%.3f", [](FrameSettings& s, float v) { s.grid.enlargement = v; });
  label("Insertion", "Sorted: the same grid in every run; first come: the paper's");
  choose<uint32_t>(model, "##insertion", grid.insertion, {{"Sorted", kInsertionSorted}, {"First come (paper)", kInsertionFirstCome}},
                   [](FrameSettings& s, uint32_t v) { s.grid.insertion = v; });
  const bool captured = model.frame->scene->captureFrames > 0;
  label("Numbering", captured ? "The references of a capture keep their order: open its scene for another" : "Order of the references: full cells refuse the last");
  ImGui::BeginDisabled(captured);
  choose<NumberBy>(model, "##number", grid.numberBy, {{"File order", NumberBy::file}, {"Falling area", NumberBy::area}},
                   [](FrameSettings& s, NumberBy v) { s.grid.numberBy = v; });
  ImGui::EndDisabled();
  label("Builder", "Both make the same bits");
  choose<Builder>(model, "##builder", grid.builder, {{"Compute", Builder::compute}, {"Raster (paper)", Builder::raster}},
                  [](FrameSettings& s, Builder v) { s.grid.builder = v; });
  label("Update", "All: every dynamic instance anew; moved: only what moved");
  choose<UpdateMode>(model, "##update", grid.update, {{"All (paper)", UpdateMode::all}, {"Moved", UpdateMode::moved}},
                     [](FrameSettings& s, UpdateMode v) { s.grid.update = v; });
  label("Stretched axis", "Axis of the image along which a cell's slots lie");
  choose<Stretch>(model, "##stretch", grid.stretch, {{"Automatic", Stretch::automatic}, {"x", Stretch::x}, {"y", Stretch::y}, {"z", Stretch::z}},
                  [](FrameSettings& s, Stretch v) { s.grid.stretch = v; });
  ImGui::EndDisabled();
  if (foreign) textDim("Another engine's grid: it is shown as it is");
  const ivec3 texels = gridTexelCount(shape);
  factRow("Image", printed("%d x %d x %d (%c)", texels.x, texels.y, texels.z, "xyz"[shape.stretchAxis]));
  factRow("Memory", byteText(gridByteCount(shape)));
  factRow("Cell edge", printed("%.4g", double(shape.cellEdge)));
}

void drawTrace(WindowModel& model) {
  const FrameSettings& settings = *model.request.settings;
  const TraceSettings& trace = settings.trace;
  if (!sectionHeader("Trace", printed("%u x %u", settings.width, settings.height))) return;
  label("Traversal", "Segment: cell-sized steps, the paper's; dda: every cell that the ray pierces");
  choose<uint32_t>(model, "##traversal", trace.traversal, {{"Segment (paper)", kTraversalSegment}, {"DDA", kTraversalDda}},
                   [](FrameSettings& s, uint32_t v) { s.trace.traversal = v; });
  label("Reach ahead", "How far a segment reaches beyond its end, in cell edges");
  number(model, "##ahead", trace.ahead, 0.01f, 0.0f, 100.0f, "%.2f cells", [](FrameSettings& s, float v) { s.trace.ahead = v; });
  label("Reach back", "How far it reaches back, in cell edges");
  number(model, "##back", trace.back, 0.01f, 0.0f, 100.0f, "%.2f cells", [](FrameSettings& s, float v) { s.trace.back = v; });
  label("Gap-filling", "Voxel hits in saturated cells where no triangle was hit");
  choose<bool>(model, "##gap", trace.gapFill, {{"On", true}, {"Off", false}}, [](FrameSettings& s, bool v) { s.trace.gapFill = v; });
  label("Gate", "No voxel hit nearer than this to the surface that the ray leaves");
  ImGui::BeginDisabled(!trace.gapFill);
  number(model, "##gate", trace.gate, 0.01f, 0.0f, 100.0f, "%.2f cells", [](FrameSettings& s, float v) { s.trace.gate = v; });
  ImGui::EndDisabled();
  if (!trace.gapFill) whyTooltip("Gap-filling is off");
  label("Self-hit offset", "Nearest hit that counts");
  number(model, "##tmin", trace.tMin, 0.0002f, 0.0f, 10.0f, "%.4f cells", [](FrameSettings& s, float v) { s.trace.tMin = v; });
  label("Most segments", "0: enough to cross the grid");
  whole(model, "##segments", int(trace.maxSegments), 1.0f, 0, 100000, [](FrameSettings& s, int v) { s.trace.maxSegments = uint32_t(v); });
  label("Roughness", "The most that the bounce gives a material; 1 leaves their own");
  number(model, "##roughness", settings.bounce.roughness, 0.002f, 0.0f, 1.0f, "%.3f", [](FrameSettings& s, float v) { s.bounce.roughness = v; });
  label("Seed", "Of the glossy bounce");
  whole(model, "##seed", int(settings.bounce.seed), 0.2f, 0, 1 << 30, [](FrameSettings& s, int v) { s.bounce.seed = uint32_t(v); });
  if (ImGui::Button("Back to the scene's own settings")) {
    const FrameSettings own = model.frame->scene->ownSettings;
    model.changeSettings([&](FrameSettings& s) { s = own; });
  }
}

void drawOverlaySwitches(WindowModel& model) {
  Overlays& o = model.overlays;
  const int on = o.cellBoxes + o.saturatedBoxes + o.raySegments + o.visitedCells + o.testedTriangles + o.dimmed + o.lens + o.selection + o.clip;
  if (!sectionHeader("Overlays", printed("%d on", on))) return;
  ImGui::Checkbox("Cell boxes", &o.cellBoxes);
  if (o.cellBoxes) {
    label("by", "What a box's colour shows, and which boxes are drawn");
    if (ImGui::BeginCombo("##measure", boxMeasure(o).name)) {
      for (size_t i = 0; i < boxMeasures().size(); ++i)
        if (ImGui::Selectable(boxMeasures()[i].name, i == o.boxMeasure)) o.boxMeasure = i, o.boxRange = Overlays().boxRange;
      ImGui::EndCombo();
    }
    int range[2] = {o.boxRange[0], std::min(o.boxRange[1], 1 << 20)};
    ImGui::SetNextItemWidth(-1);
    if (ImGui::DragIntRange2("##boxes", &range[0], &range[1], 0.3f, 1, 1 << 20, "from %d", range[1] >= 1 << 20 ? "to the most" : "to %d"))
      o.boxRange = {range[0], range[1]};
  }
  ImGui::Checkbox("Saturated cells", &o.saturatedBoxes);
  ImGui::SameLine();
  swatch(kColourSaturated, true);
  ImGui::NewLine();
  ImGui::Checkbox("Ray segments by outcome", &o.raySegments);
  ImGui::Checkbox("Cells the ray visited", &o.visitedCells);
  ImGui::Checkbox("Tested triangles", &o.testedTriangles);
  ImGui::Checkbox("Dim the picture under a ray", &o.dimmed);
  ImGui::Checkbox("Lens on the step's cell", &o.lens);
  ImGui::Checkbox("Selection", &o.selection);
  ImGui::Checkbox("Clip box", &o.clip);
  if (!o.clip || !model.frame->scene) return;
  const Bounds& bounds = model.frame->scene->bounds;
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::PushID(axis);
    label(printed("%c from, to", "xyz"[axis]).c_str());
    const float speed = 0.002f * std::max(bounds.high[axis] - bounds.low[axis], 1e-3f);
    ImGui::DragFloatRange2("##clip", &o.clipBox.low[axis], &o.clipBox.high[axis], speed, bounds.low[axis], bounds.high[axis], "%.2f");
    ImGui::PopID();
  }
}

void drawCamera(WindowModel& model) {
  CameraState& camera = model.camera;
  if (!sectionHeader("Camera", camera.mode == CameraMode::orbit ? "Orbit" : "Fly")) return;
  const std::vector<CameraPose>& cameras = model.frame->scene->cameras;
  label("File's camera");
  if (ImGui::BeginCombo("##cameras", camera.pose.name.empty() ? "moved" : camera.pose.name.c_str())) {
    for (const CameraPose& one : cameras)
      if (ImGui::Selectable(one.name.c_str())) camera.pose = one;
    ImGui::EndCombo();
  }
  ImGui::PushFont(windowFonts().mono);
  const float speed = 0.01f * std::max(camera.speed, 1e-4f);
  CameraPose wanted = camera.pose;
  label("Position");
  bool changed = ImGui::DragFloat3("##eye", &wanted.eye.x, speed, 0, 0, "%.2f");
  label("Looks at");
  changed |= ImGui::DragFloat3("##target", &wanted.target.x, speed, 0, 0, "%.2f");
  if (changed && wanted.eye != wanted.target && glm::length(wanted.eye) < 1e6f && glm::length(wanted.target) < 1e6f) camera.pose = wanted;
  label("Field of view");
  ImGui::SliderFloat("##fov", &camera.pose.verticalFovDegrees, 5.0f, 150.0f, "%.1f deg", ImGuiSliderFlags_AlwaysClamp);
  label("Speed", "Of flying: hold the right mouse button and W A S D Q E");
  ImGui::DragFloat("##speed", &camera.speed, 0.01f * camera.speed, 1e-4f, 1e5f, "%.2f /s", ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
  ImGui::PopFont();
  label("Up axis");
  int up = camera.zUp ? 1 : 0;
  if (ImGui::Combo("##up", &up, "y\0z\0")) {
    camera.zUp = up == 1;
    camera.pose.up = worldUp(camera);
  }
  actionButton(model, "Reset camera", "Reset##camera");
}

void drawBookmarks(WindowModel& model) {
  if (!sectionHeader("Bookmarks", printed("%zu", model.bookmarks.size()), false)) return;
  static std::string name;
  ImGui::SetNextItemWidth(-unit(70));
  const bool entered = ImGui::InputTextWithHint("##name", "Name of this view", &name, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if (ImGui::Button("Keep", {unit(60), 0}) || entered) {
    model.bookmarks.push_back({name.empty() ? printed("view %zu", model.bookmarks.size() + 1) : name, model.camera.pose});
    name.clear();
  }
  size_t removed = model.bookmarks.size();
  for (size_t i = 0; i < model.bookmarks.size(); ++i) {
    ImGui::PushID(int(i));
    if (ImGui::Selectable(model.bookmarks[i].name.c_str(), false, 0, {ImGui::GetContentRegionAvail().x - unit(26), 0})) model.camera.pose = model.bookmarks[i].pose;
    ImGui::SameLine();
    if (ImGui::SmallButton("x")) removed = i;
    ImGui::PopID();
  }
  if (removed < model.bookmarks.size()) model.bookmarks.erase(model.bookmarks.begin() + ptrdiff_t(removed));
}

}  // namespace

void drawSettingsPanel(WindowModel& model) {
  if (!model.frame || !model.frame->scene || !model.request.settings) return emptyState(model.work ? model.work->what.c_str() : "Starting the device...");
  drawScene(model);
  drawGrid(model);
  drawTrace(model);
  drawOverlaySwitches(model);
  drawCamera(model);
  drawBookmarks(model);
}

}  // namespace gridscope
