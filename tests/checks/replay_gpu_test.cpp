// Replays of captures made here: equal where nothing changed, and otherwise a person is told where to look.
#include "core/checks/replay.h"

#include <algorithm>
#include <cstring>

#include "core/capture/diff.h"
#include "core/pipeline/frame_capture.h"
#include "core/scene/built_in_scenes.h"
#include "core/scene/teapot.h"
#include "shaders/shared/grid/layout.h"
#include "tests/gpu_fixture.h"

namespace gridscope {
namespace {

struct Recording {
  const char* scene = "moving-crowd";
  FrameSettings settings{};
  uint32_t frames = 1;
  uint32_t teapots = 0;
  CaptureProducts products{};
};

FrameSettings smallSettings(uint32_t cells) {
  FrameSettings settings;
  settings.grid.cells = cells;
  settings.width = 48;
  settings.height = 27;
  settings.textureSize = 16;
  return settings;
}

Capture record(GpuContext& gpu, const Recording& recording) {
  Scene scene = makeBuiltInScene(recording.scene);
  FrameSettings settings = recording.settings;
  settings.camera = defaultCamera(scene);
  if (recording.teapots > 0) addTeapots(scene, recording.teapots, recording.teapots);
  Pipeline pipeline(gpu, scene, settings);
  pipeline.build();
  Capture capture;
  for (uint32_t frame = 0; frame < recording.frames; ++frame) {
    pipeline.update(0.2f * float(frame));
    pipeline.gather();
    pipeline.bounce(frame);
    pipeline.trace(true);
    if (frame == 0) capture = startCapture(pipeline, namesOf(scene), sceneBounds(scene));
    capture.frames.push_back(takeFrame(pipeline, recording.products, 0.2f * float(frame)));
  }
  capture.writer = std::string(kWriterName) + "test";
  return capture;
}

// From every stage, on the device and in C++.
void expectEqualEverywhere(GpuContext& gpu, const Capture& capture) {
  for (ReplayFrom from : {ReplayFrom::build, ReplayFrom::update, ReplayFrom::trace})
    for (GpuContext* device : {&gpu, static_cast<GpuContext*>(nullptr)}) {
      if (!whyNotFrom(capture, from).empty()) continue;
      const ReplayResult result = replay(capture, {.from = from}, device);
      EXPECT_EQ(result.verdict, Verdict::equal) << result.device << ", from " << static_cast<int>(from) << ": " << result.reason;
      for (const ReplayedProduct& product : result.products) EXPECT_EQ(product.first, "") << product.name;
    }
}

const ReplayedProduct& product(const ReplayResult& result, const std::string& name) {
  for (const ReplayedProduct& one : result.products)
    if (one.name == name) return one;
  static const ReplayedProduct kNone;
  ADD_FAILURE() << "no product " << name;
  return kNone;
}

TEST_F(GpuTest, SequencesReplayEqualWithBothUpdatesThroughAFile) {
  for (UpdateMode mode : {UpdateMode::all, UpdateMode::moved}) {
    Recording recording{.settings = smallSettings(24), .frames = 4};
    recording.settings.grid.update = mode;
    const std::vector<std::byte> file = formatCapture(record(gpu(), recording));
    const Capture capture = readCaptureMemory(file, "sequence");
    EXPECT_EQ(formatCapture(capture), file);
    expectEqualEverywhere(gpu(), capture);
  }
}

TEST_F(GpuTest, SaturatedSequencesReplayEqualWithBothTraversals) {
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    Recording recording{.settings = smallSettings(24), .frames = 3};
    recording.settings.grid.capacity = 3;
    recording.settings.grid.update = UpdateMode::moved;
    recording.settings.trace.traversal = traversal;
    expectEqualEverywhere(gpu(), record(gpu(), recording));
  }
}

TEST_F(GpuTest, TheHallWithItsTeapotsGivesOneResultInManyRuns) {
  Recording recording{.scene = "hall", .settings = smallSettings(48), .frames = 2, .teapots = 3};
  const Capture capture = record(gpu(), recording);
  expectEqualEverywhere(gpu(), capture);
  const ReplayResult result = replay(capture, {.repeat = 5}, &gpu());
  EXPECT_EQ(result.verdict, Verdict::equal);
  for (const ReplayedProduct& one : result.products) EXPECT_EQ(one.distinct, 1u) << one.name;
}

// The race orders first-come grids: they are compared as sets, and rays are traced in the captured one.
TEST_F(GpuTest, FirstComeGridsAreComparedAsSets) {
  for (uint32_t capacity : {3u, 32u}) {
    Recording recording{.scene = "saturated-cell", .settings = smallSettings(24), .frames = 2};
    recording.settings.grid.insertion = kInsertionFirstCome;
    recording.settings.grid.capacity = capacity;
    expectEqualEverywhere(gpu(), record(gpu(), recording));
  }
}

TEST_F(GpuTest, ExactHitsAreFoundAgainFromEveryStageAndAChangedOneIsNamed) {
  Recording recording{.settings = smallSettings(24), .frames = 2, .products = {.exact = true}};
  recording.settings.grid.capacity = 3;
  Capture capture = record(gpu(), recording);
  ASSERT_EQ(capture.frames[1].exact.size(), 48u * 27u);
  EXPECT_GT(std::ranges::count_if(capture.frames[1].exact, [](const ExactHit& hit) { return hit.reference != kNoReference; }), 100);
  expectEqualEverywhere(gpu(), readCaptureMemory(formatCapture(capture), "exact"));
  capture.frames[1].exact[50] = {1.5f, 0u};
  const ReplayResult result = replay(capture, {}, nullptr);
  EXPECT_EQ(result.verdict, Verdict::different);
  EXPECT_EQ(product(result, "exact").different, 1u);
  EXPECT_NE(product(result, "exact").first.find("frame 1, pixel (2, 1): captured"), std::string::npos) << product(result, "exact").first;
}

// The first texel of a slot that holds a reference to an instance with more triangles.
size_t changeableTexel(const Capture& capture) {
  const std::vector<uint32_t>& texels = capture.frames.back().grid;
  const ivec3 count = gridTexelCount(capture.grid);
  for (size_t i = 0; i < texels.size(); ++i) {
    const int along = capture.grid.stretchAxis == 0   ? int(i % count.x)
                      : capture.grid.stretchAxis == 1 ? int(i / count.x % count.y)
                                                      : int(i / (size_t(count.x) * count.y));
    if (along % capture.grid.stride >= capture.grid.capacity || texels[i] == kNoReference) continue;
    if (referenceTriangle(texels[i]) + 1 < capture.scene.instances[referenceInstance(texels[i])].triangleCount) return i;
  }
  ADD_FAILURE() << "no such reference";
  return 0;
}

TEST_F(GpuTest, AChangedReferenceIsNamedWithCellSlotAndBothTriangles) {
  Capture capture = record(gpu(), {.settings = smallSettings(24), .frames = 2});
  const size_t texel = changeableTexel(capture);
  const uint32_t before = capture.frames.back().grid[texel];
  ++capture.frames.back().grid[texel];
  const Comparison how{"captured", "replayed", capture.scene, &capture.names};
  const std::string expected = "frame 1, " + wordText(capture.grid, texel) + ": captured " + referenceText(how, before + 1) +
                               ", replayed " + referenceText(how, before);
  for (GpuContext* device : {&gpu(), static_cast<GpuContext*>(nullptr)}) {
    const ReplayResult result = replay(capture, {}, device);
    EXPECT_EQ(result.verdict, Verdict::different);
    EXPECT_EQ(product(result, "grid").different, 1u);
    EXPECT_EQ(product(result, "grid").first, expected);
    EXPECT_EQ(product(result, "hits").different, 0u);
    ASSERT_TRUE(result.different);
    EXPECT_EQ(result.different->frame, 1u);
  }
  EXPECT_NE(expected.find("triangle"), std::string::npos);
}

TEST_F(GpuTest, AChangedHitIsNamedWithItsPixelAndBothHits) {
  Capture capture = record(gpu(), {.settings = smallSettings(24)});
  std::vector<Hit>& hits = capture.frames[0].hits;
  const auto hit = std::find_if(hits.begin(), hits.end(), [](const Hit& one) { return one.kind == kHitTriangle; });
  ASSERT_NE(hit, hits.end());
  hit->t = uintBitsToFloat(floatBitsToUint(hit->t) + 1u);  // one unit in the last place
  const ReplayResult result = replay(capture, {.from = ReplayFrom::trace}, &gpu());
  EXPECT_EQ(result.verdict, Verdict::different);
  EXPECT_EQ(product(result, "hits").different, 1u);
  const Comparison how{"captured", "replayed", capture.scene, &capture.names};
  EXPECT_EQ(product(result, "hits")
                .first.rfind(pixelText(size_t(hit - hits.begin()), 48) + ": captured " + hitText(how, *hit) + "; replayed ", 0),
            0u)
      << product(result, "hits").first;
}

TEST_F(GpuTest, WithoutProductsThereIsNothingToCompareUnlessRepeated) {
  Capture capture = record(gpu(), {.settings = smallSettings(24)});
  capture.writer = "another engine";
  capture.frames[0].hits.clear();
  capture.frames[0].counters.clear();
  EXPECT_EQ(replay(capture, {}, &gpu()).verdict, Verdict::unusable);
  EXPECT_EQ(replay(capture, {.repeat = 2}, &gpu()).verdict, Verdict::equal);
  EXPECT_EQ(replay(capture, {.from = ReplayFrom::update}, &gpu()).verdict, Verdict::unusable);
  capture.frames[0].grid.clear();
  EXPECT_NE(replay(capture, {.from = ReplayFrom::trace, .repeat = 2}, &gpu()).reason.find("no grid"), std::string::npos);
}

TEST_F(GpuTest, AGridThatTheDeviceCantHoldIsUnsupported) {
  Capture capture = record(gpu(), {.settings = smallSettings(24)});
  capture.grid.cellCount[capture.grid.stretchAxis] = int(gpu().report().maxImageSide);
  const ReplayResult result = replay(capture, {}, &gpu());
  EXPECT_EQ(result.verdict, Verdict::unsupported);
  EXPECT_NE(result.reason, "");
}

TEST_F(GpuTest, ADiffSaysInWhichWayCellsAndHitsDiffer) {
  const Capture a = record(gpu(), {.settings = smallSettings(24)});
  EXPECT_TRUE(diffCaptures(a, a).equal());

  Capture b = a;
  ++b.frames[0].grid[changeableTexel(a)];
  for (Hit& hit : b.frames[0].hits)
    if (hit.kind == kHitTriangle) {
      hit = {.kind = kHitMiss, .t = 0.0f, .reference = kNoReference, .u = 0.0f, .v = 0.0f};
      break;
    }
  b.settings.trace.ahead = 0.5f;
  const CaptureDifferences differences = diffCaptures(a, b);
  EXPECT_FALSE(differences.equal());
  EXPECT_EQ(differences.frames[0].cells.otherReferences, 1u);
  EXPECT_EQ(differences.frames[0].cells.onlyA + differences.frames[0].cells.onlyB, 0u);
  EXPECT_EQ(differences.frames[0].hits.otherKind, 1u);
  ASSERT_EQ(differences.settings.size(), 1u);
  EXPECT_NE(differences.settings[0].name.find("ahead"), std::string::npos);
  EXPECT_NE(differences.frames[0].cells.first.find("slot"), std::string::npos);
}

}  // namespace
}  // namespace gridscope
