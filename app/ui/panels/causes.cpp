// The causes of the rays that do not agree with the exact hits, each with its proofs, and the meshes that cost the most rays.
#include <algorithm>
#include <numeric>

#include "app/base/text.h"
#include "app/frame/find_next.h"
#include "app/frame/table_exports.h"
#include "app/frame/table_rows.h"
#include "app/model/exports.h"
#include "app/model/flow.h"
#include "app/ui/panels/panels.h"
#include "app/ui/panels/sheet.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/panels/truth_marks.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

// Below this width (at UI scale 1) causes and meshes take turns.
constexpr float kBothWidth = 820.0f;
constexpr size_t kMostMeshes = 10;

void goToNext(WindowModel& model, const RayWanted& wanted, std::string_view what) {
  const std::optional<uint32_t> pixel = nextRay(*model.frame, model.rayOrder.pixels, model.selected().pixel, wanted);
  if (pixel)
    model.selection.selectPixel(*pixel);
  else
    model.announce(LogLine::Kind::note, "No ray of this frame is: " + std::string(what));
}

// A cause's evidence in a table's column; the tooltip has it at length.
const char* evidenceWords(uint32_t cause) {
  switch (cause) {
    case kCauseRefused: return "no slot left in the hit's cell";
    case kCauseSteppedOver: return "no segment in the hit's cell";
    case kCauseRevisit: return "the segment that reaches it was skipped";
    case kCauseSegmentEnd: return "queried, hit outside the segment";
    case kCauseAcceptedEarly: return "a farther hit came first";
    case kCauseGate: return "gap held back near the launch";
    case kCauseFilledEarly: return "an earlier full cell ended the ray";
    case kCauseAlpha: return "alpha keying decided otherwise";
    case kCauseSelfHit: return "nearer than what counts";
    case kCauseOutside: return "outside the grid";
    case kCauseLeftOut: return "the build leaves it out";
    case kCauseStale: return "a reference of an older frame";
    case kCauseNotInserted: return "missing though there was room";
    case kCauseSegmentLimit: return "the limit ended the ray";
    case kCauseNumeric: return "an edge within rounding";
    default: return "";
  }
}

void beginTextColumn(const char* title, float weight) { ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthStretch, weight); }

// Titles of a table that does not sort.
void drawTitles(std::initializer_list<std::pair<const char*, bool>> titles) {
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, unit(20));
  int column = 0;
  for (const auto& [title, right] : titles)
    if (ImGui::TableSetColumnIndex(column++)) tableTitle(title, right);
}

// --- Causes -----------------------------------------------------------------------------------------------------------------------

void drawConfirmed(const FrameSnapshot& frame, uint32_t cause) {
  if (!frame.proofs) return smallText("\u2013", uiColour(UiColour::disabled));
  const ProofTotals::Count& count = frame.proofs->causes[cause];
  const uint64_t confirmed = count.alone + count.chain;
  rightNumber(grouped(confirmed) + "  " + percentOf(confirmed, count.total),
              meaningColour(confirmed == count.total ? kColourTriangleHit : kColourVoxelHit));
  const std::string how = grouped(count.alone) + " alone, " + grouped(count.chain) + " as a chain, of " + grouped(count.total) +
                          "; the control confirms " + percentOf(count.controlChained, count.controlTotal) + ", " +
                          percentOf(count.controlConfirmed, count.controlTotal) + " alone";
  whyTooltip(how.c_str());
}

