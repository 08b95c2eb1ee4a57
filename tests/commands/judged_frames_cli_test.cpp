// The commands that judge a frame agree with each other: on a capture's own hits, on the frame of a sequence that was asked for, and the page
// of a report shows what the JSON of explain says.
#include <gtest/gtest.h>

#include <regex>

#include <nlohmann/json.hpp>

#include "app/base/text.h"
#include "core/capture/capture.h"
#include "core/grid/derive.h"
#include "core/grid/grid.h"
#include "tests/commands/program.h"
#include "tests/grid_words.h"

namespace gridscope {
namespace {

using Json = nlohmann::json;

class JudgedFrames : public ProgramTest {
 protected:
  std::string foreign() { return (std::filesystem::path(GRIDSCOPE_CAPTURES) / "foreign.gridcap").string(); }

  Json results(std::vector<std::string> arguments, int exitCode = 0) {
    arguments.insert(arguments.end(), {"--json", "results.json"});
    ended_ = run(arguments);
    EXPECT_EQ(ended_.exitCode, exitCode) << ended_.out << ended_.err;
    return Json::parse(fileText(folder_ / "results.json"), nullptr, false);
  }

  // A capture of this program whose hits are another engine's: every second one is a miss.
  void writeOtherHits(const char* name) {
    ASSERT_EQ(run({"capture", "saturated-cell", "--size", "32x18", "-o", name}).exitCode, 0);
    Capture capture = readCapture(folder_ / name);
    for (size_t i = 0; i < capture.frames[0].hits.size(); i += 2)
      if (capture.frames[0].hits[i].kind == kHitTriangle) capture.frames[0].hits[i] = {kHitMiss, 0.0f, kNoReference, 0.0f, 0.0f};
    writeCapture(folder_ / name, capture);
  }

  void writeSequence() {
    ASSERT_EQ(run({"capture", "moving-crowd", "--size", "32x18", "--cells", "12", "--capacity", "4", "--sequence", "3", "--frame-step",
                   "0.7", "-o", "sequence.gridcap"})
                  .exitCode,
              0);
  }

  // The second column of a row of a table on a page: the first row whose first column has that text.
  static std::string figureOf(const std::string& page, const std::string& name) {
    std::smatch found;
    const std::regex row("<tr[^>]*><td[^>]*>(?:<span[^>]*></span>)?" + name + "</td><td[^>]*>([^<]*)</td>");
    return std::regex_search(page, found, row) ? found[1].str() : "no row";
  }

