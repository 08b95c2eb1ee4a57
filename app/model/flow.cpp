// See flow.h. jumps.cpp has the ways to the next ray of a kind and the next cell.
#include "app/model/flow.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/frame/camera_moves.h"
#include "app/frame/changes.h"
#include "app/frame/projection.h"
#include "app/model/comparison.h"
#include "app/model/held_ray.h"
#include "app/model/ray_stepping.h"
#include "app/model/selection_carry.h"
#include "app/model/stale_values.h"
#include "views/view.h"

namespace gridscope {

static constexpr size_t kMostRecentFiles = 12;

std::set<std::string> shownViews(const WindowModel& model) {
  std::set<std::string> views;
  const int panes = model.layout == ViewportLayout::four ? 4 : 1;
  for (int i = 0; i < panes; ++i)
    views.insert(model.panes[model.layout == ViewportLayout::four ? size_t(i) : size_t(model.activePane)].view);
  if (model.layout == ViewportLayout::compare && model.comparison.with == CompareState::With::view)
    views.insert(model.panes[size_t(model.activePane) ^ 1u].view);
  return views;
}

FrameRequest requestOf(const WindowModel& model) {
  FrameRequest request = model.request;
  if (request.settings) request.settings->camera = model.camera.pose;
  if (rayIsHeld(model))
    request.recordPixel.reset();
  else
    request.recordPixel = model.selected().pixel;
  request.views = shownViews(model);
  if (model.comparison.completing) request.views.merge(viewsToKeep(model));
  for (const std::string& name : request.views) {
    const View* view = findView(name);
    if (view && (view->need == ViewNeed::truth || view->need == ViewNeed::triangleCosts) && !model.truthDeclined) request.truth = true;
  }
  // One ray's proof takes no time worth waiting for.
  if (request.truth && model.frame && model.frame->truths) request.proveRecorded = true;
  return request;
}

static bool sameOptionalSettings(const std::optional<FrameSettings>& a, const std::optional<FrameSettings>& b) {
  return a.has_value() == b.has_value() && (!a || sameSettings(*a, *b));
}

bool sameRequest(const FrameRequest& a, const FrameRequest& b) {
  return a.source == b.source && sameOptionalSettings(a.settings, b.settings) && a.edits == b.edits && a.frame == b.frame &&
         a.timeSeconds == b.timeSeconds && a.views == b.views && a.slice.axis == b.slice.axis && a.slice.index == b.slice.index &&
         a.truth == b.truth && a.recordPixel == b.recordPixel && a.proveRecorded == b.proveRecorded && a.proveAll == b.proveAll &&
         a.shaderReloads == b.shaderReloads;
}

// A new scene: what pointed into the old one goes.
static void greetScene(WindowModel& model) {
  const FrameSnapshot& frame = *model.frame;
  model.selection = SelectionHistory();
  model.held.reset();
  model.area.reset();
  model.rayOrder = {};
  model.undo.clear();
  model.request.edits = frame.request.edits;
  model.request.settings = frame.request.settings;
  model.camera.pose = frame.request.settings->camera;
  model.camera.speed = 0.1f * glm::distance(frame.scene->bounds.low, frame.scene->bounds.high);
  model.overlays.clipBox = frame.scene->bounds;
  for (ViewportPlace& place : model.places) place = {};
  model.bookmarksOf = bookmarkKey(frame.scene->path);
  model.bookmarks = model.savedBookmarks[model.bookmarksOf];
  if (!std::filesystem::exists(frame.scene->path)) return;  // built in
  const std::string path = std::filesystem::absolute(frame.scene->path).lexically_normal().string();
  std::erase(model.recentFiles, path);
  model.recentFiles.insert(model.recentFiles.begin(), path);
  if (model.recentFiles.size() > kMostRecentFiles) model.recentFiles.resize(kMostRecentFiles);
}

// The same scene with other references, or a frame of another size: the selection goes along.
static void carrySelection(WindowModel& model, const FrameSnapshot& before) {
  const FrameSnapshot& now = *model.frame;
  if (before.scene != now.scene && !sameNumbering(before.scene->numbered, now.scene->numbered)) {
    model.selection.change([&](const Selection& one) { return carriedToNumbering(one, before.scene->numbered, now.scene->numbered); });
    model.held.reset();  // names the old references
  }
  const auto sizeOf = [](const FrameSnapshot& frame) { return uvec2(frame.request.settings->width, frame.request.settings->height); };
  const uvec2 was = sizeOf(before), is = sizeOf(now);
  if (was == is) return;
  model.selection.change([&](const Selection& one) { return carriedToSize(one, was, is); });
  model.area = carriedToSize(model.area, was, is);
  model.rayOrder = {};
}

void takeFrame(WindowModel& model, std::shared_ptr<const FrameSnapshot> frame) {
  const bool anotherScene = frame->scene && (!model.frame || !model.frame->scene || model.frame->request.source != frame->request.source);
  completeKept(model, frame);
  const std::shared_ptr<const FrameSnapshot> before = std::exchange(model.frame, std::move(frame));
  model.stageHistory.note(*model.frame);
  if (anotherScene && model.frame->request.settings)
    greetScene(model);
  else if (before && before->scene && model.frame->scene && before->request.settings && model.frame->request.settings)
    carrySelection(model, *before);
  if (!model.frame->fault.empty()) {
    // What can't be had is no longer asked for.
    model.announce(LogLine::Kind::error, model.frame->fault);
    if (model.frame->request.settings) {
      if (model.request.source != model.frame->request.source) {  // opening a file had set these back
        model.request.frame = model.frame->request.frame;
        model.request.timeSeconds = model.frame->request.timeSeconds;
      }
      model.request.source = model.frame->request.source;
      model.request.edits = model.frame->request.edits;
      model.request.settings = model.frame->request.settings;
    }
  }
  if (model.pendingJump != Jump::none && model.frame->truths) jumpTo(model, std::exchange(model.pendingJump, Jump::none));
}

void openSource(WindowModel& model, const std::string& path) {
  if (std::filesystem::path(path).extension() == ".npy") return useRaysOf(model, path);
  const uint32_t loads = model.request.source.loadCount + 1;
  model.request.source = {.scene = path, .loadCount = loads};
  model.request.settings.reset();
  model.request.edits.clear();
  model.request.frame = 0;
  model.request.timeSeconds = 0.0;
  model.playing = false;
}

void useRaysOf(WindowModel& model, const std::string& path) {
  if (model.frame && model.frame->scene && model.frame->scene->captureFrames > 0)
    return model.showMessage(path + ": a capture has rays of its own; open a scene first");
  model.request.source.rays = path;
}

void setTime(WindowModel& model, double seconds) {
  model.request.timeSeconds = std::max(seconds, 0.0);
  model.request.frame = uint32_t(std::lround(model.request.timeSeconds / std::max(model.timeStep, 1e-6)));
}

void showCapturedFrame(WindowModel& model, uint32_t frame) {
  const std::vector<CameraPose>& cameras = model.frame->scene->cameras;
  const bool each = cameras.size() > 1 && cameras.size() == model.frame->scene->captureFrames;
  if (each && sameCamera(model.camera.pose, cameras[model.request.frame % cameras.size()]))
    model.camera.pose = cameras[frame % cameras.size()];
  model.request.frame = frame;
}

void stepTime(WindowModel& model, int frames) {
  const uint32_t captured = model.frame && model.frame->scene ? model.frame->scene->captureFrames : 0;
  int64_t next = int64_t(model.request.frame) + frames;
  if (captured > 0) return showCapturedFrame(model, uint32_t((next + captured) % captured));
  next = std::max<int64_t>(next, 0);
  model.request.timeSeconds = std::max(0.0, model.request.timeSeconds + double(next - int64_t(model.request.frame)) * model.timeStep);
  model.request.frame = uint32_t(next);
}

// The camera goes to what is wanted, unless its middle is in the picture already.
static void focusOnWanted(WindowModel& model) {
  if (!model.focusWanted) return;
  const Bounds wanted = *model.focusWanted;
  model.focusWanted.reset();
  if (wanted.empty() || !model.frame || !model.frame->request.settings) return;
  const vec3 middle = 0.5f * (wanted.low + wanted.high);
  if (!inPicture(model.camera.pose, *model.frame->request.settings, middle))
    focusCamera(model.camera, wanted);
  else if (const auto point = projectPoint(model.frame->parameters.camera, middle))
    model.pixelWanted = point->pixel;
}

void advanceModel(WindowModel& model) {
  focusOnWanted(model);
  holdRay(model);
  noteStale(model);
  if (!model.bookmarksOf.empty()) model.savedBookmarks[model.bookmarksOf] = model.bookmarks;
  static double nextStepDue = 0.0;
  advancePlay(model, nextStepDue);
  followStep(model);
  if (model.playing && model.frame && !model.frame->stale && model.frame->request.frame == model.request.frame &&
      model.frame->request.timeSeconds == model.request.timeSeconds)
    stepTime(model, 1);
}

void showIn(WindowModel& model, Workspace workspace) {
  model.workspace = workspace;
  model.truthDeclined = false;
  model.activePane = 0;
  Overlays& overlays = model.overlays;
  switch (workspace) {
    case Workspace::grid:
      model.layout = ViewportLayout::one;
      model.panes[0] = {"occupancy"};
      overlays.saturatedBoxes = true,
      overlays.cellBoxes = overlays.raySegments = overlays.visitedCells = overlays.testedTriangles = overlays.dimmed = false;
      model.showTab(BottomTab::plots);
      break;
    case Workspace::ray:
      model.layout = ViewportLayout::one;
      model.panes[0] = {"final"};
      overlays.raySegments = overlays.visitedCells = overlays.testedTriangles = overlays.dimmed = true;
      overlays.saturatedBoxes = overlays.cellBoxes = false;
      model.showTab(BottomTab::steps);
      break;
    case Workspace::verdict:
      model.layout = ViewportLayout::four;
      model.panes = {Pane{"final"}, Pane{"verdict"}, Pane{"cause"}, Pane{"visits"}};
      overlays.saturatedBoxes = overlays.cellBoxes = overlays.raySegments = overlays.visitedCells = overlays.testedTriangles =
          overlays.dimmed = false;
      model.request.truth = true;
      model.showTab(BottomTab::causes);
      break;
    case Workspace::tune:
      model.layout = ViewportLayout::one;
      model.panes[0] = {"final"};
      overlays.saturatedBoxes = overlays.cellBoxes = false;
      model.showTab(BottomTab::plots);
      break;
  }
  overlays.selection = true;
}

void showView(WindowModel& model, const std::string& view) {
  if (!findView(view)) return;
  model.panes[size_t(model.activePane)] = {view};
}

void declineTruth(WindowModel& model) {
  model.truthDeclined = true;
  model.request.truth = model.request.proveRecorded = false;
  model.pendingJump = Jump::none;
}

bool opensAnother(const WindowModel& model) {
  return !model.request.settings || (model.frame && model.request.source != model.frame->request.source);
}

void undoSetting(WindowModel& model) {
  if (model.undo.empty() || opensAnother(model)) return;
  model.request.settings = model.undo.back();
  model.undo.pop_back();
}

std::string windowTitle(const WindowModel& model) {
  if (!model.frame || !model.frame->scene) return "Gridscope";
  return model.frame->scene->name + " - Gridscope";
}

}  // namespace gridscope
