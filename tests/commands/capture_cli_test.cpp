// Captures on the command line: verdicts, exit codes, the CI of CI.md, and captures where scenes are expected.
#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "core/capture/capture.h"
#include "core/capture/compare.h"
#include "tests/commands/program.h"

namespace gridscope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kCaptures = GRIDSCOPE_CAPTURES;

class CaptureProgram : public ProgramTest {
 protected:
  std::string committed(const char* name) { return (kCaptures / (std::string(name) + ".gridcap")).string(); }

  // A valid copy of the saturated cell in which one reference is another; `place` says where and both references.
  std::string changedCopy(const std::string& name, std::string* place = nullptr) {
    Capture capture = readCapture(committed("saturated_cell"));
    std::vector<uint32_t>& texels = capture.frames[0].grid;
    const size_t texel =
        size_t(std::find_if(texels.begin(), texels.end(), [](uint32_t word) { return word > 10 && word < 100; }) - texels.begin());
    const Comparison how{"captured", "replayed", capture.scene, &capture.names};
    const std::string before = referenceText(how, texels[texel]);
    texels[texel] ^= 1;
    if (place) *place = wordText(capture.grid, texel) + ": captured " + referenceText(how, texels[texel]) + ", replayed " + before;
    writeCapture(folder_ / name, capture);
    return name;
  }

  Json replayJson(std::vector<std::string> arguments, int exitCode) {
    arguments.insert(arguments.begin(), "replay");
    arguments.insert(arguments.end(), {"--json", "result.json"});
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.exitCode, exitCode) << ended.out << ended.err;
    return Json::parse(fileText(folder_ / "result.json"))["captures"];
  }
};

TEST_F(CaptureProgram, CapturesAndReplaysASequenceFromEveryStage) {
  ASSERT_EQ(run({"capture", "moving-crowd", "-o", "a.gridcap", "--size", "32x18", "--cells", "16", "--sequence", "3", "--update", "moved",
                 "--note", "three", "--validation"})
                .exitCode,
            0);
  for (const char* from : {"build", "update", "trace"})
    for (const char* device : {"0", "cpu"}) {
      const Json result = replayJson({"a.gridcap", "--from", from, "--device", device, "--validation"}, 0).at(0);
      EXPECT_EQ(result["verdict"], "equal");
      EXPECT_EQ(result["products"].contains("grid"), std::string(from) != "trace");
      EXPECT_TRUE(result["products"]["hits"]["equal"]);
      EXPECT_EQ(result["products"]["hits"]["different"], 0);
      EXPECT_EQ(result["products"]["hits"]["first"], "");
      EXPECT_GT(result["products"]["hits"]["total"], 0);
    }
  const Ended inspected = run({"inspect", "a.gridcap"});
  for (const char* text : {"three", "3 of 32 x 18 pixels", "grid.npy", "(3, "})
    EXPECT_NE(inspected.out.find(text), std::string::npos) << text << inspected.out;
}

TEST_F(CaptureProgram, NamesAChangedReferenceWithCellSlotAndBothReferences) {
  std::string place;
  changedCopy("changed.gridcap", &place);
  for (const char* device : {"0", "cpu"}) {
    const Json result = replayJson({"changed.gridcap", "--device", device, "--out", "pictures"}, 1).at(0);
    EXPECT_EQ(result["verdict"], "different");
    EXPECT_EQ(result["products"]["grid"]["first"], place);
    EXPECT_EQ(result["products"]["grid"]["different"], 1);
    EXPECT_TRUE(fs::exists(folder_ / "pictures/changed.difference.png"));
    EXPECT_TRUE(fs::exists(folder_ / "pictures/changed.ab.png"));
  }
  const Ended diff = run({"diff", committed("saturated_cell"), "changed.gridcap", "--out", "pictures"});
  EXPECT_EQ(diff.exitCode, 1);
  EXPECT_NE(diff.out.find("1 with other references"), std::string::npos) << diff.out;
  EXPECT_NE(diff.out.find(place.substr(0, place.find(':'))), std::string::npos) << diff.out;
  EXPECT_EQ(run({"diff", "changed.gridcap", "changed.gridcap"}).exitCode, 0);
}

TEST_F(CaptureProgram, RefusesAFlippedByteWithOneLine) {
  std::string bytes = fileText(committed("revisit"));
  bytes[bytes.find("grid.npy") + 5000] ^= 0x10;
  std::ofstream(folder_ / "flipped.gridcap", std::ios::binary) << bytes;
  const Ended ended = run({"replay", "flipped.gridcap"});
  EXPECT_EQ(ended.exitCode, 2) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_NE(ended.err.find("flipped.gridcap"), std::string::npos) << ended.err;
  EXPECT_EQ(run({"replay", "missing.gridcap"}).exitCode, 2);
  EXPECT_EQ(run({"replay", (folder_ / "pictures").string()}).exitCode, 2);
}

