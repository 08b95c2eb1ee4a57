// The inspector of a step: its facts, every test of its cell, and what the cell refused.
#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/frame/table_exports.h"
#include "app/model/exports.h"
#include "app/model/ray_stepping.h"
#include "app/ui/panels/inspector.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/trace/triangle_test.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

void drawGate(const StepFacts& facts, bool filled) {
  factLabel("Gate", facts.changes.gate);
  textMono(printed("%.2f", facts.travel));
  ImGui::SameLine(0.0f, unit(6));
  const bool open = facts.travel > facts.gate;
  const std::string word = !filled ? "gap-filling is off" : printed("%s %.2f, %s", open ? ">" : "<=", facts.gate, open ? "open" : "held");
  smallText(word, meaningColour(!filled ? kColourEmpty : open ? kColourTriangleHit : kColourGate));
  whyTooltip("Distance from the launch plane in cell edges; gaps are filled only beyond the threshold");
}

void drawBest(WindowModel& model, const StepFacts& facts) {
  factLabel("Best hit so far", facts.changes.best);
  if (!facts.best) return textMono("none");
  textMono(printed("t %.4f", facts.best->t));
  ImGui::SameLine(0.0f, unit(8));
  const TriangleName name = nameTriangle(model.frame->scene->numbered, facts.best->reference);
  if (link(grouped(name.triangle), "best")) model.selection.selectTriangle(facts.best->reference);
  if (facts.best->step == facts.index) return;
  ImGui::SameLine(0.0f, unit(8));
  if (link(printed("step %u", facts.best->step), "best step")) selectStepAt(model, facts.best->step);
}

void drawReported(const ShownStep& shown) {
  const Hit& hit = shown.ray->record.hit;
  factLabel("Reported");
  if (hit.kind != kHitVoxel && hit.kind != kHitTriangle) return textMono(hitWords(hit));
  textMono(printed("t %.6g", hit.t));
  ImGui::SameLine(0.0f, unit(6));
  const bool voxel = hit.kind == kHitVoxel && !shown.facts.tests.empty();
  textDim(voxel ? printed("last reference, slot %u", shown.facts.tests.back().test.slot) : printed("u %.3f v %.3f", hit.u, hit.v));
}

void drawFacts(WindowModel& model, const ShownStep& shown) {
  const StepFacts& facts = shown.facts;
  factValue("Segment, start", pointText(facts.start));
  factValue("Segment, end", pointText(facts.end));
  const std::string window =
      facts.window.y >= kFar ? printed("t from %.3f on", facts.window.x) : printed("t %.3f to %.3f", facts.window.x, facts.window.y);
  factValue("Hits count", window);
  whyTooltip("The elongated segment: hits within it count");
  factLabel("Cell", facts.changes.cell);
  if (!facts.inGrid)
    textMono("outside the grid");
  else if (link(cellNumbers(facts.cell), "cell"))
    model.selection.selectCell(facts.cell);
  factLabel("Stored, refused", facts.changes.stored || facts.changes.refused);
  textMono(printed("%u,", facts.stored));
  ImGui::SameLine(0.0f, unit(5));
  leftNumber(std::to_string(facts.refused), facts.refused ? meaningColour(kColourSaturated) : uiColour(UiColour::text));
  drawGate(facts, model.frame->parameters.trace.gapFill != 0);
  drawBest(model, facts);
  if (facts.index + 1 == shown.ray->record.steps.size()) drawReported(shown);
  ImGui::PushTextWrapPos(0.0f);
  textDim(facts.read);
  textDim(facts.went);
  ImGui::PopTextWrapPos();
}

// --- Tests ------------------------------------------------------------------------------------------------------------------------

// A row of either table: a mesh's name, or a test of it.
struct TestRow {
  bool isMesh = false;
  uint32_t mesh = 0, count = 0;  // of a mesh's row
  TestRecord test{};
  vec2 weights{0.0f};
  TriangleName name{};
  bool marked = false;  // new in this step
  bool best = false;
  bool filled = false;  // the reference that the voxel hit reports
  bool refused = false, wouldHit = false;
};

void addRow(std::vector<TestRow>& rows, size_t& meshRow, const TestRow& row) {
  if (rows.empty() || rows[meshRow].mesh != row.name.mesh) {
    meshRow = rows.size();
    rows.push_back({.isMesh = true, .mesh = row.name.mesh});
  }
  ++rows[meshRow].count;
  rows.push_back(row);
}

