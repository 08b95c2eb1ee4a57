// The tab "Pixel": what the selected pixel's ray should have met, what it met, why they differ and whether that is proven; and the frame's
// verdicts as a whole.
#include <algorithm>
#include <array>

#include "app/base/text.h"
#include "app/frame/find_next.h"
#include "app/frame/scene_places.h"
#include "app/frame/table_exports.h"
#include "app/frame/table_rows.h"
#include "app/model/exports.h"
#include "app/model/held_ray.h"
#include "app/model/ray_stepping.h"
#include "app/report/pixel_brief.h"
#include "app/ui/panels/inspector.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/panels/truth_marks.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

constexpr size_t kMostCells = 50;

// --- The story --------------------------------------------------------------------------------------------------------------------

SentencePart partOf(const RecordedRay& ray, const SceneFacts& scene, const StoryPart& part) {
  SentencePart made{.text = part.text};
  switch (part.kind) {
    case StoryPart::Kind::mesh: made.link = SentencePart::Link::instance, made.number = sceneInstanceOf(scene, part.reference); break;
    case StoryPart::Kind::triangle: made.link = SentencePart::Link::triangle, made.number = part.reference; break;
    case StoryPart::Kind::cell: made.link = SentencePart::Link::cell, made.cell = part.cell; break;
    case StoryPart::Kind::step:
      made.link = SentencePart::Link::step;
      for (size_t i = 0; i < ray.record.steps.size(); ++i)
        if (ray.record.steps[i].segment == part.segment)
          made.number = static_cast<uint32_t>(i), made.text = part.text.substr(0, 5) + std::to_string(i);
      break;
    case StoryPart::Kind::refused: made.colour = kColourSaturated; break;
    default: break;
  }
  return made;
}

// The story of the selected pixel, told once.
const Sentence& shownStory(const FrameSnapshot& frame, const std::shared_ptr<const RecordedRay>& shown) {
  static std::shared_ptr<const RecordedRay> known;
  static Sentence story;
  if (known == shown) return story;
  known = shown;
  const RecordedRay& ray = *shown;
  story.clear();
  const TraceInput trace{*frame.grid, frame.scene->numbered, *frame.worldTriangles, frame.parameters.trace};
  const TruthInput truth{trace, *frame.demand};
  const StoryInput input{.truth = truth,
                         .names = frame.scene->names,
                         .pixel = ray.pixel,
                         .width = frame.request.settings->width,
                         .ray = ray.ray,
                         .traced = ray.record.hit,
                         .exact = *ray.exact,
                         .told = *ray.truth,
                         .proof = nullptr};
  for (const StoryPart& part : tellBriefly(input)) story.push_back(partOf(ray, *frame.scene, part));
  return story;
}

void drawProof(WindowModel& model, const RecordedRay& ray) {
  if (ray.truth->cause == kCauseNone) return;
  if (!ray.proof) {
    const bool asked = model.request.proveRecorded;
    if (keyButton(asked ? "Proving..." : "Prove", "", !asked, "The ray is traced again without this event"))
      model.request.proveRecorded = true;
    whyTooltip("Traces the ray again with this event alone taken away: the cause is proven when it then agrees");
    return;
  }
  const Proof& proof = *ray.proof;
  const size_t links = proof.links.size();
  const char* end = proof.foreign ? "ends as the frame's hit does" : "agrees";
  Sentence sentence;
  if (proof.confirmed) {
    sentence.push_back({.text = "Proven. ", .colour = kColourTriangleHit});
    const char* how = proof.foreign ? "With that rule changed" : proofWords(links == 1 ? proof.links[0].cause : kCauseNone);
    sentence.push_back({.text = links == 1 ? printed("%s, the ray %s.", how, end)
                                           : printed("With these %zu events taken away in turn, the ray %s:", links, end)});
  } else {
    sentence.push_back({.text = "Not confirmed. ", .colour = kColourHole});
    sentence.push_back(
        {.text = links == 1 ? "Taking this event away leaves the ray different: " + hitWords(proof.hit) + "."
                            : printed("Taking these %zu events away leaves the ray different: ", links) + hitWords(proof.hit) + ":"});
  }
  for (size_t i = 0; links > 1 && i < links; ++i) {
    sentence.push_back({.text = " " + std::string(causeName(proof.links[i].cause).title)});
    if (proof.links[i].cell.x >= 0) {
      sentence.push_back({.text = " in "});
      sentence.push_back({.text = cellNumbers(proof.links[i].cell), .link = SentencePart::Link::cell, .cell = proof.links[i].cell});
    }
    sentence.push_back({.text = i + 1 == links ? "." : ","});
  }
  drawSentenceBox(model, sentence, ray.proof->confirmed ? kColourTriangleHit : kColourHole, "proof");
}