// As CI.md has it: a JUnit file, pictures, and shards that replay each file once.
TEST_F(CaptureProgram, GivesCiWhatCiMdSays) {
  fs::create_directories(folder_ / "kept");
  for (const char* name : {"revisit", "stepped_corner", "foreign"})
    fs::copy(committed(name), folder_ / "kept" / (std::string(name) + ".gridcap"));
  changedCopy("kept/changed.gridcap");
  EXPECT_EQ(run({"replay", "kept", "--junit", "replay.xml", "--out", "replay"}).exitCode, 1);
  const std::string junit = fileText(folder_ / "replay.xml");
  for (const char* text : {"<testsuite name=\"gridscope replay\" tests=\"4\" failures=\"1\" errors=\"0\" skipped=\"0\"",
                           "name=\"kept/changed.gridcap\"", "<failure message=\"grid: 1 of "})
    EXPECT_NE(junit.find(text), std::string::npos) << text << junit;
  EXPECT_TRUE(fs::exists(folder_ / "replay/kept_changed.difference.png"));

  std::multiset<std::string> seen;
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const bool holdsChanged = std::string(shard) == "1/3";
    for (const Json& result : replayJson({"kept", "--shard", shard, "--device", "cpu"}, holdsChanged ? 1 : 0)) seen.insert(result["file"]);
  }
  EXPECT_EQ(seen, (std::multiset<std::string>{"kept/changed.gridcap", "kept/foreign.gridcap", "kept/revisit.gridcap",
                                              "kept/stepped_corner.gridcap"}));
  EXPECT_EQ(run({"replay", "kept", "--shard", "4/3"}).exitCode, 2);
}

TEST_F(CaptureProgram, GivesTheSameVerdictsInSeveralProcesses) {
  const std::vector<std::string> files = {committed("revisit"), committed("foreign"), committed("empty_walk")};
  std::vector<std::string> many = files;
  many.insert(many.end(), {"--jobs", "2"});
  Json one = replayJson(files, 0), two = replayJson(many, 0);
  for (Json* results : {&one, &two})
    for (Json& result : *results) result.erase("seconds");
  EXPECT_EQ(one, two);
}

// Every CI has GNU parallel or can have it; a Slurm array takes the same line.
TEST_F(CaptureProgram, RunsUnderGnuParallel) {
  if (run({"--version"}, "parallel").out.find("GNU parallel") == std::string::npos) GTEST_SKIP() << "no GNU parallel here";
  const Ended ended = run({GRIDSCOPE_PROGRAM, "replay", kCaptures.string(), "--device", "cpu", "--shard", "{}/3", "--junit",
                           "replay.{}.xml", ":::", "1", "2", "3"},
                          "parallel");
  EXPECT_EQ(ended.exitCode, 0) << ended.err;
  for (const char* file : {"replay.1.xml", "replay.2.xml", "replay.3.xml"}) EXPECT_TRUE(fs::exists(folder_ / file)) << file;
}

// The Python example writes a capture; with hits added it replays, and a changed reference is found in the right cell and slot.
TEST_F(CaptureProgram, TakesAForeignGridFromPython) {
  for (const char* reserved : {"0", "1", "2"}) {
    if (run({(kCaptures / "write_foreign.py").string(), "foreign.gridcap", "--reserved", reserved}, "/usr/bin/python3").exitCode != 0)
      GTEST_SKIP() << "no Python with numpy here";
    EXPECT_EQ(replayJson({"foreign.gridcap"}, 2).at(0)["verdict"], "unusable");
    EXPECT_EQ(replayJson({"foreign.gridcap", "--repeat", "3"}, 0).at(0)["verdict"], "equal");
    ASSERT_EQ(run({"capture", "foreign.gridcap", "-o", "hits.gridcap"}).exitCode, 0);
    EXPECT_EQ(replayJson({"hits.gridcap"}, 0).at(0)["products"]["hits"]["total"], 768);
    EXPECT_EQ(replayJson({"hits.gridcap", "--device", "cpu"}, 0).at(0)["verdict"], "equal");
    EXPECT_EQ(run({"render", "hits.gridcap", "--view", "all", "--out", "views"}).exitCode, 0);

    Capture capture = readCapture(folder_ / "foreign.gridcap");
    std::vector<uint32_t>& texels = capture.frames[0].grid;
    const size_t texel = size_t(std::ranges::find(texels, 3u) - texels.begin());
    texels[texel] = 4;
    writeCapture(folder_ / "changed.gridcap", capture);
    const Ended diff = run({"diff", "foreign.gridcap", "changed.gridcap"});
    EXPECT_EQ(diff.exitCode, 1);
    EXPECT_NE(diff.out.find(wordText(capture.grid, texel) + ": A 0x00000003"), std::string::npos) << diff.out;
  }
}

