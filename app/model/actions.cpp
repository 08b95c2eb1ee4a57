// See actions.h.
#include "app/model/actions.h"

#include <algorithm>
#include <cstring>

#include "app/base/text.h"
#include "app/frame/arguments.h"
#include "app/frame/camera_moves.h"
#include "app/frame/changes.h"
#include "app/model/comparison.h"
#include "app/model/exports.h"
#include "app/model/flow.h"
#include "app/model/ray_stepping.h"
#include "app/model/selected_bounds.h"
#include "core/base/error.h"

namespace gridscope {

namespace {

std::string needsFrame(const WindowModel& m) { return m.frame && m.frame->hits ? "" : "No frame yet"; }
std::string needsGrid(const WindowModel& m) { return m.frame && m.frame->grid ? "" : "No grid yet"; }
std::string needsRecord(const WindowModel& m) { return shownStep(m) ? "" : "No ray is recorded: click a pixel"; }
std::string needsUndo(const WindowModel& m) {
  if (opensAnother(m)) return "A scene is being loaded";
  return m.undo.empty() ? "No setting was changed" : "";
}
std::string needsSelection(const WindowModel& m) { return selectedBounds(m).empty() ? "Nothing is selected" : ""; }
std::string needsCompare(const WindowModel& m) {
  return m.layout == ViewportLayout::compare ? "" : "Only in the A/B layout of the viewport";
}
std::string needsComplete(const WindowModel& m) {
  if (!m.frame || !m.frame->hits) return "No frame yet";
  return m.frame->stale ? "The frame is still being traced" : "";
}

void flip(bool& overlay) { overlay = !overlay; }

std::string whyNoReport(const WindowModel& m) {
  if (!m.frame || !m.frame->hits) return "No frame yet";
  if (!m.request.edits.empty()) return "Instances were edited: a report is of the scene as its file has it. Undo the edits first";
  if (m.frame->scene->captureFrames > 0 && !sameSettings(*m.request.settings, m.frame->scene->ownSettings))
    return "A capture's report has the settings that it was captured with: go back to the scene's own settings first";
  return "";
}

void openReportDialog(WindowModel& m) {
  m.reportName = m.frame->scene->name.substr(0, m.frame->scene->name.find('.')) + "_report";
  m.reportDialogOpen = true;
}

void copyCommand(WindowModel& m) {
  std::vector<std::string> words = frameArguments(requestOf(m));
  words.insert(words.begin(), {"gridscope", "render"});
  m.clipboardWish = shellText(words);
  m.showMessage("Copied: " + shellText(words));
}

void openCaptureDialog(WindowModel& m) {
  m.captureName = m.frame->scene->name.substr(0, m.frame->scene->name.find('.'));
  m.captureDialogOpen = true;
}

constexpr Action kActions[] = {
    {"File", "Open", "Ctrl+O", "Opens a scene or a capture; dropping a file on the window does the same.", nullptr,
     [](WindowModel& m) { m.openDialogOpen = true; }},
    {"File", "Reload scene", "Ctrl+R", "Loads the file again.", nullptr, [](WindowModel& m) { ++m.request.source.loadCount; }},
    {"File", "Capture frame", "F12", "Writes everything of this frame into a .gridcap file.", needsComplete, openCaptureDialog},
    {"File", "Save picture", "Ctrl+S", "Writes the active view as a PNG file.", needsFrame,
     [](WindowModel& m) { saveView(m, m.panes[size_t(m.activePane)].view); }},
    {"File", "Report...", "Ctrl+E", "Makes one page about this frame for a colleague: pictures, verdicts, causes, losses.", whyNoReport,
     openReportDialog},
    {"File", "Quit", "Ctrl+Q", "Closes the window; splits, theme and bookmarks are kept.", nullptr, [](WindowModel& m) { m.quit = true; }},

    {"Edit", "Undo setting", "Ctrl+Z", "Takes back the last change of a setting.", needsUndo, undoSetting},
    {"Edit", "Search", "Ctrl+F", "Goes to the search box: a pixel, cell, triangle, instance or mesh.", nullptr,
     [](WindowModel& m) { m.searchWanted = true; }},
    {"Edit", "Select area", "M", "The next drag in the viewport draws a rectangle that filters the tables; again to leave it.", needsFrame,
     [](WindowModel& m) { m.selectingArea = !m.selectingArea && !m.area, m.area.reset(); }},
    {"Edit", "Selection back", "Alt+Left", "What was selected before.", nullptr, [](WindowModel& m) { m.selection.goBack(); }},
    {"Edit", "Selection forward", "Alt+Right", "What was selected after it.", nullptr, [](WindowModel& m) { m.selection.goForward(); }},
    {"Edit", "Copy command", "Ctrl+Shift+C", "The command line that renders this frame.", needsFrame, copyCommand},
    {"Edit", "Select nothing", "Escape", "Leaves the selection and the area.", nullptr,
     [](WindowModel& m) {
       if (m.helpOpen || m.openDialogOpen || m.captureDialogOpen || m.reportDialogOpen) return;  // Escape closes those first
       m.area.reset(), m.selectingArea = false, m.selection.clear();
     }},

    {"View", "Focus", "F", "The camera goes to what is selected.", needsSelection,
     [](WindowModel& m) { focusCamera(m.camera, selectedBounds(m)); }},
    {"View", "Reset camera", "Ctrl+Home", "The scene's own camera, and the whole frame in the viewport.", needsFrame,
     [](WindowModel& m) { m.camera.pose = m.frame->scene->ownSettings.camera, m.places.fill({}); }},
    {"View", "Fit range", "R", "The colour range of the active view follows its values again.", nullptr,
     [](WindowModel& m) { m.panes[size_t(m.activePane)].range.reset(); }},
    {"View", "Fit picture", "Ctrl+0", "The whole frame in the viewport.", nullptr, [](WindowModel& m) { m.places.fill({}); }},
    {"View", "One view", "Ctrl+1", "One view fills the viewport.", nullptr, [](WindowModel& m) { m.layout = ViewportLayout::one; }},
    {"View", "Four views", "Ctrl+4", "Four linked views.", nullptr, [](WindowModel& m) { m.layout = ViewportLayout::four; }},
    {"View", "Compare", "Ctrl+2", "A beside B: two views, or the kept frame and the live one.", nullptr,
     [](WindowModel& m) { m.layout = ViewportLayout::compare; }},
    {"View", "Keep frame as B", "K", "Keeps this frame, to compare later ones with it.", needsFrame,
     [](WindowModel& m) {
       keepFrame(m);
       m.showMessage("This frame is kept as B");
     }},
    {"View", "Flip A/B", "Space", "Shows B instead of A, and back.", needsCompare,
     [](WindowModel& m) { m.comparison.flip = !m.comparison.flip; }},
    {"View", "Next view", "PageDown", "The next of all views, in the active pane.", nullptr, [](WindowModel& m) { stepView(m, 1); }},
    {"View", "Previous view", "PageUp", "The view before, in the active pane.", nullptr, [](WindowModel& m) { stepView(m, -1); }},
    {"View", "Next colour map", "Ctrl+M", "Viridis, cividis, magma, grey.", nullptr,
     [](WindowModel& m) { m.colourMap = (m.colourMap + 1) % kColourMapCount; }},

    {"Frame", "Play", "Ctrl+Space", "Time goes on, a frame at a time.", whyNoTime, [](WindowModel& m) { m.playing = !m.playing; }},
    {"Frame", "Next frame", "Ctrl+Right", "One time step forward.", whyNoTime, [](WindowModel& m) { stepTime(m, 1); }},
    {"Frame", "Previous frame", "Ctrl+Left", "One time step back.", whyNoTime, [](WindowModel& m) { stepTime(m, -1); }},
    {"Frame", "First frame", "Ctrl+Up", "Back to time 0.", whyNoTime,
     [](WindowModel& m) {
       if (m.frame->scene->captureFrames > 0) return showCapturedFrame(m, 0);
       m.request.frame = 0, m.request.timeSeconds = 0.0;
     }},

    {"Ray", "Step forward", "Right", "The next step of the recorded ray.", needsRecord, stepForward},
    {"Ray", "Step back", "Left", "The step before: the exact inverse.", needsRecord, stepBack},
    {"Ray", "First step", "Home", "Where the ray starts.", needsRecord, stepFirst},
    {"Ray", "Last step", "End", "Where it ends.", needsRecord, stepLast},
    {"Ray", "Play steps", "P", "Goes through the steps by itself.", needsRecord, togglePlay},
    {"Ray", "Next non-empty", "E", "To the next step that starts in a cell with references.", needsRecord,
     [](WindowModel& m) { stepToNext(m, StepSearch::nonEmpty); }},
    {"Ray", "Next tested", "T", "To the next step that tested a triangle.", needsRecord,
     [](WindowModel& m) { stepToNext(m, StepSearch::tested); }},
    {"Ray", "Next saturated", "S", "To the next saturated cell on the way.", needsRecord,
     [](WindowModel& m) { stepToNext(m, StepSearch::saturated); }},
    {"Ray", "Next revisit", "V", "To the next step that starts in the cell visited last.", needsRecord,
     [](WindowModel& m) { stepToNext(m, StepSearch::revisit); }},
    {"Ray", "Voxel hit", "X", "To the step that filled the gap.", needsRecord, [](WindowModel& m) { stepToNext(m, StepSearch::voxelHit); }},
    {"Ray", "Next ray", "]", "In the order of the Rays table.", needsFrame, [](WindowModel& m) { nextRay(m, 1); }},
    {"Ray", "Previous ray", "[", "In the order of the Rays table.", needsFrame, [](WindowModel& m) { nextRay(m, -1); }},
    {"Ray", "Step this ray", "Enter", "Opens the steps of the selected pixel's ray.", needsRecord,
     [](WindowModel& m) { m.showTab(BottomTab::steps), m.selection.selectStep(m.selected().step); }},

    {"Cells", "Next hole", "N", "The next ray that misses a surface.", needsFrame, [](WindowModel& m) { jumpTo(m, Jump::nextHole); }},
    {"Cells", "Next voxel wrong", "W", "The next voxel hit far from the true surface.", needsFrame,
     [](WindowModel& m) { jumpTo(m, Jump::nextVoxelWrong); }},
    {"Cells", "Fullest cell", "C", "The saturated cell that wants the most references; again: the next fullest.", needsGrid,
     goToNextSaturatedCell},

    {"Cells", "Cell boxes", "Alt+B", "Boxes of the cells whose tried references are in the range.", nullptr,
     [](WindowModel& m) { flip(m.overlays.cellBoxes); }},
    {"Cells", "Saturated cells", "Alt+S", "Boxes of the cells that refused something.", nullptr,
     [](WindowModel& m) { flip(m.overlays.saturatedBoxes); }},
    {"Ray", "Ray segments", "Alt+R", "The selected ray over the picture, coloured by what happened in each segment.", nullptr,
     [](WindowModel& m) { flip(m.overlays.raySegments); }},
    {"Ray", "Visited cells", "Alt+V", "Boxes of the cells that the ray visited.", nullptr,
     [](WindowModel& m) { flip(m.overlays.visitedCells); }},
    {"Ray", "Tested triangles", "Alt+T", "The triangles that the step tested, over the picture.", nullptr,
     [](WindowModel& m) { flip(m.overlays.testedTriangles); }},
    {"Ray", "Lens", "Alt+L", "A closer look at the step's cell, over the picture.", nullptr, [](WindowModel& m) { flip(m.overlays.lens); }},
    {"View", "Selection marks", "Alt+M", "What is selected, over the picture.", nullptr,
     [](WindowModel& m) { flip(m.overlays.selection); }},
    {"View", "Clip box", "Alt+C", "Overlays only where the box of the left panel leaves them.", nullptr,
     [](WindowModel& m) { flip(m.overlays.clip); }},

    {"Tools", "Tell the truth", "Ctrl+T", "Compares every ray with the exact answer: verdicts and causes.", needsFrame,
     [](WindowModel& m) { m.request.truth = !m.request.truth; }},
    {"Tools", "Prove every cause", "Ctrl+P", "Takes each cause away and traces its ray again.", needsFrame,
     [](WindowModel& m) { m.request.truth = true, ++m.request.proveAll; }},
    {"Tools", "Reload shaders", "F5", "Compiles the shaders of the source folder again; a broken one leaves the last good.", nullptr,
     [](WindowModel& m) { ++m.request.shaderReloads; }},

    {"Window", "Grid", "1", "Workspace: occupancy, cells and plots.", nullptr, [](WindowModel& m) { showIn(m, Workspace::grid); }},
    {"Window", "Ray", "2", "Workspace: one ray, step by step.", nullptr, [](WindowModel& m) { showIn(m, Workspace::ray); }},
    {"Window", "Verdict", "3", "Workspace: verdicts and their causes.", nullptr, [](WindowModel& m) { showIn(m, Workspace::verdict); }},
    {"Window", "Tune", "4", "Workspace: which settings fit.", nullptr, [](WindowModel& m) { showIn(m, Workspace::tune); }},
    {"Window", "Ray steps tab", "Alt+1", "Below: the selected ray, step by step.", nullptr,
     [](WindowModel& m) { m.showTab(BottomTab::steps); }},
    {"Window", "Cells tab", "Alt+2", "Below: the table of cells.", nullptr, [](WindowModel& m) { m.showTab(BottomTab::cells); }},
    {"Window", "Instances tab", "Alt+3", "Below: the table of instances.", nullptr,
     [](WindowModel& m) { m.showTab(BottomTab::instances); }},
    {"Window", "Triangles tab", "Alt+4", "Below: the table of triangles.", nullptr,
     [](WindowModel& m) { m.showTab(BottomTab::triangles); }},
    {"Window", "Rays tab", "Alt+5", "Below: the table of rays.", nullptr, [](WindowModel& m) { m.showTab(BottomTab::rays); }},
    {"Window", "Causes tab", "Alt+6", "Below: why rays differ, and which meshes cost the most.", nullptr,
     [](WindowModel& m) { m.showTab(BottomTab::causes); }},
    {"Window", "Plots tab", "Alt+7", "Below: histograms and stage times.", nullptr, [](WindowModel& m) { m.showTab(BottomTab::plots); }},
    {"Window", "Tune tab", "Alt+8", "Below: the sweep over settings.", nullptr, [](WindowModel& m) { m.showTab(BottomTab::tune); }},
    {"Window", "Log tab", "Alt+9", "Below: what happened.", nullptr, [](WindowModel& m) { m.showTab(BottomTab::log); }},
    {"Window", "Next tab", "Ctrl+Tab", "The tab to the right, below.", nullptr, [](WindowModel& m) { stepTab(m, 1); }},
    {"Window", "Previous tab", "Ctrl+Shift+Tab", "The tab to the left, below.", nullptr, [](WindowModel& m) { stepTab(m, -1); }},
    {"Window", "Next row", "Down", "The next row of the table below, and where it leads.", nullptr, [](WindowModel& m) { ++m.rowStep; }},
    {"Window", "Previous row", "Up", "The row before, and where it leads.", nullptr, [](WindowModel& m) { --m.rowStep; }},
    {"Window", "Walk the controls", "F6",
     "Arrows, Space and Enter reach every control of a panel; F6 again: the next panel; Escape leaves.", nullptr,
     [](WindowModel& m) { m.walkWanted = true; }},
    {"Window", "Light theme", "Ctrl+L", "Dark on light, and back.", nullptr,
     [](WindowModel& m) { m.theme = m.theme == Theme::dark ? Theme::light : Theme::dark; }},
    {"Window", "Larger", "Ctrl+=", "Larger interface.", nullptr, [](WindowModel& m) { m.uiScale = std::min(m.uiScale + 0.25f, 3.0f); }},
    {"Window", "Smaller", "Ctrl+-", "Smaller interface.", nullptr, [](WindowModel& m) { m.uiScale = std::max(m.uiScale - 0.25f, 0.5f); }},
    {"Window", "Reset layout", "", "Splits and scale as they were at first.", nullptr,
     [](WindowModel& m) { m.splits = {}, m.uiScale = 1.0f; }},

    {"Help", "All keys", "?", "This list.", nullptr, [](WindowModel& m) { m.helpOpen = !m.helpOpen; }},
};

}  // namespace

std::span<const Action> allActions() { return kActions; }

const Action& action(const char* name) {
  for (const Action& one : kActions)
    if (!std::strcmp(one.name, name)) return one;
  CHECK_EQ(std::string(name), "an action");
  return kActions[0];
}

std::string whyNot(const WindowModel& model, const Action& action) { return action.whyNot ? action.whyNot(model) : ""; }

}  // namespace gridscope