// --- Grid and exact ---------------------------------------------------------------------------------------------------------------

void compareRow(const char* label, const std::string& grid, const std::string& exact) {
  ImGui::TableNextRow(0, tableRowHeight());
  ImGui::TableSetColumnIndex(0);
  smallText(label, uiColour(UiColour::dim));
  ImGui::TableSetColumnIndex(1);
  leftNumber(grid, uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(2);
  leftNumber(exact, uiColour(UiColour::text));
}

void kindCell(int column, const Hit* hit) {
  ImGui::TableSetColumnIndex(column);
  if (!hit) return smallText("not told", uiColour(UiColour::disabled));
  const char* word = hit->kind == kHitTriangle ? "triangle hit"
                     : hit->kind == kHitVoxel  ? "voxel hit"
                     : hit->kind == kHitNoRay  ? "no ray"
                                               : "miss";
  smallText(word, meaningColour(hitKindColour(hit->kind)));
}

void triangleCell(WindowModel& model, int column, const Hit* hit) {
  ImGui::TableSetColumnIndex(column);
  if (!hit || hit->reference == kNoReference) return smallText("-", uiColour(UiColour::dim));
  const TriangleName name = nameTriangle(model.frame->scene->numbered, hit->reference);
  if (link(grouped(name.triangle), column == 1 ? "grid triangle" : "exact triangle")) model.selection.selectTriangle(hit->reference);
}

void cellCell(WindowModel& model, int column, const Ray& ray, const Hit* hit) {
  ImGui::TableSetColumnIndex(column);
  if (!hit || hit->reference == kNoReference) return smallText("-", uiColour(UiColour::dim));
  const ivec3 cell = gridCell(model.frame->gridShape(), rayPoint(ray, hit->t));
  if (!gridContains(model.frame->gridShape(), cell)) return smallText("outside", uiColour(UiColour::dim));
  if (link(cellNumbers(cell), column == 1 ? "grid cell" : "exact cell")) model.selection.selectCell(cell);
}

void labelCell(const char* label) {
  ImGui::TableNextRow(0, tableRowHeight());
  ImGui::TableSetColumnIndex(0);
  smallText(label, uiColour(UiColour::dim));
}

void drawComparison(WindowModel& model, const RecordedRay& ray) {
  const SceneFacts& scene = *model.frame->scene;
  const Hit* grid = &ray.record.hit;
  const Hit* exact = ray.exact ? &*ray.exact : nullptr;
  const auto distance = [](const Hit* hit) { return hit && hit->reference != kNoReference ? printed("%.6f", hit->t) : std::string("-"); };
  const auto mesh = [&](const Hit* hit) {
    return hit && hit->reference != kNoReference ? meshName(scene, nameTriangle(scene.numbered, hit->reference).mesh) : std::string("-");
  };
  TableStyle style;
  if (!ImGui::BeginTable("grid and exact", 3, kTableFlags & ~ImGuiTableFlags_Resizable)) return;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 0.7f);
  ImGui::TableSetupColumn("grid", ImGuiTableColumnFlags_WidthStretch, 1.0f);
  ImGui::TableSetupColumn("exact", ImGuiTableColumnFlags_WidthStretch, 1.0f);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, tableRowHeight());
  for (int column = 1; column < 3; ++column)
    if (ImGui::TableSetColumnIndex(column)) tableTitle(column == 1 ? "grid" : "exact", false);
  labelCell("Kind"), kindCell(1, grid), kindCell(2, exact);
  compareRow("Distance", distance(grid), distance(exact));
  compareRow("Mesh", mesh(grid), mesh(exact));
  labelCell("Triangle"), triangleCell(model, 1, grid), triangleCell(model, 2, exact);
  labelCell("Cell"), cellCell(model, 1, ray.ray, grid), cellCell(model, 2, ray.ray, exact);
  if (ray.truth && ray.truth->error != 0.0f) compareRow("Error", printed("%.3f cells", ray.truth->error), "");
  ImGui::EndTable();
}

// --- The frame's verdicts ---------------------------------------------------------------------------------------------------------

struct VerdictLine {
  std::string title;
  uint64_t rays;
  uint32_t verdict;
  bool agrees;
  bool outlined;  // agreeing misses: a frame, not a square
};

std::vector<VerdictLine> verdictLines(const TruthTotals& totals) {
  std::vector<VerdictLine> lines{{"Agrees, hit", totals.agreeHit, kVerdictAgrees, true, false},
                                 {"Agrees, miss", totals.agreeMiss, kVerdictAgrees, true, true}};
  for (const uint32_t verdict : {kVerdictHole, kVerdictVoxelRight, kVerdictVoxelWrong, kVerdictTooFar, kVerdictTooNear}) {
    std::string title(verdictName(verdict).title);
    if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    lines.push_back({title, totals.verdicts[verdict], verdict, false, false});
  }
  return lines;
}