TEST_F(CaptureProgram, TakesACaptureAsAScene) {
  const Ended rendered =
      run({"render", committed("saturated_cell"), "--view", "all", "--out", "views", "--check-cpu", "--json", "render.json"});
  EXPECT_EQ(rendered.exitCode, 0) << rendered.err;
  EXPECT_EQ(Json::parse(fileText(folder_ / "render.json"))["checkCpu"]["equal"], true);
  EXPECT_EQ(run({"bench", committed("revisit"), "--runs", "20"}).exitCode, 0);
  EXPECT_EQ(run({"render", committed("moving_all"), "--frames", "8", "--builder", "compute"}).exitCode, 0);
  const std::vector<std::vector<std::string>> fixed = {{"--capacity", "8"}, {"--size", "16x9"},    {"--seed", "3"},
                                                       {"--teapots", "2"},  {"--update", "moved"}, {"--frames", "9"}};
  for (const std::vector<std::string>& option : fixed) {
    std::vector<std::string> arguments = {"render", committed("moving_all")};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.exitCode, 2) << option[0];
    EXPECT_NE(ended.err.find(option[0]), std::string::npos) << ended.err;
  }
}

TEST_F(CaptureProgram, FollowsARayInWords) {
  const Ended ended = run({"ray", committed("saturated_cell"), "--pixel", "45,30", "--json", "ray.json"});
  ASSERT_EQ(ended.exitCode, 0) << ended.err;
  for (const char* text : {"pixel (45, 30)", "slot 0", "floor, triangle", "ends: "})
    EXPECT_NE(ended.out.find(text), std::string::npos) << text << ended.out;
  EXPECT_GT(Json::parse(fileText(folder_ / "ray.json"))["steps"].size(), 1u);
  EXPECT_EQ(run({"ray", "revisit", "--size", "16x9", "--cells", "16", "--pixel", "8,6", "--device", "cpu"}).exitCode, 0);
  EXPECT_EQ(run({"ray", committed("saturated_cell"), "--pixel", "96,0"}).exitCode, 2);
}

TEST_F(CaptureProgram, RerecordsWhatChangedAndSaysWhat) {
  fs::create_directories(folder_ / "kept");
  std::string place;
  changedCopy("kept/changed.gridcap", &place);
  fs::copy(committed("revisit"), folder_ / "kept/revisit.gridcap");
  const Ended ended = run({"update-captures", "kept", "--validation"});
  EXPECT_EQ(ended.exitCode, 0) << ended.err;
  EXPECT_NE(ended.out.find("changed   kept/changed.gridcap"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find(place.substr(0, place.find(':'))), std::string::npos) << ended.out;
  EXPECT_EQ(run({"replay", "kept", "--device", "cpu"}).exitCode, 0);

  // What is up to date stays as it is, to the byte.
  const std::string before = fileText(folder_ / "kept/revisit.gridcap");
  const Ended again = run({"update-captures", "kept"});
  for (const char* line : {"unchanged kept/changed.gridcap", "unchanged kept/revisit.gridcap"})
    EXPECT_NE(again.out.find(line), std::string::npos) << again.out;
  EXPECT_TRUE(fileText(folder_ / "kept/revisit.gridcap") == before);
}

TEST_F(CaptureProgram, RefusesWhatCantBe) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> refused = {
      {{"capture", "revisit"}, "-o"},
      {{"capture", "revisit", "-o", "x.zip"}, "x.zip"},
      {{"capture", "revisit", "-o", "x.gridcap", "--products", "grid,paint"}, "paint"},
      {{"replay", committed("revisit"), "--from", "update"}, "sequence"},
      {{"replay", committed("revisit"), "--shard", "0/2"}, "--shard"},
      {{"replay", committed("revisit"), "--from", "bounce"}, "--from"},
      {{"replay", committed("foreign"), "--from", "build"}, "reserved"}};
  for (const auto& [arguments, named] : refused) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.exitCode, 2) << named;
    EXPECT_NE(ended.err.find(named), std::string::npos) << ended.err;
  }
}

}  // namespace
}  // namespace gridscope
