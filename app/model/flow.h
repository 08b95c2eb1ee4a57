// What flows between the window's model and the worker: the request that the model stands for, and the frame that comes back. And what
// moves by itself: time and the steps of a ray. No ImGui here.
#pragma once

#include "app/model/window_model.h"

namespace gridscope {

// What the worker is asked for: the model's request with what the panes show, the camera, and the selected ray.
FrameRequest requestOf(const WindowModel& model);

// Names of the views that the viewport shows.
std::set<std::string> shownViews(const WindowModel& model);
bool sameRequest(const FrameRequest& a, const FrameRequest& b);

// A new snapshot has come.
void takeFrame(WindowModel& model, std::shared_ptr<const FrameSnapshot> frame);

// Once a display frame: plays time and steps, and takes the camera to what is wanted.
void advanceModel(WindowModel& model);

// View, panes, overlays and bottom tab of a workspace.
void showIn(WindowModel& model, Workspace workspace);

void openSource(WindowModel& model,
                const std::string& path);  // a scene's or capture's path, a built-in scene's name, or rays in a .npy file
void useRaysOf(WindowModel& model, const std::string& path);  // of a .npy file, on the scene that is shown; "": the bounce's again
void stepTime(WindowModel& model, int frames);                // forward or back
void showCapturedFrame(WindowModel& model, uint32_t frame);   // of a sequence; its own camera where the frame before was seen from its own
void setTime(WindowModel& model, double seconds);
void showView(WindowModel& model, const std::string& view);  // in the active pane
bool opensAnother(const WindowModel& model);                 // a scene is being loaded: the settings are still those of the one before
void undoSetting(WindowModel& model);
void declineTruth(WindowModel& model);  // until it is asked for again

// The next ray of that kind behind the selected one, in the order of pixels; asks for the truth first where it is not told yet.
void jumpTo(WindowModel& model, Jump jump);

// The saturated cell that wants the most references; then the next fullest behind the selected one, round again at the end.
void goToNextSaturatedCell(WindowModel& model);

// What keys reach (keys.cpp): the next tab, the next view of the active pane (`places` may be below 0), around at the ends.
void stepTab(WindowModel& model, int places);
void stepView(WindowModel& model, int places);

// The row `places` on from the selected one of `count`; the first, or the last for a step back, where none is selected. Nothing: no row, no step.
std::optional<size_t> rowBeside(std::optional<size_t> selected, int places, size_t count);

// Why time can't go on; "": it can.
std::string whyNoTime(const WindowModel& model);

// Under what a scene's bookmarks are kept: the whole path of a file, the name of a built-in scene.
std::string bookmarkKey(const std::string& scene);

std::string windowTitle(const WindowModel& model);

}  // namespace gridscope
