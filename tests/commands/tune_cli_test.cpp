// The commands tune and report as a person runs them, on small scenes.
#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/commands/program.h"
#include "tests/views/markup_check.h"

namespace gridscope {
namespace {

using Json = nlohmann::json;

class TuneProgram : public ProgramTest {
 protected:
  // A sweep of few settings over a scene of few triangles.
  std::vector<std::string> sweep(std::vector<std::string> more) {
    std::vector<std::string> arguments = {"tune",
                                          "saturated-cell",
                                          "--size",
                                          "32x18",
                                          "--cells-axis",
                                          "8,16",
                                          "--capacity-axis",
                                          "4,16",
                                          "--overlap-axis",
                                          "plane",
                                          "--back-axis",
                                          "1",
                                          "--ahead-axis",
                                          "0.75,1",
                                          "--gate-axis",
                                          "1.75",
                                          "--runs",
                                          "1",
                                          "--json",
                                          "tune.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

class ReportProgram : public ProgramTest {};

TEST_F(TuneProgram, TriesEverySettingAndWritesTheResults) {
  const Ended outcome = run(sweep({"--csv", "tune.csv", "--plot", "tune.svg"}));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("recommended"), std::string::npos) << outcome.out;
  const Json json = Json::parse(fileText(folder_ / "tune.json"));

  // Cells x capacity x numbering, the own setting, and on the best grid: segment with two reaches and dda, less the own trace.
  EXPECT_GE(json["settings"].size(), 10u);
  for (const Json& row : json["settings"]) {
    ASSERT_TRUE(row.contains("verdicts")) << row.dump();
    uint64_t sum = row["agree"].get<uint64_t>();
    for (const auto& [key, count] : row["verdicts"].items()) sum += count.get<uint64_t>();
    EXPECT_EQ(sum, row["rays"].get<uint64_t>()) << row.dump();
    const Json& verdicts = row["verdicts"];
    EXPECT_EQ(row["wrong"].get<uint64_t>(), verdicts["hole"].get<uint64_t>() + verdicts["voxelWrong"].get<uint64_t>() +
                                                verdicts["far"].get<uint64_t>() + verdicts["near"].get<uint64_t>());
  }
  EXPECT_LE(json["recommended"]["wrong"].get<uint64_t>(), json["own"]["wrong"].get<uint64_t>());
  EXPECT_EQ(markupFault(fileText(folder_ / "tune.svg")), "");
  EXPECT_EQ(fileText(folder_ / "tune.csv").rfind("cells,", 0), 0u);
}

TEST_F(TuneProgram, ARecommendedSettingRendersAsTheSweepSaid) {
  ASSERT_EQ(run(sweep({})).exitCode, 0);
  const Json json = Json::parse(fileText(folder_ / "tune.json"));
  std::vector<std::string> arguments = {"explain", "saturated-cell", "--size", "32x18", "--json", "explain.json"};
  std::istringstream flags(json["recommended"]["flags"].get<std::string>());
  for (std::string flag; flags >> flag;) arguments.push_back(flag);
  const Ended outcome = run(arguments);
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const Json explained = Json::parse(fileText(folder_ / "explain.json"));
  EXPECT_EQ(explained["wrong"], json["recommended"]["wrong"]);
  EXPECT_EQ(explained["verdicts"], json["recommended"]["verdicts"]);
}

TEST_F(TuneProgram, WhatCannotBeHeldIsNamedAndTheRestIsTried) {
  const Ended outcome = run(
      {"tune",           "saturated-cell", "--size",           "32x18", "--cells-axis",     "8,100000", "--capacity-axis", "4",
       "--overlap-axis", "plane",          "--number-by-axis", "file",  "--traversal-axis", "segment",  "--back-axis",     "1",
       "--ahead-axis",   "0.75",           "--gate-axis",      "1.75",  "--runs",           "1",        "--json",          "tune.json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const Json json = Json::parse(fileText(folder_ / "tune.json"));
  size_t refused = 0;
  for (const Json& row : json["settings"]) refused += row.contains("refusal");
  EXPECT_EQ(refused, 1u);
  EXPECT_NE(outcome.out.find("could not be tried"), std::string::npos) << outcome.out;
}

TEST_F(TuneProgram, RefusesBadAxesAndPlots) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--cells-axis", "0"},
                                                    {"--capacity-axis", "4,x"},
                                                    {"--overlap-axis", "round"},
                                                    {"--plot", "plot.gif"},
                                                    {"--gate-axis", "-1"}}) {
    std::vector<std::string> all = {"tune", "saturated-cell"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ended outcome = run(all);
    EXPECT_EQ(outcome.exitCode, 2) << arguments[0];
    EXPECT_NE(outcome.err.find(arguments[0]), std::string::npos) << outcome.err;
  }
}

TEST_F(TuneProgram, AnInterruptKeepsWhatIsDone) {
  // The program is interrupted while its long sweep runs; `timeout` sends the signal and hands the exit code through.
  const Ended outcome = run({"--preserve-status", "--signal=INT", "6", GRIDSCOPE_PROGRAM, "tune", "saturated-cell", "--size", "64x36",
                             "--runs", "1000", "--json", "tune.json"},
                            "timeout");
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("stopped early"), std::string::npos) << outcome.out;
  const Json json = Json::parse(fileText(folder_ / "tune.json"));
  EXPECT_TRUE(json["sweep"]["stopped"].get<bool>());
  EXPECT_GE(json["settings"].size(), 1u);
}

TEST_F(ReportProgram, IsOneWellFormedPageWithEverySection) {
  const Ended outcome = run({"report", "moving-crowd", "--size", "64x36", "-o", "report.html"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const std::string page = fileText(folder_ / "report.html");
  EXPECT_EQ(markupFault(page), "");
  for (const char* id : {"pictures", "verdicts", "costs", "plots", "statistics", "settings", "device", "view-final", "view-verdict",
                         "view-cause", "view-error", "view-lost"})
    EXPECT_NE(page.find("id=\"" + std::string(id) + "\""), std::string::npos) << id;
  for (const char* text :
       {"The ten meshes that cost the most rays", "The ten cells", "The worst rays", "voxel wrong", "data:image/png;base64,iVBOR",
        "--capacity", "gridscope report moving-crowd --size 64x36 -o report.html", "References that cells were asked to take"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST_F(ReportProgram, NeedsNoNetwork) {
  ASSERT_EQ(run({"report", "moving-crowd", "--size", "32x18", "-o", "report.html"}).exitCode, 0);
  const std::string page = fileText(folder_ / "report.html");
  for (const char* text : {"http://", "https://", "@import", "url(", "<link", "src=\"//"})
    EXPECT_EQ(page.find(text), std::string::npos) << text;
}

// A triangle in a file whose names are markup.
constexpr const char* kHostileScene = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"name":"</td><script>alert(1)</script>"}],
"meshes":[{"name":"<img src=x onerror=alert(2)> & \"quoted\" {{js}}","primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAAAAAAAAgD8AAAAA"}]})";

TEST_F(ReportProgram, NamesOfAHostileSceneStayText) {
  const std::string file = "<script>alert(3)<.gltf";
  std::ofstream(folder_ / file) << kHostileScene;
  const Ended outcome = run({"report", file, "--size", "32x18", "--cells", "4", "--camera", "0,0,3,0,0,0", "-o", "report.html"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const std::string page = fileText(folder_ / "report.html");
  EXPECT_EQ(markupFault(page), "");
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("<img src=x"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(3)&lt;"), std::string::npos);
}

TEST_F(ReportProgram, AnUnwritableFolderIsOneLine) {
  const Ended outcome = run({"report", "moving-crowd", "--size", "16x9", "-o", "missing/report.html"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.err.find("missing/report.html"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace gridscope
