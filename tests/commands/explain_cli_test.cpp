// The command `explain`, on scenes and on captures: its counts add up, causes are confirmed, and it tells one pixel in sentences.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <nlohmann/json.hpp>

#include "core/capture/capture.h"
#include "tests/commands/program.h"

namespace gridscope {
namespace {

using Json = nlohmann::json;

class Explain : public ProgramTest {
 protected:
  Json explain(std::vector<std::string> options) {
    options.insert(options.begin(), "explain");
    options.insert(options.end(), {"--json", "explain.json"});
    ended_ = run(options);
    EXPECT_EQ(ended_.exitCode, 0) << ended_.err;
    return Json::parse(fileText(folder_ / "explain.json"), nullptr, false);
  }
  static uint64_t sumOf(const Json& counts) {
    uint64_t sum = 0;
    for (const auto& [key, count] : counts.items()) sum += count.get<uint64_t>();
    return sum;
  }
  static void expectSums(const Json& json) {
    EXPECT_EQ(sumOf(json["agree"]) + sumOf(json["verdicts"]), json["rays"].get<uint64_t>());
    EXPECT_EQ(sumOf(json["causes"]), sumOf(json["verdicts"]));
    EXPECT_EQ(json["causes"].size(), 15u);
    EXPECT_EQ(json["wrong"].get<uint64_t>(), sumOf(json["verdicts"]) - json["verdicts"]["voxelRight"].get<uint64_t>());
    for (const auto& [cause, counts] : json["confirmed"].items()) EXPECT_EQ(counts[2], json["causes"][cause]) << cause;
  }
  // A capture of a lesson whose hits were changed afterwards.
  std::string changedCapture(const char* scene, const std::function<void(Hit&)>& change) {
    EXPECT_EQ(run({"capture", scene, "--size", "96x54", "-o", "own.gridcap"}).exitCode, 0);
    Capture capture = readCapture(folder_ / "own.gridcap");
    for (Hit& hit : capture.frames[0].hits) change(hit);
    writeCapture(folder_ / "changed.gridcap", capture);
    return "changed.gridcap";
  }
  Ended ended_;
};

TEST_F(Explain, CountsOfVerdictsAndCausesAddUpToTheRays) {
  for (const char* traversal : {"segment", "dda"}) {
    const Json json = explain({"saturated-cell", "--size", "96x54", "--traversal", traversal, "--verify"});
    ASSERT_TRUE(json.is_object());
    expectSums(json);
    EXPECT_GT(sumOf(json["causes"]), 0u);
    EXPECT_EQ(json["causes"]["notInserted"], 0u);
    EXPECT_EQ(json["causes"]["numeric"], 0u);
    for (const auto& [cause, counts] : json["confirmed"].items()) {
      EXPECT_EQ(counts[0].get<uint64_t>() + counts[1].get<uint64_t>(), counts[2].get<uint64_t>()) << cause;
    }
    EXPECT_LE(json["control"]["confirmed"].get<uint64_t>(), json["controlChain"]["confirmed"].get<uint64_t>());
    EXPECT_EQ(json["control"]["total"], json["controlChain"]["total"]);
    for (const Json& mesh : json["worstMeshes"]) {
      EXPECT_LE(mesh["lostRays"].get<uint64_t>(), mesh["rays"].get<uint64_t>());
      EXPECT_EQ(mesh["where"].empty(), mesh["lost"] == 0);
    }
  }
}

TEST_F(Explain, CountsAddUpForEveryLessonAndEveryCauseIsConfirmed) {
  for (const char* scene : {"hall", "alpha-leaf", "stepped-corner", "revisit", "moving-crowd", "diagonal", "mirrored-instances"}) {
    const Json json = explain({scene, "--size", "64x36", "--capacity", "6", "--verify"});
    ASSERT_TRUE(json.is_object()) << scene;
    expectSums(json);
    EXPECT_GT(json["rays"].get<uint64_t>(), 0u) << scene;
    EXPECT_EQ(json["confirmedShare"], 1.0) << scene;
  }
}

TEST_F(Explain, ACaptureIsExplainedAsTheFrameThatItHolds) {
  const Json scene = explain({"saturated-cell", "--size", "96x54", "--verify"});
  ASSERT_EQ(run({"capture", "saturated-cell", "--size", "96x54", "-o", "own.gridcap"}).exitCode, 0);
  const Json capture = explain({"own.gridcap", "--verify"});
  expectSums(capture);
  EXPECT_EQ(capture["foreignHits"], 0u);
  for (const char* key : {"rays", "verdicts", "causes", "confirmed", "control", "worstCells"}) EXPECT_EQ(capture[key], scene[key]) << key;
}

TEST_F(Explain, HitsOfACaptureThatAreAHairOffHaveTheirOwnCauses) {
  const Json own = explain({"alpha-leaf", "--size", "96x54", "--verify"});
  const Json off = explain({changedCapture("alpha-leaf", [](Hit& hit) { hit.t = std::nextafter(hit.t, 1e30f); }), "--verify"});
  expectSums(off);
  EXPECT_GT(off["foreignHits"].get<uint64_t>(), 0u);
  EXPECT_EQ(off["causes"], own["causes"]);
  EXPECT_EQ(off["confirmedShare"], 1.0);
}

TEST_F(Explain, HitsOfACaptureThatNoRuleMakesAreCountedAndNotConfirmed) {
  const Json json = explain({changedCapture("stepped-corner",
                                            [](Hit& hit) {
                                              hit = {kHitNoRay, 0.0f, kNoReference, 0.0f, 0.0f};
                                            }),
                             "--verify"});
  expectSums(json);
  EXPECT_GT(json["rays"].get<uint64_t>(), 0u);
  EXPECT_GT(json["causes"]["numeric"].get<uint64_t>(), 0u);
  EXPECT_EQ(json["confirmed"]["numeric"], Json({0, 0, json["causes"]["numeric"]}));
}

TEST_F(Explain, APixelIsToldInSentencesWithNames) {
  const Json json = explain({"saturated-cell", "--size", "96x54", "--verify", "--worst", "3"});
  ASSERT_FALSE(json["worstRays"].empty());
  const Json pixel = json["worstRays"][0]["pixel"];
  explain({"saturated-cell", "--size", "96x54", "--verify", "--pixel", pixel[0].dump() + "," + pixel[1].dump()});
  EXPECT_NE(ended_.out.find("Pixel (" + pixel[0].dump() + ", " + pixel[1].dump() + ")"), std::string::npos) << ended_.out;
  EXPECT_NE(ended_.out.find("Cause: "), std::string::npos);
  EXPECT_NE(ended_.out.find("Proof: "), std::string::npos);
  const Json told = Json::parse(fileText(folder_ / "explain.json"))["pixel"];
  EXPECT_EQ(told["x"], pixel[0]);
  EXPECT_TRUE(told["proof"]["confirmed"].get<bool>());
  ASSERT_GT(told["proof"]["links"].size(), 0u);
  EXPECT_EQ(told["proof"]["links"][0]["cause"], told["cause"]);
  for (const Json& slot : told["slots"]) EXPECT_TRUE(slot["mesh"].is_string() && slot["triangle"].is_number()) << slot;
}

TEST_F(Explain, APixelOutsideTheFrameIsRefusedWithItsSize) {
  const Ended ended = run({"explain", "saturated-cell", "--size", "32x18", "--pixel", "32,0"});
  EXPECT_EQ(ended.exitCode, 2);
  EXPECT_NE(ended.err.find("the frame has 32 x 18 pixels"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace gridscope
