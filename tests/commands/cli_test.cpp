// The program as a person starts it: options, files, messages and exit codes. Each test runs it as a child process, on small scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/npy.h"
#include "tests/commands/program.h"

namespace gridscope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

void writeFile(const fs::path& file, std::span<const std::byte> bytes) {
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

size_t lineCount(const std::string& text) { return size_t(std::count(text.begin(), text.end(), '\n')); }

// A test has a folder of its own, in which the program runs.
class Program : public ProgramTest {
 protected:
  // A render of a small scene that ends well, with its JSON.
  Json render(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"--json", "result.json"});
    const Ended outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    return outcome.exitCode == 0 ? Json::parse(fileText(folder_ / "result.json")) : Json();
  }

  // One line that holds `named`, and this exit code.
  void expectRefused(const std::vector<std::string>& arguments, const std::string& named, int exitCode = 2) {
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    const Ended outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, exitCode) << line << outcome.err;
    EXPECT_EQ(lineCount(outcome.err), 1u) << line << outcome.err;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << line << outcome.err;
    EXPECT_EQ(outcome.out, "") << line;
  }
};

// Width and height of a PNG file; zeros when it is none.
std::pair<uint32_t, uint32_t> pngSize(const fs::path& file) {
  const std::string bytes = fileText(file);
  if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return {0, 0};
  auto word = [&](size_t at) { return uint32_t(uint8_t(bytes[at + 2])) << 8 | uint8_t(bytes[at + 3]); };
  return {word(16), word(20)};
}

