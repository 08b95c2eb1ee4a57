// The command `explain`: its counts add up, causes are confirmed, and it tells one pixel in sentences.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program.h"

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
  Ended ended_;
};

TEST_F(Explain, CountsOfVerdictsAndCausesAddUpToTheRays) {
  for (const char* traversal : {"segment", "dda"}) {
    const Json json = explain({"saturated-cell", "--size", "96x54", "--traversal", traversal, "--verify"});
    ASSERT_TRUE(json.is_object());
    EXPECT_EQ(sumOf(json["agree"]) + sumOf(json["verdicts"]), json["rays"].get<uint64_t>());
    EXPECT_EQ(sumOf(json["causes"]), sumOf(json["verdicts"]));
    EXPECT_EQ(json["causes"].size(), 15u);
    EXPECT_EQ(json["wrong"].get<uint64_t>(), sumOf(json["verdicts"]) - json["verdicts"]["voxelRight"].get<uint64_t>());
    EXPECT_GT(sumOf(json["causes"]), 0u);
    EXPECT_EQ(json["causes"]["notInserted"], 0u);
    EXPECT_EQ(json["causes"]["numeric"], 0u);
    for (const auto& [cause, counts] : json["confirmed"].items()) {
      EXPECT_EQ(counts[2], json["causes"][cause]) << cause;
      EXPECT_EQ(counts[0].get<uint64_t>() + counts[1].get<uint64_t>(), counts[2].get<uint64_t>()) << cause;
    }
    EXPECT_TRUE(json.contains("control"));
  }
}

TEST_F(Explain, APixelIsToldInSentencesWithNames) {
  const Json json = explain({"saturated-cell", "--size", "96x54", "--verify", "--worst", "3"});
  ASSERT_FALSE(json["worstRays"].empty());
  const Json pixel = json["worstRays"][0]["pixel"];
  explain({"saturated-cell", "--size", "96x54", "--verify", "--pixel", pixel[0].dump() + "," + pixel[1].dump()});
  EXPECT_NE(ended_.out.find("Pixel (" + pixel[0].dump() + ", " + pixel[1].dump() + ")"), std::string::npos) << ended_.out;
  EXPECT_NE(ended_.out.find("Cause: "), std::string::npos);
  EXPECT_NE(ended_.out.find("Proof: "), std::string::npos);
}

TEST_F(Explain, APixelOutsideTheFrameIsRefusedWithItsSize) {
  const Ended ended = run({"explain", "saturated-cell", "--size", "32x18", "--pixel", "32,0"});
  EXPECT_EQ(ended.exitCode, 2);
  EXPECT_NE(ended.err.find("the frame has 32 x 18 pixels"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace gridscope