ImVec4 lineColour(const VerdictLine& line) { return line.agrees ? uiColour(UiColour::dim) : meaningColour(verdictColour(line.verdict)); }

void drawVerdictBar(const std::vector<VerdictLine>& lines, uint64_t rays) {
  const float width = ImGui::GetContentRegionAvail().x, height = unit(12);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  float x = low.x;
  for (const VerdictLine& line : lines) {
    const float part = width * float(double(line.rays) / double(std::max<uint64_t>(rays, 1)));
    ImVec4 colour = lineColour(line);
    if (line.outlined) colour.w = 0.4f;
    if (part > 0.0f)
      ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, low.y), ImVec2(x + std::max(part - 1.0f, 1.0f), low.y + height), packed(colour));
    x += part;
  }
  ImGui::Dummy(ImVec2(width, height + unit(2)));
}

void drawVerdictRow(WindowModel& model, const VerdictLine& line) {
  ImGui::TableNextRow(0, tableRowHeight());
  ImGui::TableSetColumnIndex(0);
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const ImVec2 low(place.x, place.y + unit(3)), high(place.x + unit(10), place.y + unit(13));
  if (line.outlined)
    ImGui::GetWindowDrawList()->AddRect(low, high, packed(lineColour(line)), unit(2));
  else
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, packed(lineColour(line)), unit(2));
  ImGui::Dummy(ImVec2(unit(10), unit(14)));
  ImGui::SameLine(0.0f, unit(6));
  smallText(line.title, uiColour(UiColour::text));
  whyTooltip(std::string(verdictName(line.verdict).about).c_str());
  ImGui::TableSetColumnIndex(1);
  rightNumber(grouped(line.rays), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(2);
  rightNumber(percentOf(line.rays, model.frame->truthTotals.rays), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(3);
  if (line.agrees || line.rays == 0) return;
  if (!link("next", line.title.c_str())) return;
  if (const auto pixel = nextRay(*model.frame, model.rayOrder.pixels, model.selected().pixel, {.verdict = line.verdict}))
    model.selection.selectPixel(*pixel);
}

void drawVerdicts(WindowModel& model) {
  const TruthTotals& totals = model.frame->truthTotals;
  bool csv = false;
  const bool open = tableSection("Verdicts", grouped(totals.rays) + " rays", 1, csv);
  if (csv) exportCsv(model, "verdicts", verdictRows(totals));
  if (!open) return;
  const std::vector<VerdictLine> lines = verdictLines(totals);
  drawVerdictBar(lines, totals.rays);
  TableStyle style;
  if (!ImGui::BeginTable("verdicts", 4, kTableFlags & ~ImGuiTableFlags_Resizable)) return;
  for (const float weight : {1.5f, 0.9f, 0.8f, 0.4f}) ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, weight);
  for (const VerdictLine& line : lines) drawVerdictRow(model, line);
  ImGui::EndTable();
}

// The ledger's cells that cost the most rays, found once.
const std::vector<size_t>& worstCells(const FrameSnapshot& frame) {
  static std::shared_ptr<const Ledger> known;
  static std::vector<size_t> worst;
  if (known != frame.ledger) known = frame.ledger, worst = worstOf(std::span<const CellLoss>(frame.ledger->cells), kMostCells);
  return worst;
}

void drawWorstCells(WindowModel& model) {
  if (!model.frame->ledger) return;
  const std::vector<size_t>& worst = worstCells(*model.frame);
  bool csv = false;
  const bool open = tableSection("Cells that cost the most pixels", "", worst.size(), csv);
  if (csv) exportCsv(model, "costly_cells", costlyCellRows(*model.frame->ledger));
  if (!open) return;
  if (worst.empty()) return emptyState("No cell cost a pixel.");
  TableStyle style;
  const float room = ImGui::GetContentRegionAvail().y - unit(40);
  if (!ImGui::BeginTable("worst cells", 4, (kTableFlags | ImGuiTableFlags_ScrollY) & ~ImGuiTableFlags_Resizable,
                         ImVec2(0.0f, std::max(room, unit(120)))))
    return;
  const char* titles[] = {"cell", "tried", "refused", "pixels"};
  for (const char* title : titles) ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthStretch, title == titles[0] ? 1.6f : 1.0f);
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, tableRowHeight());
  for (int column = 0; column < 4; ++column)
    if (ImGui::TableSetColumnIndex(column)) tableTitle(titles[column], column > 0);
  for (size_t i = 0; i < worst.size(); ++i) {
    const CellLoss& loss = model.frame->ledger->cells[worst[i]];
    ImGui::TableNextRow(0, tableRowHeight());
    ImGui::TableSetColumnIndex(0);
    ImGui::PushID(static_cast<int>(i));
    if (rowSelectable(model.selected().cell == loss.cell)) model.selection.selectCell(loss.cell);
    leftNumber(cellNumbers(loss.cell), uiColour(UiColour::link));
    ImGui::TableSetColumnIndex(1);
    rightNumber(grouped(loss.tried), uiColour(UiColour::text));
    ImGui::TableSetColumnIndex(2);
    rightNumber(grouped(loss.refused), loss.refused ? meaningColour(kColourSaturated) : uiColour(UiColour::dim));
    ImGui::TableSetColumnIndex(3);
    rightNumber(grouped(loss.rays), uiColour(UiColour::text));
    ImGui::PopID();
  }
  ImGui::EndTable();
}