TEST_F(Program, SaysItsVersion) {
  const Ended outcome = run({"--version"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.out.rfind("gridscope ", 0), 0u);
}

TEST_F(Program, HelpNamesUnitsAndDefaults) {
  const Ended outcome = run({"render", "--help"});
  EXPECT_EQ(outcome.exitCode, 0);
  for (const char* text :
       {"--cells N=128", "--capacity N=32", "--ahead EDGES=0.75", "--size WxH=640x360", "--time SECONDS=0", "in cell edges", "--json FILE"})
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
}

TEST_F(Program, RefusesBadArgumentsInOneLineThatNamesThem) {
  expectRefused({"paint"}, "paint");
  expectRefused({"render", "--what"}, "--what");
  expectRefused({"render", "--cells"}, "--cells");
  expectRefused({"render", "--cells", "0"}, "--cells");
  expectRefused({"render", "--cells", "12x"}, "--cells");
  expectRefused({"render", "--capacity", "0"}, "--capacity");
  expectRefused({"render", "--capacity", "-1"}, "--capacity");
  expectRefused({"render", "--cells", "4", "--cell-edge", "1"}, "--cell-edge");
  expectRefused({"render", "--cell-edge", "nan"}, "--cell-edge");
  expectRefused({"render", "--size", "0x9"}, "--size");
  expectRefused({"render", "--size", "16x"}, "--size");
  expectRefused({"render", "--size", "100000x9"}, "--size");
  expectRefused({"render", "--view", "final,nothing"}, "nothing");
  expectRefused({"render", "--builder", "magic"}, "--builder");
  expectRefused({"render", "--gap-fill", "maybe"}, "--gap-fill");
  expectRefused({"render", "--ahead", "inf"}, "--ahead");
  expectRefused({"render", "--bounds", "0,0,0,1,1"}, "--bounds");
  expectRefused({"render", "--bounds", "1,0,0,0,1,1"}, "--bounds");
  expectRefused({"render", "--range", "2:1"}, "--range");
  expectRefused({"render", "--slice", "w:1"}, "--slice");
  expectRefused({"render", "--frames", "0"}, "--frames");
  expectRefused({"render", "--json", ""}, "--json");
  expectRefused({"render", "--moving", "1"}, "--moving");
  expectRefused({"render", "revisit", "--camera", "nobody"}, "--camera");
  expectRefused({"render", "revisit", "--camera", "0,0,0,1,1"}, "--camera");
  expectRefused({"bench", "--runs", "3"}, "--runs");
}

TEST_F(Program, RefusesBadFilesInOneLineThatNamesThem) {
  expectRefused({"render", "nothing.glb"}, "nothing.glb");
  expectRefused({"render", "nothing"}, "nothing");
  std::ofstream(folder_ / "text.gltf") << "no JSON at all";
  expectRefused({"render", "text.gltf"}, "text.gltf");
  expectRefused({"render", "revisit", "--rays", "nothing.npy"}, "nothing.npy");
}

TEST_F(Program, RefusesWhatNoDeviceCanDo) {
  expectRefused({"render", "revisit", "--device", "no such device"}, "--device");
  expectRefused({"render", "revisit", "--cells", "20000"}, "fits", 3);
  expectRefused({"render", "revisit", "--slice", "y:100000", "--size", "16x9"}, "--slice");
}

TEST_F(Program, ListsScenesWithTheHallFirst) {
  const Ended outcome = run({"scenes", "--json", "-"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const Json scenes = Json::parse(outcome.out).at("scenes");
  EXPECT_EQ(scenes.at(0).at("name"), "hall");
  EXPECT_GE(scenes.size(), 9u);
  EXPECT_NE(outcome.err.find("saturated-cell"), std::string::npos);
}

TEST_F(Program, RendersEveryViewAndReportsEveryNumber) {
  const Json json = render({"saturated-cell", "--size", "48x27", "--view", "all", "--out", "pictures"});
  for (const char* key : {"/device",
                          "/driver",
                          "/scene/triangles",
                          "/scene/degenerate",
                          "/scene/instances",
                          "/scene/staticInstances",
                          "/scene/dynamicInstances",
                          "/scene/materials",
                          "/grid/cells/2",
                          "/grid/capacity",
                          "/grid/stride",
                          "/grid/stretch",
                          "/grid/cellEdge",
                          "/grid/origin/2",
                          "/grid/bytes",
                          "/references/tried",
                          "/references/stored",
                          "/references/refused",
                          "/references/outside",
                          "/references/staticStored",
                          "/references/staticRefused",
                          "/references/dynamicStored",
                          "/references/dynamicRefused",
                          "/cells/occupied",
                          "/cells/saturated",
                          "/cells/maxDemand",
                          "/rays/count",
                          "/rays/triangleHits",
                          "/rays/voxelHits",
                          "/rays/misses",
                          "/visits/mean",
                          "/visits/p99",
                          "/visits/max",
                          "/tests/mean",
                          "/tests/p99",
                          "/tests/max",
                          "/timesMs/build",
                          "/timesMs/clear",
                          "/timesMs/add",
                          "/timesMs/gather",
                          "/timesMs/bounce",
                          "/timesMs/trace",
                          "/timesMs/views",
                          "/timesMs/start"})
    EXPECT_TRUE(json.contains(Json::json_pointer(key))) << key;
  EXPECT_FALSE(json.contains("frames"));

  // The lesson's settings, and numbers that must agree.
  EXPECT_EQ(json["grid"]["capacity"], 16);
  EXPECT_EQ(json["grid"]["cellEdge"], 0.25);
  EXPECT_EQ(json["cells"]["occupancyHistogram"].size(), 17u);
  EXPECT_EQ(json["references"]["stored"].get<uint64_t>() + json["references"]["refused"].get<uint64_t>(), json["references"]["tried"]);
  EXPECT_GT(json["cells"]["saturated"], 0);
  EXPECT_EQ(
      json["rays"]["triangleHits"].get<uint64_t>() + json["rays"]["voxelHits"].get<uint64_t>() + json["rays"]["misses"].get<uint64_t>(),
      json["rays"]["count"]);
  EXPECT_EQ(json["pictures"].size(), 14u);
  for (const std::string file : json["pictures"]) EXPECT_GT(pngSize(folder_ / file).first, 0u) << file;
}

TEST_F(Program, OptionsGoBeforeALessonsSettings) {
  const Json json = render({"saturated-cell", "--size", "16x9", "--capacity", "9", "--cells", "8"});
  EXPECT_EQ(json["grid"]["capacity"], 9);
  EXPECT_EQ(json["size"], Json({16, 9}));
  const std::vector<int> cells = json["grid"]["cells"];
  EXPECT_EQ(*std::max_element(cells.begin(), cells.end()), 10);  // and one more on each side
}

TEST_F(Program, WritesAPictureWithoutLegendAtTheFramesSize) {
  render({"revisit", "--size", "40x20", "--view", "depth", "--out", "plain", "--no-legend", "--range", "0:10"});
  EXPECT_EQ(pngSize(folder_ / "plain/depth.png"), std::make_pair(40u, 20u));
  render({"revisit", "--size", "40x20", "--view", "depth", "--out", "legend"});
  EXPECT_GT(pngSize(folder_ / "legend/depth.png").second, 20u);
}

TEST_F(Program, NumbersThePicturesOfSeveralFrames) {
  const Json json =
      render({"moving-crowd", "--size", "32x18", "--view", "final,visits", "--frames", "2", "--frame-step", "0.5", "--update", "moved"});
  for (const char* file : {"out/final.0000.png", "out/final.0001.png", "out/visits.0000.png", "out/visits.0001.png"})
    EXPECT_TRUE(fs::exists(folder_ / file)) << file;
  ASSERT_EQ(json["frames"].size(), 2u);
  EXPECT_EQ(json["frames"][1]["timeSeconds"], 0.5);
  for (const char* key : {"references", "cells", "rays", "timesMs", "update"}) EXPECT_TRUE(json["frames"][0].contains(key)) << key;
  for (const char* key : {"cellsRebuilt", "cellsTouched", "cells"}) EXPECT_TRUE(json["frames"][1]["update"].contains(key)) << key;
}

TEST_F(Program, KeepsStandardOutputForJsonAlone) {
  const Ended outcome = run({"render", "revisit", "--size", "16x9", "--json", "-"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out).at("scene").at("name"), "revisit");
  EXPECT_NE(outcome.err.find("references"), std::string::npos);
}

TEST_F(Program, EqualsTheCppPathWithBothTraversals) {
  for (const char* traversal : {"segment", "dda"}) {
    const Json json = render({"moving-crowd", "--size", "48x27", "--frames", "2", "--traversal", traversal, "--check-cpu"});
    EXPECT_EQ(json["checkCpu"]["equal"], true) << json["checkCpu"]["first"];
  }
}

TEST_F(Program, CountsTheSameOnTheCpuAsOnTheDevice) {
  const Json device = render({"saturated-cell", "--size", "48x27"});
  const Json cpu = render({"saturated-cell", "--size", "48x27", "--device", "cpu"});
  EXPECT_EQ(cpu["device"], "cpu");
  for (const char* key : {"scene", "grid", "references", "cells", "rays", "visits", "tests"}) EXPECT_EQ(device[key], cpu[key]) << key;
}

TEST_F(Program, AddsTeapotsOfWhichSomeMove) {
  const Json json = render({"revisit", "--size", "16x9", "--teapots", "3", "--moving", "1", "--frames", "2"});
  EXPECT_GE(json["scene"]["dynamicInstances"], 3);
  EXPECT_GT(json["references"]["dynamicStored"], 0);
}

TEST_F(Program, TracesRaysOfOnesOwn) {
  // Two rows of three rays, from above and from far outside; not of unit length.
  std::vector<float> rows;
  for (int i = 0; i < 6; ++i) rows.insert(rows.end(), {0.1f * float(i), 50.0f, 0.0f, 0.0f, -2.0f, 0.0f});
  writeFile(folder_ / "image.npy", formatNpy<float>(std::vector<uint64_t>{2, 3, 6}, rows));
  const Ended outcome = run({"render", "revisit", "--rays", "image.npy", "--view", "hit-kind,hit-distance", "--json", "result.json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("normalised"), std::string::npos);
  const Json json = Json::parse(fileText(folder_ / "result.json"));
  EXPECT_EQ(json["size"], Json({3, 2}));
  EXPECT_EQ(json["rays"]["count"], 6);

  // A list with launch normals, in double, that fills a frame; the same list without --size is one row.
  std::vector<double> list;
  for (int i = 0; i < 6; ++i) list.insert(list.end(), {0.1 * i, 5.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0});
  writeFile(folder_ / "list.npy", formatNpy<double>(std::vector<uint64_t>{6, 9}, list));
  EXPECT_EQ(render({"revisit", "--rays", "list.npy", "--size", "2x3"})["size"], Json({2, 3}));
  EXPECT_EQ(render({"revisit", "--rays", "list.npy"})["size"], Json({6, 1}));
  expectRefused({"render", "revisit", "--rays", "list.npy", "--size", "4x4"}, "--size");
}

TEST_F(Program, RefusesRaysThatAreNone) {
  auto refuse = [&](const std::vector<std::byte>& bytes, const std::string& named) {
    writeFile(folder_ / "bad.npy", bytes);
    expectRefused({"render", "revisit", "--rays", "bad.npy"}, named);
  };
  const std::vector<uint64_t> one = {1, 6};
  refuse(formatNpy<float>(one, std::vector<float>{0, 0, 0, 0, 0, 0}), "length 0");
  refuse(formatNpy<float>(one, std::vector<float>{0, 0, NAN, 0, 0, 1}), "not finite");
  refuse(formatNpy<float>(one, std::vector<float>{0, 0, 1e20f, 0, 0, 1}), "beyond");
  refuse(formatNpy<int32_t>(one, std::vector<int32_t>{0, 0, 0, 0, 0, 1}), "float32");
  refuse(formatNpy<float>(std::vector<uint64_t>{6}, std::vector<float>{0, 0, 0, 0, 0, 1}), "shape");
  refuse(formatNpy<float>(std::vector<uint64_t>{0, 6}, std::vector<float>{}), "no rays");
  std::vector<std::byte> cut = formatNpy<float>(one, std::vector<float>{0, 0, 0, 0, 0, 1});
  cut.resize(cut.size() - 3);
  refuse(cut, "3 bytes early");
}

TEST_F(Program, FindsADeviceThatPassesItsSelfTest) {
  const Ended outcome = run({"info", "--json", "-"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
  const Json devices = Json::parse(outcome.out).at("devices");
  ASSERT_GE(devices.size(), 1u);
  EXPECT_EQ(devices[0]["selfTest"]["passed"], true);
  for (const char* text : {"geometry stage", "image atomics", "64-bit floats", "largest grid", "descriptor indexing", "self-test"})
    EXPECT_NE(outcome.err.find(text), std::string::npos) << text;
}

TEST_F(Program, TimesEveryStageTwentyTimes) {
  const Ended outcome = run({"bench", "revisit", "--size", "16x9", "--json", "-"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  for (const char* stage : {"build", "update", "gather", "bounce", "trace"}) {
    const Json& times = json.at("timesMs").at(stage);
    EXPECT_EQ(times.at("runs"), 20) << stage;
    EXPECT_LE(times.at("min").get<double>(), times.at("median").get<double>()) << stage;
    EXPECT_LE(times.at("median").get<double>(), times.at("max").get<double>()) << stage;
  }
  EXPECT_GT(json.at("mraysPerSecond").get<double>(), 0.0);
  EXPECT_GT(json.at("grid").at("bytes").get<uint64_t>(), 0u);
}

TEST_F(Program, SaysWhenAFileCantBeWritten) {
  std::ofstream(folder_ / "file") << "in the way";
  expectRefused({"render", "revisit", "--size", "16x9", "--out", "file/pictures"}, "--out");
  const Ended outcome = run({"scenes", "--json", "file/scenes.json"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.err.find("--json"), std::string::npos);
}

}  // namespace
}  // namespace gridscope
