// The committed captures: each is replayed from every stage it can be, on the device and in C++, and each view of it is compared with its
// golden picture. GRIDSCOPE_UPDATE_GOLDEN=1 writes those pictures anew.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/image_decode.h"
#include "core/checks/replay.h"
#include "core/pipeline/frame_capture.h"
#include "tests/gpu_fixture.h"
#include "views/picture.h"

namespace gridscope {
namespace {

namespace fs = std::filesystem;

const fs::path kCaptures = GRIDSCOPE_CAPTURES;
const fs::path kGolden = kCaptures.parent_path() / "tests" / "golden" / "captures";

constexpr uint64_t kMostFileBytes = 300 << 10;
constexpr uint64_t kMostBytes = 3 << 20;

std::vector<fs::path> committedCaptures() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(kCaptures))
    if (entry.path().extension() == ".gridcap") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::string textOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

class CommittedCapture : public GpuTest, public testing::WithParamInterface<fs::path> {};

void expectEqual(const Capture& capture, ReplayFrom from, GpuContext* gpu) {
  const ReplayResult result = replay(capture, {.from = from}, gpu);
  EXPECT_EQ(result.verdict, Verdict::equal) << result.device << " " << result.reason;
  for (const ReplayedProduct& product : result.products) EXPECT_EQ(product.first, "") << result.device << ": " << product.name;
}

TEST_P(CommittedCapture, ReplaysEqualFromEveryStage) {
  const Capture capture = readCapture(GetParam());
  uint32_t stages = 0;
  for (ReplayFrom from : {ReplayFrom::build, ReplayFrom::update, ReplayFrom::trace}) {
    if (!whyNotFrom(capture, from).empty() || (from != ReplayFrom::trace && !builtHere(capture))) continue;
    SCOPED_TRACE(static_cast<int>(from));
    expectEqual(capture, from, &gpu());
    expectEqual(capture, from, nullptr);
    ++stages;
  }
  EXPECT_EQ(stages, !builtHere(capture) ? 1u : capture.frames.size() > 1 ? 3u : 2u);
}

TEST_P(CommittedCapture, TheRasterBuilderMakesTheSameGrid) {
  Capture capture = readCapture(GetParam());
  if (!builtHere(capture) || !gpu().report().geometryStage) GTEST_SKIP() << "not built here, or no geometry stage";
  capture.settings.grid.builder = Builder::raster;
  expectEqual(capture, ReplayFrom::build, &gpu());
}

// The pipeline with the products of the capture's last frame.
void useLastFrame(Pipeline& pipeline, const Capture& capture) {
  const CaptureFrame& frame = capture.frames.back();
  pipeline.useGrid(frame.grid);
  pipeline.gather();
  if (!frame.gather.empty()) pipeline.useGather(frame.gather);
  pipeline.useRays(frame.rays);
  pipeline.trace(true);
  pipeline.useHits(frame.hits);
  pipeline.useCounters(frame.counters);
}

Picture viewPicture(Pipeline& pipeline, const View& view) {
  const Pipeline::ViewImage image = pipeline.view(view.name);
  return makeViewPicture(view, image.elements, image.width, image.height,
                         {.legend = false,
                          .capacity = uint32_t(pipeline.parameters().grid.capacity),
                          .frameWidth = pipeline.settings().width,
                          .frameHeight = pipeline.settings().height})
      .picture;
}

// 2 of 255 a channel for 99.9 % of the pixels, 16 at most.
void expectLooksLike(const Picture& picture, const fs::path& golden) {
  ASSERT_TRUE(fs::exists(golden)) << golden << " is missing; GRIDSCOPE_UPDATE_GOLDEN=1 writes it";
  const std::string file = textOf(golden);
  const Image image = decodeImage({reinterpret_cast<const unsigned char*>(file.data()), file.size()}, golden.string());
  ASSERT_EQ(image.width, picture.width) << golden;
  ASSERT_EQ(image.height, picture.height) << golden;
  size_t beyond = 0;
  int worst = 0;
  for (size_t i = 0; i < picture.rgba.size(); i += 4) {
    int most = 0;
    for (size_t channel = 0; channel < 4; ++channel)
      most = std::max(most, std::abs(int(picture.rgba[i + channel]) - int(image.rgba[i + channel])));
    beyond += most > 2 ? 1 : 0;
    worst = std::max(worst, most);
  }
  EXPECT_LE(worst, 16) << golden;
  EXPECT_LE(beyond * 1000, picture.rgba.size() / 4) << golden;
}

TEST_P(CommittedCapture, EveryViewLooksLikeItsGoldenPicture) {
  const Capture capture = readCapture(GetParam());
  Pipeline pipeline(gpu(), pipelineInputs(capture, capture.frames.size() - 1));
  useLastFrame(pipeline, capture);
  const bool update = std::getenv("GRIDSCOPE_UPDATE_GOLDEN") != nullptr;
  if (update) fs::create_directories(kGolden);
  for (const View& view : allViews()) {
    if (view.need != ViewNeed::nothing) continue;
    const fs::path golden = kGolden / (GetParam().stem().string() + "." + std::string(view.name) + ".png");
    const Picture picture = viewPicture(pipeline, view);
    if (update) writePng(golden.string(), picture);
    expectLooksLike(picture, golden);
  }
}

TEST_P(CommittedCapture, IsSmallAndHasALineInTheReadme) {
  EXPECT_LT(fs::file_size(GetParam()), kMostFileBytes);
  EXPECT_NE(textOf(kCaptures / "README.md").find("| `" + GetParam().stem().string() + "` |"), std::string::npos);
}

std::string captureName(const testing::TestParamInfo<fs::path>& info) { return info.param.stem().string(); }
INSTANTIATE_TEST_SUITE_P(Captures, CommittedCapture, testing::ValuesIn(committedCaptures()), captureName);

TEST(CommittedCaptures, AreNineOrMoreAndSmallTogether) {
  uint64_t bytes = 0;
  for (const fs::path& file : committedCaptures()) bytes += fs::file_size(file);
  EXPECT_LT(bytes, kMostBytes);
  EXPECT_GE(committedCaptures().size(), 9u);
}

TEST(CommittedCaptures, BothUpdatesMakeTheSameGrids) {
  const Capture all = readCapture(kCaptures / "moving_all.gridcap"), moved = readCapture(kCaptures / "moving_moved.gridcap");
  ASSERT_EQ(all.frames.size(), 8u);
  ASSERT_EQ(moved.frames.size(), 8u);
  EXPECT_NE(all.settings.grid.update, moved.settings.grid.update);
  for (size_t i = 0; i < 8; ++i) EXPECT_EQ(all.frames[i].grid, moved.frames[i].grid) << "frame " << i;
}

}  // namespace
}  // namespace gridscope