std::vector<TestRow> testRows(const ShownStep& shown) {
  std::vector<TestRow> rows;
  size_t meshRow = 0;
  const Hit& hit = shown.ray->record.hit;
  for (const TestFacts& test : shown.facts.tests)
    addRow(rows, meshRow,
           {.test = test.test,
            .weights = test.weights,
            .name = test.name,
            .marked = test.isNew,
            .best = test.best,
            .filled = shown.facts.kind == StepOutcome::voxelHit && test.test.reference == hit.reference});
  return rows;
}

std::vector<TestRow> refusedRows(const StepFacts& facts) {
  std::vector<TestRow> rows;
  for (const RefusedFacts& refused : facts.refusedTests)
    rows.push_back({.test = refused.test, .weights = refused.weights, .name = refused.name, .refused = true, .wouldHit = refused.wouldHit});
  return rows;
}

void numberCell(int column, const TestRow& row, const char* format, float value) {
  ImGui::TableSetColumnIndex(column);
  if (row.test.verdict == kTestParallel) return rightNumber("-", uiColour(UiColour::dim));
  const bool beside = row.test.verdict == kTestOutside && (value < 0.0f || value > 1.0f) && column > 2;
  rightNumber(std::abs(value) < 1e4f ? printed(format, value) : printed("%.1e", value), uiColour(beside ? UiColour::text : UiColour::dim));
}

void verdictCell(const TestRow& row) {
  ImGui::TableSetColumnIndex(5);
  if (row.filled) return smallText("last, filled", meaningColour(kColourVoxelHit));
  if (row.wouldHit) return smallText("would hit", meaningColour(kColourTriangleHit));
  swatch(testColour(row.test.verdict));
  smallText(testWord(row.test),
            row.best ? meaningColour(kColourTriangleHit) : uiColour(row.test.verdict == kTestOutside ? UiColour::dim : UiColour::text));
  if (row.test.verdict == kTestAlpha) whyTooltip("Turned down: the byte read from the alpha map is below the material's threshold");
}

// Over all columns.
void drawMeshName(const WindowModel& model, const TestRow& row) {
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth();
  ImGui::PushClipRect(ImVec2(place.x, place.y - unit(2)), ImVec2(right, place.y + tableRowHeight()), false);
  smallText(meshName(*model.frame->scene, row.mesh) + printed(", %u reference%s", row.count, row.count == 1 ? "" : "s"),
            uiColour(UiColour::dim));
  ImGui::PopClipRect();
}

void drawTestRow(WindowModel& model, const TestRow& row, int id) {
  ImGui::TableNextRow(0, tableRowHeight());
  ImGui::TableSetColumnIndex(0);
  if (row.isMesh) return drawMeshName(model, row);
  ImGui::PushID(id);
  const ImVec2 place = ImGui::GetCursorScreenPos();
  if (rowSelectable(row.best || row.filled || row.wouldHit)) model.selection.selectTriangle(row.test.reference);
  whyTooltip((printed("Reference 0x%08X", row.test.reference) + ", " + materialName(*model.frame->scene, row.test.reference) +
              (row.marked ? "\nNot tested by the step before" : ""))
                 .c_str());
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (row.marked) list->AddCircleFilled(ImVec2(place.x + unit(1), place.y + unit(8)), unit(2), packed(meaningColour(kColourVoxelHit)), 8);
  if (row.refused)
    list->AddRectFilled(ImVec2(place.x, place.y + unit(4)), ImVec2(place.x + unit(8), place.y + unit(12)),
                        packed(meaningColour(kColourSaturated)), unit(1));
  else
    rightNumber(std::to_string(row.test.slot), uiColour(UiColour::dim));
  ImGui::TableSetColumnIndex(1);
  rightNumber(grouped(row.name.triangle), uiColour(UiColour::link));
  numberCell(2, row, "%.3f", row.test.t);
  numberCell(3, row, "%.3f", row.weights.x);
  numberCell(4, row, "%.3f", row.weights.y);
  verdictCell(row);
  ImGui::PopID();
}