// --- The tab ----------------------------------------------------------------------------------------------------------------------

void drawButtons(WindowModel& model, const RecordedRay& ray) {
  if (keyButton("Step this ray", "Enter", !ray.record.steps.empty(), "The ray has no steps")) {
    model.showTab(BottomTab::steps);
    stepFirst(model);
  }
  if (!ray.truth || ray.truth->verdict == kVerdictAgrees) return;
  ImGui::SameLine(0.0f, unit(6));
  if (keyButton("Next such", ""))
    if (const auto pixel =
            nextRay(*model.frame, model.rayOrder.pixels, ray.pixel, {.verdict = ray.truth->verdict, .cause = ray.truth->cause}))
      model.selection.selectPixel(*pixel);
  whyTooltip("The next ray of the same verdict and cause");
}

void drawUntold(WindowModel& model) {
  if (model.request.truth)
    return emptyState(model.frame->truths ? "Comparing this ray with the exact hit..." : "Comparing every ray with the exact hit...");
  emptyState("Whether this ray agrees with the exact hit, and if not why, is not known yet.");
  if (keyButton("Tell the truth", "")) model.request.truth = true;
  whyTooltip("Traces every ray of the frame against all triangles, and finds the cause of each that differs; some seconds");
}

void drawRay(WindowModel& model, const std::shared_ptr<const RecordedRay>& shown) {
  const FrameSnapshot& frame = *model.frame;
  const RecordedRay& ray = *shown;
  const uint32_t width = frame.request.settings->width;
  InspectorTitle title{.name = printed("Pixel %u, %u", ray.pixel % width, ray.pixel / width)};
  const bool told = ray.truth && ray.exact && frame.demand && frame.grid && frame.worldTriangles;
  title.word = told ? std::string(verdictName(ray.truth->verdict).title) : hitWords(ray.record.hit);
  title.colour = told ? verdictColour(ray.truth->verdict) : hitKindColour(ray.record.hit.kind);
  if (frame.gather && ray.pixel < frame.gather->size() && (*frame.gather)[ray.pixel].reference != kNoReference) {
    title.focus = Bounds{};
    title.focus->include((*frame.gather)[ray.pixel].position);
    if (ray.record.hit.reference != kNoReference) title.focus->include(rayPoint(ray.ray, ray.record.hit.t));
  }
  if (told) title.text = plainText(shownStory(frame, shown));
  drawInspectorTitle(model, title);
  if (ray.ray.valid == 0) return emptyState("No surface is seen here, so there is no ray.");
  if (told) {
    drawSentenceBox(model, shownStory(frame, shown), ray.truth->cause == kCauseNone ? kColourTriangleHit : causeColour(ray.truth->cause),
                    "story");
    ImGui::Dummy(ImVec2(0.0f, unit(1)));
    drawProof(model, ray);
  } else {
    drawUntold(model);
  }
  ImGui::Dummy(ImVec2(0.0f, unit(2)));
  drawButtons(model, ray);
  ImGui::Dummy(ImVec2(0.0f, unit(2)));
  if (sectionHeader("Grid and exact")) drawComparison(model, ray);
}

}  // namespace

void drawPixelTab(WindowModel& model) {
  if (!model.frame || !model.frame->scene || !model.frame->request.settings) return emptyState("No frame yet.");
  const std::shared_ptr<const RecordedRay> ray = shownRay(model);
  if (ray)
    drawRay(model, ray);
  else
    emptyState(model.selected().pixel ? "Recording the ray..." : "No pixel selected. Click one, or press N for the next hole.");
  if (!model.frame->truths) return;
  drawVerdicts(model);
  drawWorstCells(model);
}

}  // namespace gridscope