void drawCauseRow(WindowModel& model, uint32_t cause) {
  const FrameSnapshot& frame = *model.frame;
  const uint64_t rays = frame.truthTotals.causes[cause];
  const TruthName& name = causeName(cause);
  const std::optional<uint32_t> pixel = model.selected().pixel;
  const bool selected = pixel && *pixel < frame.truths->size() && (*frame.truths)[*pixel].cause == cause;
  ImGui::TableNextRow(0, unit(20));
  ImGui::TableSetColumnIndex(0);
  ImGui::PushID(static_cast<int>(cause));
  if (rowSelectable(selected)) goToNext(model, {.cause = cause}, name.title);
  whyTooltip((std::string(name.about) + "\nClick: the next such ray").c_str());
  swatch(causeColour(cause));
  ImGui::SameLine(0.0f, unit(6));
  smallText(name.title, uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(1);
  rightNumber(grouped(rays), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(2);
  rightNumber(percentOf(rays, frame.truthTotals.differ()), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(3);
  smallText(evidenceWords(cause), uiColour(UiColour::dim));
  ImGui::TableSetColumnIndex(4);
  drawConfirmed(frame, cause);
  ImGui::PopID();
}

void drawCauseTable(WindowModel& model, const ImVec2& size) {
  TableStyle style;
  if (!ImGui::BeginTable("causes", 5, kTableFlags | ImGuiTableFlags_ScrollY, size)) return;
  beginTextColumn("cause", 1.5f), beginTextColumn("rays", 0.9f), beginTextColumn("share", 0.8f), beginTextColumn("evidence", 3.2f),
      beginTextColumn("confirmed", 1.5f);
  drawTitles({{"cause", false}, {"rays", true}, {"share", true}, {"evidence", false}, {"confirmed", true}});
  std::vector<uint32_t> causes;
  for (uint32_t cause = kCauseNone + 1; cause < kCauseCount; ++cause)
    if (model.frame->truthTotals.causes[cause] > 0) causes.push_back(cause);
  const auto& totals = model.frame->truthTotals.causes;
  std::stable_sort(causes.begin(), causes.end(), [&](uint32_t a, uint32_t b) { return totals[a] > totals[b]; });
  const std::optional<uint32_t> pixel = model.selected().pixel;
  const auto now =
      pixel && *pixel < model.frame->truths->size() ? std::ranges::find(causes, (*model.frame->truths)[*pixel].cause) : causes.end();
  const auto selected = now == causes.end() ? std::nullopt : std::optional(size_t(now - causes.begin()));
  if (const auto row = rowBeside(selected, model.rowStep, causes.size()); row && row != selected)
    goToNext(model, {.cause = causes[*row]}, causeName(causes[*row]).title);
  for (const uint32_t cause : causes) drawCauseRow(model, cause);
  ImGui::EndTable();
}

// --- Meshes -----------------------------------------------------------------------------------------------------------------------

// Rays by verdict as one bar, `share` of the column long.
void drawVerdictBar(const GroupLoss& loss, double share) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float length = ImGui::GetContentRegionAvail().x * static_cast<float>(share), height = unit(9);
  const float top = start.y + 0.5f * (tableRowHeight() - unit(4) - height);
  ImDrawList* list = ImGui::GetWindowDrawList();
  float x = start.x;
  std::string said;
  for (const uint32_t verdict : {kVerdictHole, kVerdictVoxelRight, kVerdictVoxelWrong, kVerdictTooFar, kVerdictTooNear}) {
    const uint64_t rays = loss.verdicts[verdict];
    if (rays == 0) continue;
    const float width = length * float(double(rays) / double(std::max<uint64_t>(1, loss.rays)));
    list->AddRectFilled(ImVec2(x, top), ImVec2(x + width, top + height), packed(meaningColour(verdictColour(verdict))));
    x += width;
    said += (said.empty() ? "" : "\n") + grouped(rays) + "  " + std::string(verdictName(verdict).title);
  }
  ImGui::Dummy(ImVec2(std::max(1.0f, ImGui::GetContentRegionAvail().x), unit(14)));
  if (ImGui::IsItemHovered()) whyTooltip(said.c_str());
}

// A ray that should have hit the mesh and does not agree, behind the selected one.
void goToMesh(WindowModel& model, uint32_t mesh) {
  const FrameSnapshot& frame = *model.frame;
  const uint32_t count = frame.pixelCount(), from = model.selected().pixel.value_or(count - 1);
  for (uint32_t step = 1; step <= count; ++step) {
    const uint32_t pixel = (from + step) % count;
    const RayTruth& truth = (*frame.truths)[pixel];
    if (truth.cause == kCauseNone || truth.exactReference == kNoReference) continue;
    const uint32_t instance = referenceInstance(truth.exactReference);
    if (instance < frame.scene->numbered.sources.size() && frame.scene->numbered.sources[instance].mesh == mesh)
      return model.selection.selectPixel(pixel);
  }
}

void drawMeshRow(WindowModel& model, size_t place, const GroupLoss& loss, uint64_t most) {
  const std::vector<std::string>& names = model.frame->scene->names.meshes;
  const std::string name =
      loss.index < names.size() && !names[loss.index].empty() ? names[loss.index] : "mesh " + std::to_string(loss.index);
  ImGui::TableNextRow(0, unit(20));
  ImGui::TableSetColumnIndex(0);
  ImGui::PushID(static_cast<int>(loss.index));
  if (rowSelectable(false)) goToMesh(model, loss.index);
  whyTooltip("Click: the next ray that it cost");
  rightNumber(std::to_string(place), uiColour(UiColour::dim));
  ImGui::TableSetColumnIndex(1);
  smallText(name, uiColour(UiColour::link));
  ImGui::TableSetColumnIndex(2);
  rightNumber(grouped(loss.rays), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(3);
  drawVerdictBar(loss, double(loss.rays) / double(most));
  ImGui::TableSetColumnIndex(4);
  rightNumber(grouped(loss.lost), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(5);
  rightNumber(percentOf(loss.lost, loss.lost + loss.stored), uiColour(UiColour::text));
  ImGui::PopID();
}

void drawMeshTable(WindowModel& model, const ImVec2& size) {
  const std::vector<GroupLoss>& meshes = model.frame->ledger->meshes;
  const std::vector<size_t> worst = worstOf(std::span<const GroupLoss>(meshes), kMostMeshes);
  if (worst.empty()) return emptyState("No mesh cost a ray.");
  TableStyle style;
  if (!ImGui::BeginTable("meshes", 6, kTableFlags | ImGuiTableFlags_ScrollY, size)) return;
  beginTextColumn("#", 0.35f), beginTextColumn("mesh", 1.7f), beginTextColumn("rays", 0.9f), beginTextColumn("by verdict", 2.2f),
      beginTextColumn("refs lost", 1.0f), beginTextColumn("of tried", 0.9f);
  drawTitles({{"#", true}, {"mesh", false}, {"rays", true}, {"by verdict", false}, {"refs lost", true}, {"of tried", true}});
  size_t place = 0;
  for (const size_t index : worst) drawMeshRow(model, ++place, meshes[index], meshes[worst.front()].rays);
  ImGui::EndTable();
}

// --- The strip --------------------------------------------------------------------------------------------------------------------

void drawProve(WindowModel& model) {
  static uint32_t asked = 0;  // proveAll when it was asked for last
  const FrameSnapshot& frame = *model.frame;
  const bool waiting = asked != 0 && asked == model.request.proveAll && !frame.proofs;
  const char* label = waiting ? "Proving..." : "Prove all";
  toTheRight(smallButtonWidth(label) + unit(6) + smallButtonWidth("Export CSV"));
  const bool possible = !waiting && frame.truthTotals.differ() > 0;
  const char* why = waiting ? "The rays are traced again, each without its cause" : "Every ray agrees";
  if (smallButton(label, "prove", "Traces every ray that differs again with its cause alone taken away, and counts those that then agree",
                  possible, why))
    asked = ++model.request.proveAll;
  ImGui::SameLine(0.0f, unit(6));
  if (smallButton("Export CSV", "csv",
                  "Writes the causes, and the meshes that cost rays, as CSV files in the folder where the program was started")) {
    exportCsv(model, "causes", causeRows(frame.truthTotals, frame.proofs.get()));
    if (frame.ledger) exportCsv(model, "costly_meshes", meshRows(*frame.ledger, frame.scene->names));
  }
}

void drawCauseStrip(WindowModel& model, bool both, bool& showMeshes) {
  const FrameSnapshot& frame = *model.frame;
  beginStrip();
  textMono(grouped(frame.truthTotals.differ()));
  ImGui::SameLine(0.0f, unit(6));
  textDim("of " + grouped(frame.truthTotals.rays) + " rays differ");
  if (frame.proofs) {
    const ProofTotals::Count sum = frame.proofs->sum();
    ImGui::SameLine(0.0f, unit(12));
    textDim(percentOf(sum.alone + sum.chain, sum.total) + " confirmed, control " + percentOf(sum.controlChained, sum.controlTotal));
  }
  if (!both) {
    ImGui::SameLine(0.0f, unit(12));
    if (smallButton(showMeshes ? "Causes" : "Meshes", "turn", "Causes and meshes take turns in a narrow window")) showMeshes = !showMeshes;
  }
  drawProve(model);
}

// Without the truth: how to get it.
void drawUntold(WindowModel& model) {
  if (model.request.truth) return emptyState("Comparing every ray with the exact hit...");
  emptyState("Causes are found by comparing every ray with the exact hit among all triangles.");
  ImGui::Dummy(ImVec2(0.0f, unit(4)));
  if (keyButton("Tell the truth", "")) model.request.truth = true;
}

}  // namespace

void drawCauses(WindowModel& model) {
  static bool showMeshes = false;
  if (!model.frame || !model.frame->scene) return emptyState("No frame yet: it shows here as soon as the first one is done.");
  if (!model.frame->truths) return drawUntold(model);
  const float width = ImGui::GetContentRegionAvail().x;
  const bool both = width >= unit(kBothWidth);
  drawCauseStrip(model, both, showMeshes);
  if (model.frame->truthTotals.differ() == 0) return emptyState("Every ray agrees with the exact hit.");
  const bool ledger = bool(model.frame->ledger);
  if (both || !showMeshes) drawCauseTable(model, ImVec2(both && ledger ? 0.58f * width : 0.0f, 0.0f));
  if (both && ledger) ImGui::SameLine(0.0f, unit(8));
  if (ledger && (both || showMeshes)) drawMeshTable(model, ImVec2(0.0f, 0.0f));
}

}  // namespace gridscope