void drawTestTable(WindowModel& model, const char* id, const std::vector<TestRow>& rows, float height) {
  TableStyle style;
  if (!ImGui::BeginTable(id, 6, (kTableFlags | ImGuiTableFlags_ScrollY) & ~ImGuiTableFlags_Resizable, ImVec2(0.0f, height))) return;
  const std::pair<const char*, float> columns[] = {{"slot", 0.55f}, {"triangle", 1.0f}, {"t", 0.9f},
                                                   {"u", 0.95f},    {"v", 0.95f},       {"verdict", 1.45f}};
  for (const auto& [title, weight] : columns) ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthStretch, weight);
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, tableRowHeight());
  for (int column = 0; column < 6; ++column)
    if (ImGui::TableSetColumnIndex(column)) tableTitle(columns[column].first, column < 5);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), tableRowHeight());
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) drawTestRow(model, rows[size_t(row)], row);
  ImGui::EndTable();
}

std::string refusedNote(const StepFacts& facts) {
  if (!facts.refusedKnown) return printed("%u", facts.refused);
  const auto would =
      std::count_if(facts.refusedTests.begin(), facts.refusedTests.end(), [](const RefusedFacts& refused) { return refused.wouldHit; });
  return printed("%zu refused, %td would hit", facts.refusedTests.size(), would);
}

// The proof of the ray's cause, where it took place in this step's cell.
void drawProof(WindowModel& model, const ShownStep& shown) {
  const RecordedRay& ray = *shown.ray;
  if (!ray.proof || !ray.truth || ray.truth->cell != shown.facts.cell || !ray.proof->confirmed) return;
  const Hit& hit = ray.proof->hit;
  Sentence sentence{{.text = "Proven. ", .colour = kColourTriangleHit},
                    {.text = "Without this event the ray ends as the exact reference says: " + hitWords(hit) + "."}};
  drawSentenceBox(model, sentence, kColourTriangleHit, "proof");
}

// Heights of the tables: each as much as its rows need, the rest shared.
float tableHeight(size_t rows) { return float(rows + 1) * tableRowHeight() + unit(4); }

std::string plainFacts(const ShownStep& shown) {
  std::string text = plainText(shown.sentence) + "\n" + shown.facts.read + "\n" + shown.facts.went + "\n";
  for (const TestFacts& test : shown.facts.tests)
    text += printed("slot %u  triangle %u  t %.9g  u %.9g  v %.9g  ", test.test.slot, test.name.triangle, test.test.t, test.weights.x,
                    test.weights.y) +
            testWord(test.test) + "\n";
  return text;
}

}  // namespace

void drawStepInspector(WindowModel& model, const ShownStep& shown) {
  const StepFacts& facts = shown.facts;
  const StepLook& look = stepLook(facts.kind);
  InspectorTitle title{.name = printed("Step %u", facts.index), .word = std::string(look.word), .colour = look.colour, .glyph = facts.kind};
  if (facts.inGrid) title.focus = Bounds{glm::min(facts.start, facts.end), glm::max(facts.start, facts.end)};
  title.text = plainFacts(shown);
  drawInspectorTitle(model, title);
  drawFacts(model, shown);
  ImGui::Dummy(ImVec2(0.0f, unit(2)));

  const std::vector<TestRow> tests = testRows(shown), refused = refusedRows(facts);
  const auto hits =
      std::count_if(facts.tests.begin(), facts.tests.end(), [](const TestFacts& test) { return test.test.verdict == kTestHit; });
  const bool proven = shown.ray->proof && shown.ray->proof->confirmed;
  const float room = ImGui::GetContentRegionAvail().y - unit(26 + 10) - (facts.refused ? unit(34) : 0.0f) - (proven ? unit(60) : 0.0f);
  const float refusedHeight =
      std::min(tableHeight(std::max<size_t>(refused.size(), 1)), std::max(0.35f * room, room - tableHeight(tests.size())));
  bool csv = false;
  const bool open =
      tableSection("Tests", printed("%zu tested, %td hit", facts.tests.size(), hits), facts.tests.size() + facts.refusedTests.size(), csv);
  if (csv) exportCsv(model, printed("tests_step_%u", facts.index), testRows(*model.frame->scene, facts));
  if (open) {
    if (tests.empty())
      emptyState("No reference was tested in this step.");
    else
      drawTestTable(model, "tests", tests,
                    std::max(std::min(tableHeight(tests.size()), room - (facts.refused ? refusedHeight : 0.0f)), unit(80)));
  }
  if (facts.refused && sectionHeader("Refused", refusedNote(facts))) {
    if (refused.empty())
      emptyState(facts.refusedKnown ? "This grid does not say which."
                                    : "Which ones is known once the truth is told: Pixel tab, or the Causes tab.");
    else
      drawTestTable(model, "refused", refused, std::max(refusedHeight, unit(80)));
  }
  drawProof(model, shown);
}

}  // namespace gridscope