  Ended ended_;
};

TEST_F(JudgedFrames, ExplainCheckAndReportJudgeTheHitsThatACaptureHolds) {
  writeOtherHits("other.gridcap");
  for (const std::string& file : {std::string("other.gridcap"), foreign()}) {
    const Json explained = results({"explain", file});
    const Json checked = results({"check", file, "--fail-if", "wrong>100%"});
    EXPECT_EQ(explained["wrong"], checked["wrong"]) << file;
    EXPECT_EQ(explained["verdicts"], checked["verdicts"]) << file;
    EXPECT_EQ(explained["foreignHits"], checked["foreignHits"]) << file;
    ASSERT_EQ(run({"report", file, "-o", "report.html"}).exitCode, 0);
    EXPECT_EQ(figureOf(fileText(folder_ / "report.html"), "wrong"), grouped(explained["wrong"].get<uint64_t>())) << file;
  }
  const Json rendered = results({"render", "other.gridcap", "--view", "hit-kind"}), checked = results({"check", "other.gridcap"});
  EXPECT_EQ(rendered["rays"]["misses"], checked["hits"]["miss"]) << "pictures show what is judged";
  EXPECT_EQ(rendered["foreignHits"], checked["foreignHits"]);
  const Json other = results({"explain", "other.gridcap"});
  EXPECT_GT(other["foreignHits"], 0);
  EXPECT_NE(ended_.out.find("are not what this trace ends with"), std::string::npos) << ended_.out;
}

TEST_F(JudgedFrames, CheckTestsCapturedHitsAndSaysSoInAStageOfTheirOwn) {
  writeOtherHits("other.gridcap");
  Capture capture = readCapture(folder_ / "other.gridcap");
  size_t valid = 0;
  while (!capture.frames[0].rays[valid].valid) ++valid;
  capture.frames[0].hits[valid] = {kHitNoRay, 0.0f, kNoReference, 0.0f, 0.0f};
  writeCapture(folder_ / "unended.gridcap", capture);
  EXPECT_EQ(results({"check", "other.gridcap"})["stages"].back()["stage"], "captured hits");
  const Json json = results({"check", "unended.gridcap"}, 1);
  EXPECT_FALSE(json["stages"].back()["invariants"]["ended"]["holds"]);
}

TEST_F(JudgedFrames, NoFigureIsMadeUpForAGridThatDoesNotCountWhatItRefuses) {
  for (const char* command : {"explain", "check"}) {
    const Json json = results({command, foreign()});
    EXPECT_TRUE(json["references"]["refused"].is_null()) << command;
    EXPECT_TRUE(json["references"]["tried"].is_null()) << command;
    const Ended ended = run({command, foreign(), "--fail-if", "refused>1%"});
    EXPECT_EQ(ended.exitCode, 2) << command;
    EXPECT_NE(ended.err.find("references.refused has no value here"), std::string::npos) << ended.err;
  }
}

TEST_F(JudgedFrames, AFrameOfASequenceIsChosenAndNamed) {
  writeSequence();
  const Json first = results({"explain", "sequence.gridcap"});
  EXPECT_EQ(first["frame"], 0);
  EXPECT_NE(ended_.out.find("frame 0 of frames 0 to 2"), std::string::npos) << ended_.out;
  const Json last = results({"explain", "sequence.gridcap", "--frame", "2"});
  EXPECT_EQ(last["frame"], 2);
  EXPECT_EQ(last["foreignHits"], 0);
  EXPECT_NE(first["verdicts"], last["verdicts"]);
  EXPECT_EQ(results({"explain", "moving-crowd", "--size", "32x18", "--cells", "12", "--capacity", "4", "--frame-step", "0.7", "--frame",
                     "2"})["verdicts"],
            last["verdicts"]);
  ASSERT_EQ(run({"report", "sequence.gridcap", "--frame", "2", "-o", "report.html"}).exitCode, 0);
  EXPECT_EQ(figureOf(fileText(folder_ / "report.html"), "wrong"), grouped(last["wrong"].get<uint64_t>()));
  const Ended beyond = run({"explain", "sequence.gridcap", "--frame", "3"});
  EXPECT_EQ(beyond.exitCode, 2);
  EXPECT_NE(beyond.err.find("--frame 3: sequence.gridcap holds 3 frames"), std::string::npos) << beyond.err;
}

// The same grids without reserved texels, by another program: no build and no update can follow them.
void makeForeign(Capture& capture) {
  const GridParameters before = capture.grid;
  capture.writer = "engine 7";
  capture.grid.reserved = 0;
  capture.grid.stride = capture.grid.capacity;
  for (CaptureFrame& frame : capture.frames) {
    const Grid from{before, frame.grid};
    Grid to{capture.grid, std::vector<uint32_t>(gridByteCount(capture.grid) / sizeof(uint32_t))};
    ivec3 cell;
    for (cell.z = 0; cell.z < before.cellCount.z; ++cell.z)
      for (cell.y = 0; cell.y < before.cellCount.y; ++cell.y)
        for (cell.x = 0; cell.x < before.cellCount.x; ++cell.x)
          for (int slot = 0; slot < before.capacity; ++slot) slotAt(to, cell, slot) = slotAt(from, cell, slot);
    frame.grid = std::move(to.words);
  }
}

TEST_F(JudgedFrames, AFramesInstancesStandWhereItsOwnTransformsPutThemEvenWhenNoUpdateCanMoveThem) {
  writeSequence();
  Capture capture = readCapture(folder_ / "sequence.gridcap");
  makeForeign(capture);
  writeCapture(folder_ / "engine.gridcap", capture);
  const Json own = results({"check", "sequence.gridcap", "--fail-if", "wrong<0"});
  const Json foreign = results({"check", "engine.gridcap", "--fail-if", "wrong<0"});
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(foreign["frames"][frame]["verdicts"], own["frames"][frame]["verdicts"]) << frame;
    EXPECT_EQ(results({"explain", "engine.gridcap", "--frame", std::to_string(frame)})["verdicts"], own["frames"][frame]["verdicts"])
        << frame;
  }
}

TEST_F(JudgedFrames, EachFrameOfASequenceMustKeepToABudget) {
  writeSequence();
  const Json json = results({"check", "sequence.gridcap", "--fail-if", "wrong<0"});
  ASSERT_EQ(json["frames"].size(), 3u);
  uint64_t most = 0, last = json["frames"][2]["wrong"];
  size_t worst = 0;
  for (size_t i = 0; i < 3; ++i)
    if (json["frames"][i]["wrong"] > most) most = json["frames"][i]["wrong"], worst = i;
  ASSERT_NE(json["frames"][0]["wrong"], json["frames"][2]["wrong"]);
  EXPECT_EQ(json["wrong"], last);
  results({"check", "sequence.gridcap", "--fail-if", "wrong>=" + std::to_string(most)}, 1);
  EXPECT_NE(ended_.out.find("frame " + std::to_string(worst) + ": wrong>="), std::string::npos) << ended_.out;
  results({"check", "sequence.gridcap", "--fail-if", "frames.2.wrong>" + std::to_string(last)}, 0);
}

TEST_F(JudgedFrames, AFigureThatThereIsNotIsRefusedBeforeTheWork) {
  for (const char* command : {"explain", "check"}) {
    std::filesystem::remove(folder_ / "results.json");
    results({command, "saturated-cell", "--size", "16x9", "--fail-if", "gaet>1"}, 2);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "results.json")) << command;
    EXPECT_NE(ended_.err.find("causes.gate"), std::string::npos) << ended_.err;
  }
}

