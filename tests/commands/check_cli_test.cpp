// The command check: what it says of sound scenes and captures, of broken and of foreign ones, and its budgets' exit codes.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/capture/capture.h"
#include "tests/commands/program.h"

namespace gridscope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class CheckProgram : public ProgramTest {
 protected:
  std::string committed(const char* name) { return (fs::path(GRIDSCOPE_CAPTURES) / (std::string(name) + ".gridcap")).string(); }

  Json check(std::vector<std::string> arguments, int exitCode) {
    arguments.insert(arguments.begin(), "check");
    arguments.insert(arguments.end(), {"--json", "result.json"});
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.exitCode, exitCode) << ended.out << ended.err;
    text_ = ended.out;
    return fs::exists(folder_ / "result.json") ? Json::parse(fileText(folder_ / "result.json")) : Json();
  }

  std::string text_;  // standard output of the last check
};

TEST_F(CheckProgram, SaysOkAfterEachStageOfASoundScene) {
  const Json json = check({"moving-crowd", "--size", "32x18", "--frames", "2", "--frame-step", "0.3"}, 0);
  std::vector<std::string> stages;
  for (const Json& stage : json.at("stages")) {
    stages.push_back(stage.at("stage"));
    for (const auto& [key, invariant] : stage.at("invariants").items()) EXPECT_TRUE(invariant.at("holds")) << key << invariant;
  }
  EXPECT_EQ(stages, (std::vector<std::string>{"build", "update", "trace", "update", "trace"}));
  EXPECT_EQ(json["references"]["tried"], json["references"]["stored"].get<uint64_t>() + json["references"]["refused"].get<uint64_t>());
  for (const char* key : {"noBlankBefore", "staticFirst", "noDuplicate", "inRange", "refusedWhenFull", "sum", "nothingStale", "placed"})
    EXPECT_TRUE(json["stages"][0]["invariants"].contains(key)) << key;
  EXPECT_NE(text_.find("everything that applies holds"), std::string::npos) << text_;
}

TEST_F(CheckProgram, NamesWhatIsBrokenInACapture) {
  Capture capture = readCapture(committed("saturated_cell"));
  std::vector<uint32_t>& texels = capture.frames[0].grid;
  *std::ranges::find_if(texels, [](uint32_t word) { return word > 10 && word < 100; }) ^= 1;
  writeCapture(folder_ / "changed.gridcap", capture);
  const Json json = check({"changed.gridcap"}, 1);
  EXPECT_GT(json["broken"], 0);
  EXPECT_EQ(json["stages"][0]["stage"], "captured");
  EXPECT_FALSE(json["stages"][0]["invariants"]["placed"]["holds"]);
  EXPECT_NE(text_.find("FAULT"), std::string::npos) << text_;
  EXPECT_EQ(check({committed("saturated_cell")}, 0)["broken"], 0);
}

TEST_F(CheckProgram, SaysWhatDoesNotApplyToAForeignGrid) {
  const Json json = check({committed("foreign")}, 0);
  const Json& invariants = json["stages"][0]["invariants"];
  EXPECT_TRUE(invariants["inRange"]["holds"]);
  for (const char* key : {"placed", "nothingStale", "staticFirst"})
    EXPECT_NE(invariants[key]["whyNot"].get<std::string>().find("built by"), std::string::npos) << key;
  EXPECT_EQ(run({"check", committed("foreign"), "--stability", "2"}).exitCode, 2);
}

TEST_F(CheckProgram, BudgetsDecideTheExitCodeAndAreNamedInALine) {
  EXPECT_EQ(check({"saturated-cell", "--size", "32x18", "--fail-if", "saturated>100000", "--fail-if", "refused>100%"}, 0)["broken"], 0);
  check({"saturated-cell", "--size", "32x18", "--fail-if", "saturated>=1", "--fail-if", "refused>0.1%"}, 1);
  EXPECT_NE(text_.find("saturated>=1: cells.saturated is "), std::string::npos) << text_;
  EXPECT_NE(text_.find("references tried ("), std::string::npos) << text_;
  const Json json = check({"saturated-cell", "--size", "32x18", "--fail-if", "wrong>0%"}, 1);
  EXPECT_NE(text_.find("wrong>0%: wrong is "), std::string::npos) << text_;
  uint64_t sum = json["agree"]["hit"].get<uint64_t>() + json["agree"]["miss"].get<uint64_t>();
  for (const auto& [key, count] : json["verdicts"].items()) sum += count.get<uint64_t>();
  EXPECT_EQ(json["rays"], sum);
}

TEST_F(CheckProgram, RefusesBudgetsThatItCannotJudge) {
  const Ended unknown = run({"check", "saturated-cell", "--size", "16x9", "--fail-if", "saturatd>1"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_NE(unknown.err.find("cells.saturated"), std::string::npos) << unknown.err;
  EXPECT_EQ(run({"check", "saturated-cell", "--fail-if", "wrong"}).exitCode, 2);
}

TEST_F(CheckProgram, SortedBuildsAreStableInEveryRepetition) {
  const Json json = check({"saturated-cell", "--size", "32x18", "--stability", "3"}, 0);
  EXPECT_EQ(json["stability"]["builds"], 3);
  EXPECT_EQ(json["stability"]["setDiffers"].get<int>() + json["stability"]["orderDiffers"].get<int>() +
                json["stability"]["raysChange"].get<int>(),
            0);
  check({"saturated-cell", "--size", "32x18", "--stability", "3", "--fail-if", "stability.raysChange>0%", "--fail-if", "setDiffers>0%"}, 0);
}

TEST_F(CheckProgram, RenderWritesTheViewsOfTheTruthAndOfOtherFindings) {
  const Ended ended = run({"render", "saturated-cell", "--size", "48x27", "--view", "truth,stability,rays,rays-slice,update,update-slice",
                           "--out", "pictures"});
  EXPECT_EQ(ended.exitCode, 0) << ended.err;
  for (const char* name : {"verdict", "cause", "error", "lost", "stability", "rays", "rays-slice", "update", "update-slice"})
    EXPECT_TRUE(fs::exists(folder_ / "pictures" / (std::string(name) + ".png"))) << name;
}

TEST_F(CheckProgram, ACaptureWithExactHitsReplaysEqual) {
  ASSERT_EQ(run({"capture", "saturated-cell", "--size", "32x18", "--products", "grid,rays,hits,exact", "-o", "exact.gridcap"}).exitCode, 0);
  EXPECT_EQ(readCapture(folder_ / "exact.gridcap").frames[0].exact.size(), 32u * 18u);
  const Ended replayed = run({"replay", "exact.gridcap", "--device", "cpu", "--json", "replay.json"});
  EXPECT_EQ(replayed.exitCode, 0) << replayed.out;
  EXPECT_NE(fileText(folder_ / "replay.json").find("\"exact\""), std::string::npos);
}

}  // namespace
}  // namespace gridscope
