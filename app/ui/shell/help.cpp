// The help window, made from the table of actions; and the dialogs: open, capture.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <cstring>
#include <filesystem>

#include "app/frame/arguments.h"
#include "app/model/flow.h"
#include "app/ui/shell/layout.h"
#include "app/ui/widgets/action_button.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

// A window in the middle of the program's; false: it is closed.
bool beginDialog(const char* title, bool& open, float width) {
  if (!open) return false;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * screen.x, 0.45f * screen.y}, ImGuiCond_Appearing, {0.5f, 0.45f});
  ImGui::SetNextWindowSize({std::min(unit(width), screen.x - unit(20)), 0});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, screen.y - unit(20)});
  ImGui::PushStyleColor(ImGuiCol_Border, uiColour(UiColour::accent));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  const bool shown = ImGui::Begin(title, &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) open = false;
  if (!shown) ImGui::End();
  return shown;
}

void drawMenuKeys(const char* menu) {
  ImGui::PushFont(windowFonts().sansBold);
  ImGui::TextUnformatted(menu);
  ImGui::PopFont();
  for (const Action& one : allActions()) {
    if (std::strcmp(one.menu, menu) != 0 || !*one.key) continue;
    textMono(one.key);
    ImGui::SameLine(unit(118));
    ImGui::TextUnformatted(one.name);
    whyTooltip(one.about);
  }
  ImGui::Dummy({1, unit(6)});
}

void drawOpen(WindowModel& model) {
  if (!beginDialog("Open a scene or a capture", model.openDialogOpen, 560)) return;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputTextWithHint("##path", "Path of a .glb, .gltf or .gridcap file, or a built-in scene's name",
                                                &model.openPath, ImGuiInputTextFlags_EnterReturnsTrue);
  for (const std::string& file : model.recentFiles)
    if (ImGui::Selectable(file.c_str())) model.openPath = file;
  if (entered || ImGui::Button("Open", {unit(90), unit(24)})) {
    model.openDialogOpen = false;
    if (!model.openPath.empty()) openSource(model, model.openPath);
  }
  ImGui::End();
}

void drawCapture(WindowModel& model) {
  if (!beginDialog("Capture this frame", model.captureDialogOpen, 460)) return;
  textDim("Name");
  ImGui::SetNextItemWidth(-1);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  bool entered = ImGui::InputText("##name", &model.captureName, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  textDim("Note: what it shows");
  ImGui::SetNextItemWidth(-1);
  entered |= ImGui::InputText("##note", &model.captureNote, ImGuiInputTextFlags_EnterReturnsTrue);
  const bool named = !model.captureName.empty();
  const std::filesystem::path wanted = std::filesystem::absolute(model.captureName + ".gridcap"),
                              file = named ? model.files.wouldClaim(wanted) : wanted;
  ImGui::PushTextWrapPos(0.0f);
  if (!named)
    textDim("Give it a name");
  else if (file == wanted)
    textDim("Writes " + file.string());
  else
    textDim(wanted.filename().string() + " is there already: writes " + file.string());
  ImGui::PopTextWrapPos();
  ImGui::BeginDisabled(!named);
  if ((entered && named) || ImGui::Button("Capture", {unit(90), unit(24)})) {
    model.captureDialogOpen = false;
    model.captureWish = CaptureWish{std::filesystem::relative(model.files.claim(wanted)).string(), model.captureNote};
  }
  ImGui::EndDisabled();
  ImGui::End();
}

// The page's name, then how far it is.
void drawReport(WindowModel& model) {
  if (!beginDialog("Report on this frame", model.reportDialogOpen, 460)) return;
  const ReportState state = model.report.state();
  if (state.running) {
    textDim("Traces every ray against all triangles and paints the views, beside the window.");
    ImGui::ProgressBar(state.share, {-1.0f, unit(18)}, state.what.c_str());
    if (ImGui::Button("Cancel", {unit(90), unit(24)})) model.report.cancel();
    ImGui::SameLine();
    if (ImGui::Button("Go on without", {unit(120), unit(24)})) model.reportDialogOpen = false;
    whyTooltip("The report is made in the background and said when it is there");
    return ImGui::End();
  }
  textDim("Name");
  ImGui::SetNextItemWidth(-1);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText("##name", &model.reportName, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool named = !model.reportName.empty();
  const std::filesystem::path wanted = std::filesystem::absolute(model.reportName + ".html"),
                              file = named ? model.files.wouldClaim(wanted) : wanted;
  ImGui::PushTextWrapPos(0.0f);
  textDim(named ? "Writes " + file.string() : std::string("Give it a name"));
  ImGui::PopTextWrapPos();
  ImGui::BeginDisabled(!named);
  if ((entered && named) || ImGui::Button("Make it", {unit(90), unit(24)})) {
    model.reportDialogOpen = false;
    try {
      Options options = optionsFrom(reportArguments(requestOf(model), model.timeStep));
      options.device = model.startDevice;
      options.page = model.files.claim(wanted);
      options.arguments.insert(options.arguments.begin(), "report");
      model.report.start(options);
      model.reportDialogOpen = true;
    } catch (const std::exception& error) {
      model.announce(LogLine::Kind::error, error.what());
    }
  }
  ImGui::EndDisabled();
  ImGui::End();
}

}  // namespace

void drawHelp(WindowModel& model) {
  if (!beginDialog("All keys", model.helpOpen, 1060)) return;
  static constexpr const char* kColumns[4][4] = {
      {"File", "Edit", "Frame", nullptr}, {"View", "Cells", nullptr}, {"Ray", "Tools", "Help", nullptr}, {"Window", nullptr}};
  ImGui::Columns(4, nullptr, false);
  for (const auto& column : kColumns) {
    for (const char* const* menu = column; *menu; ++menu) drawMenuKeys(*menu);
    ImGui::NextColumn();
  }
  ImGui::Columns(1);
  ImGui::Separator();
  ImGui::PushStyleColor(ImGuiCol_Text, uiColour(UiColour::dim));
  ImGui::TextWrapped(
      "In the viewport: click a pixel to record its ray; with Alt: select the cell there. Wheel: zoom into pixels; drag: move the zoomed "
      "picture. Middle button, or Alt and drag: orbit; with "
      "Shift: move aside; Alt and wheel: nearer. Right button: look around, and fly with W A S D Q E (Shift: faster, wheel or + and -: "
      "speed). Drop a scene or a capture on "
      "the window to open it. Double click a splitter to bring it back.");
  ImGui::PopStyleColor();
  ImGui::End();
}

void drawDialogs(WindowModel& model) {
  drawOpen(model);
  drawCapture(model);
  drawReport(model);
}

}  // namespace gridscope