TEST_F(JudgedFrames, BudgetsTakeCausesByTheirShortNamesAndProofsByPlace) {
  results({"check", "saturated-cell", "--size", "32x18", "--fail-if", "gate>100%", "--fail-if", "steppedOver>100%", "--fail-if",
           "stages.0.invariants.sum.count>0"});
  const Json json = results(
      {"explain", "saturated-cell", "--size", "96x54", "--verify", "--fail-if", "confirmedShare<99%", "--fail-if", "control.share>100%"});
  for (const auto& [cause, counts] : json["confirmed"].items())
    if (counts[2] > 0) results({"explain", "saturated-cell", "--size", "96x54", "--verify", "--fail-if", "confirmed." + cause + ".2>0"}, 1);
}

TEST_F(JudgedFrames, APageShowsTheFiguresOfExplain) {
  const std::vector<std::string> frame = {"moving-crowd", "--size", "64x36", "--cells", "12", "--capacity", "4"};
  std::vector<std::string> explain = frame, report = frame;  // the page proves so few causes without being asked
  explain.insert(explain.begin(), {"explain", "--verify"});
  report.insert(report.begin(), "report");
  const Json json = results(explain);
  report.insert(report.end(), {"-o", "report.html"});
  ASSERT_EQ(run(report).exitCode, 0);
  const std::string page = fileText(folder_ / "report.html");
  EXPECT_EQ(figureOf(page, "wrong"), grouped(json["wrong"].get<uint64_t>()));
  EXPECT_EQ(figureOf(page, "agrees, hit"), grouped(json["agree"]["hit"].get<uint64_t>()));
  EXPECT_EQ(figureOf(page, "agrees, miss"), grouped(json["agree"]["miss"].get<uint64_t>()));
  const std::pair<const char*, const char*> verdicts[] = {
      {"hole", "hole"}, {"voxel right", "voxelRight"}, {"voxel wrong", "voxelWrong"}, {"too far", "far"}, {"too near", "near"}};
  for (const auto& [title, key] : verdicts) EXPECT_EQ(figureOf(page, title), grouped(json["verdicts"][key].get<uint64_t>())) << key;
  const std::pair<const char*, const char*> causes[] = {
      {"refused", "refused"}, {"stepped over", "steppedOver"}, {"gate", "gate"}, {"filled early", "filledEarly"}};
  const size_t proofs = page.find("Proofs:");
  ASSERT_NE(proofs, std::string::npos);
  for (const auto& [title, key] : causes) {
    if (json["causes"][key] == 0) continue;
    EXPECT_EQ(figureOf(page.substr(page.find("Causes:")), title), grouped(json["causes"][key].get<uint64_t>())) << key;
    EXPECT_EQ(figureOf(page.substr(proofs), title), grouped(json["confirmed"][key][2].get<uint64_t>())) << key;
  }
  const std::string costs = page.substr(page.find("The ten cells"));
  const Json& cell = json["worstCells"][0];
  EXPECT_EQ(figureOf(costs, "cell \\(" + cell["cell"][0].dump() + ", " + cell["cell"][1].dump() + ", " + cell["cell"][2].dump() + "\\)"),
            grouped(cell["rays"].get<uint64_t>()));
  for (const char* view : {"view-rays", "view-rays-slice"})
    EXPECT_NE(page.find("id=\"" + std::string(view) + "\""), std::string::npos) << view;
}

TEST_F(JudgedFrames, APageShowsUpdatesOfALaterFrameAndTheOrderOfArrivalWhereItMatters) {
  ASSERT_EQ(run({"report", "moving-crowd", "--size", "32x18", "--cells", "12", "--frame", "1", "--frame-step", "0.5", "--insertion",
                 "first-come", "-o", "report.html"})
                .exitCode,
            0);
  const std::string page = fileText(folder_ / "report.html");
  for (const char* view : {"update", "update-slice", "stability"})
    EXPECT_NE(page.find("id=\"view-" + std::string(view) + "\""), std::string::npos) << view;
  ASSERT_EQ(run({"report", "moving-crowd", "--size", "32x18", "--cells", "12", "-o", "first.html"}).exitCode, 0);
  const std::string first = fileText(folder_ / "first.html");
  for (const char* view : {"update", "stability"})
    EXPECT_EQ(first.find("id=\"view-" + std::string(view) + "\""), std::string::npos) << view;
}

TEST_F(JudgedFrames, TheOwnSettingOfAForeignGridIsTheShapeThatWasCaptured) {
  const Json json = results({"tune", foreign(), "--cells-axis", "8", "--capacity-axis", "4", "--overlap-axis", "plane", "--traversal-axis",
                             "dda", "--gate-axis", "1.75", "--runs", "1"});
  EXPECT_EQ(json["own"]["cellEdge"], 0.5);
  EXPECT_EQ(json["own"]["capacity"], 4);
  EXPECT_EQ(json["own"]["bytes"], 10 * 8 * 10 * 6 * 4) << "two reserved texels";
  EXPECT_NE(ended_.out.find("built by write_foreign.py"), std::string::npos) << ended_.out;
}

}  // namespace
}  // namespace gridscope
