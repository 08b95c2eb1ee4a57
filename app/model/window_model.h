// What the panels share: the frame that is shown, what is asked of the worker, what is selected, and how things are shown. Panels read it
// and change it; none knows another. Only what has to do with drawing by ImGui stays out of it.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/frame/messages.h"
#include "app/frame/showing.h"
#include "app/frame/snapshot.h"
#include "app/frame/stage_history.h"
#include "app/jobs/file_jobs.h"
#include "app/jobs/report_job.h"
#include "app/model/selection.h"

namespace gridscope {

enum class Workspace { grid, ray, verdict, tune };
enum class BottomTab { steps, cells, instances, triangles, rays, causes, plots, tune, log };
inline constexpr size_t kBottomTabCount = size_t(BottomTab::log) + 1;
enum class ViewportLayout { one, four, compare };  // compare: A beside B, by wipe or flip
enum class Theme { dark, light };

// What A/B shows beside the live frame.
struct CompareState {
  enum class With { view, frame } with = With::view;  // another view of this frame, or the kept frame
  std::shared_ptr<const FrameSnapshot> kept;          // a frame with other settings, or of a capture
  bool completing = false;                            // views that it lacks are on their way
  bool flip = false;                                  // showing B where A was; with a wipe: the sides are exchanged
  bool wipes = true;                                  // both, with a split between them that can be dragged
  float split = 0.5f;
};

// The selected ray, and from where it was recorded.
struct HeldRay {
  std::shared_ptr<const RecordedRay> ray;  // never null
  CameraPose pose;
  std::shared_ptr<const Grid> grid;  // that it went through
  TraceParameters trace{};           // and by which rules
};

// Values on show that are of a request before, because their stages run again.
struct StaleValues {
  bool grid = false;   // cells, references, totals
  bool rays = false;   // hits, verdicts
  bool steps = false;  // of the selected ray; one that is held is never stale
};

// Sizes of the regions beside and below the viewport, pixels at UI scale 1.
struct Splits {
  float left = 300.0f;
  float right = 380.0f;
  float bottom = 248.0f;
};

// Where to go once the truth is told.
enum class Jump { none, nextHole, nextVoxelWrong };

struct WindowModel {
  // The worker.
  FrameRequest request;                        // what is wanted now; changes are sent once a display frame
  std::shared_ptr<const FrameSnapshot> frame;  // what there is; null until the first
  std::optional<LongWork> work;
  bool cancelWork = false;                   // set by a Cancel button
  std::optional<CaptureWish> captureWish;    // handed to the worker once
  std::optional<std::string> clipboardWish;  // text for the clipboard, taken once
  FileJobs files;                            // on their way to the disk
  ReportJob report;
  std::string startDevice;  // that --device named
  Jump pendingJump = Jump::none;
  bool truthDeclined = false;       // cancelled: views that show it do not ask for it by themselves
  std::string shaderFault;          // the compiler's text of the last F5; empty: shaders are current
  StaleValues stale;                // noted once a display frame (stale_values.h)
  double freshAt = 0.0;             // when nothing was stale last, seconds since the start
  StageHistory stageHistory;        // noted with every new snapshot
  std::vector<FrameSettings> undo;  // settings before each change, last at the end

  // Selection.
  SelectionHistory selection;
  std::optional<PixelArea> area;
  bool selectingArea = false;  // the next drag in the viewport draws it
  RayOrder rayOrder;
  std::optional<uint32_t> hoveredPixel;
  std::optional<HeldRay> held;  // stays when the camera goes on (held_ray.h)

  // Play.
  bool playing = false;          // time
  double timeStep = 1.0 / 60.0;  // seconds
  bool stepsPlaying = false;     // the ray's steps
  float stepsPerSecond = 8.0f;
  bool followStep = false;  // the camera goes along with the selected step

  // Appearance.
  Workspace workspace = Workspace::grid;
  BottomTab bottomTab = BottomTab::steps;
  bool bottomTabWanted = false;  // set with bottomTab by what is not the tab bar itself
  int walked = 0;                // region whose controls the keyboard walks through (app/ui/shell/layout.cpp); 0: keys run actions
  bool walkWanted = false;       // F6: on to the next region
  int rowStep = 0;               // Up and Down: rows that the shown table is to go on by, once
  ViewportLayout layout = ViewportLayout::one;
  std::array<Pane, 4> panes{Pane{"final"}, Pane{"verdict"}, Pane{"cause"}, Pane{"visits"}};
  int activePane = 0;
  std::optional<Bounds> focusWanted;  // world: the camera looks there, once
  std::optional<vec2> pixelWanted;    // of the frame: zoomed panes move there, once
  bool linkedPanes = true;
  float shownScale = 1.0f;              // screen pixels a frame pixel, of the pane that was drawn last
  std::array<ViewportPlace, 4> places;  // linked: the first is everyone's
  CompareState comparison;
  uint32_t colourMap = kColourMapViridis;
  Overlays overlays;
  CameraState camera;
  std::vector<Bookmark> bookmarks;                              // of the scene that is shown
  std::string bookmarksOf;                                      // under which key of savedBookmarks they are kept
  std::map<std::string, std::vector<Bookmark>> savedBookmarks;  // of all scenes, by path or name: preferences
  Theme theme = Theme::dark;
  float uiScale = 1.0f;
  std::string search;         // text of the search box
  bool searchWanted = false;  // Ctrl+F: give it the keyboard
  bool helpOpen = false;
  std::vector<std::string> recentFiles;  // last used first
  std::string captureName, captureNote;  // of the next capture
  bool captureDialogOpen = false;
  bool reportDialogOpen = false;
  std::string reportName;
  bool openDialogOpen = false;
  std::string openPath;  // typed in the Open dialog
  bool quit = false;
  bool flying = false;  // the right mouse button steers the camera: keys move it
  Splits splits;
  double interfaceMs = 0.0;  // of building and submitting the last frame of the interface

  std::deque<LogLine> log;
  std::string toast;  // last message, shown for a moment over the viewport
  double toastUntil = 0.0;

  const Selection& selected() const { return selection.now(); }
  void say(LogLine::Kind kind, std::string text);                          // into the log, and on standard error when it is an error
  void changeSettings(const std::function<void(FrameSettings&)>& change);  // remembers the old for undo
  void rememberForUndo(const FrameSettings& settings);
  void showTab(BottomTab tab) { bottomTab = tab, bottomTabWanted = true; }
  void announce(LogLine::Kind kind, std::string text);  // into the log, and for a moment over the viewport
  void showMessage(std::string text) { announce(LogLine::Kind::note, std::move(text)); }
  double now = 0.0;                 // seconds since the start
  bool logToStandardError = false;  // every line of the log, not errors alone
};

}  // namespace gridscope
