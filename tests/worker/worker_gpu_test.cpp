// The window's worker without a window: frames come as they are asked for, parts run again as little as they need, and what can't be had
// leaves what there was.
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "app/worker/worker.h"
#include "core/base/error.h"
#include "core/base/npy.h"
#include "core/capture/capture.h"

namespace gridscope {
namespace {

Options startOptions(const char* scene = "saturated-cell") {
  Options options;
  options.scene = scene;
  options.size = FrameSize{96, 54};
  options.validation = true;
  return options;
}

// Waits until everything that was asked for is made.
std::shared_ptr<const FrameSnapshot> settle(FrameWorker& worker) {
  for (int i = 0; i < 2400; ++i) {
    if (worker.idle() && worker.newest()) return worker.newest();
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  }
  ADD_FAILURE() << "the worker did not come to rest";
  return worker.newest();
}

FrameRequest firstRequest(const Options& options) {
  FrameRequest request;
  request.source = sourceOf(options);
  request.views = {"final", "occupancy"};
  return request;
}

struct Running {
  Options options;
  FrameWorker worker;
  FrameRequest request;

  explicit Running(const Options& start = startOptions()) : options(start), worker(start, [] {}), request(firstRequest(start)) {}
  std::shared_ptr<const FrameSnapshot> ask() {
    worker.ask(request);
    return settle(worker);
  }
  // Writes the frame into a file and waits for it.
  void capture(const std::string& file, const std::string& note = "") {
    worker.capture({.file = file, .note = note});
    settle(worker);
  }
  // Asks for nothing but a view of another source from now on.
  void open(const std::string& source, const std::string& view) {
    request = {};
    request.source.scene = source;
    request.views = {view};
  }
  // The first frame, whose settings the request then carries.
  std::shared_ptr<const FrameSnapshot> begin() {
    auto frame = ask();
    if (frame) request.settings = frame->request.settings;
    return frame;
  }
};

template <typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(FrameWorker, ACompleteFrameHoldsEveryProductAndTheViewsThatWereAskedFor) {
  Running running;
  const auto frame = running.begin();
  ASSERT_TRUE(frame && frame->scene && frame->hits && frame->rays && frame->gather && frame->counters && frame->grid &&
              frame->worldTriangles);
  EXPECT_FALSE(frame->stale);
  EXPECT_EQ(frame->hits->size(), 96u * 54u);
  EXPECT_EQ(frame->views.size(), 2u);
  EXPECT_EQ(frame->views.at("final")->elements.size(), 96u * 54u);
  EXPECT_EQ(frame->brokenInvariants, std::vector<std::string>{});
  EXPECT_EQ(frame->tried, frame->totals.stored() + frame->totals.refused());
  ASSERT_TRUE(frame->demand && frame->ledger);
  EXPECT_EQ(frame->demand->total(), frame->tried);
  EXPECT_EQ(running.worker.validationMessages(), 0u);
}

TEST(FrameWorker, TheFrameEqualsWhatOnePipelineMakesInOneGo) {
  Running running;
  const auto frame = running.begin();
  ASSERT_TRUE(frame && frame->hits);
  GpuContext gpu({.device = "", .validation = true});
  const LoadedSource loaded = loadSource(running.request.source, running.options);
  Pipeline pipeline(gpu, loaded.scene, *frame->request.settings);
  pipeline.build();
  pipeline.update(0.0f);
  pipeline.gather();
  pipeline.bounce(0);
  pipeline.trace(false);
  EXPECT_TRUE(sameBytes(pipeline.grid().words, frame->grid->words));
  EXPECT_TRUE(sameBytes(pipeline.hits(), *frame->hits));
}

TEST(FrameWorker, RecordedRaysEndAsTheFrameDid) {
  Running running(startOptions("hall"));
  auto frame = running.begin();
  for (uint32_t pixel = 3; pixel < 96 * 54; pixel += 397) {
    running.request.recordPixel = pixel;
    frame = running.ask();
    ASSERT_TRUE(frame && frame->record);
    EXPECT_EQ(frame->record->pixel, pixel);
    EXPECT_EQ(frame->record->surface, (*frame->gather)[pixel].reference);
    EXPECT_TRUE(frame->record->equalsFrame) << "pixel " << pixel;
  }
}

TEST(FrameWorker, AnotherCapacityBuildsAgainWithTheSameRays) {
  Running running;
  const auto before = running.begin();
  running.request.settings->grid.capacity *= 2;
  const auto after = running.ask();
  EXPECT_EQ(after->grid->parameters.capacity, 2 * before->grid->parameters.capacity);
  EXPECT_LT(after->totals.refused(), before->totals.refused());
  EXPECT_TRUE(after->rays == before->rays);
  EXPECT_GT(after->traceNumber, before->traceNumber);
}

TEST(FrameWorker, RaysOfOnesOwnTakeThePlaceOfTheBouncesAndSetTheFramesSize) {
  Running running;
  const auto before = running.begin();
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "gridscope_worker_rays.npy";
  const std::vector<float> rays{0,      0, 0, 1, 0, 0,  /**/ 0, 0, 0, 0, 1,  0, /**/ 0, 0, 0, 0,  0, 1,
                                /**/ 1, 1, 1, 0, 0, -1, /**/ 1, 1, 1, 0, -1, 0, /**/ 1, 1, 1, -1, 0, 0};
  const std::vector<std::byte> bytes = formatNpy<float>(std::vector<uint64_t>{2, 3, 6}, rays);
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  running.request.source.rays = file.string();
  running.request.settings->grid.capacity = 7;
  const auto after = running.ask();
  std::filesystem::remove(file);
  ASSERT_TRUE(after->hits) << after->fault;
  EXPECT_EQ(after->request.settings->width, 3u);
  EXPECT_EQ(after->request.settings->height, 2u);
  EXPECT_EQ(after->request.settings->grid.capacity, 7u);
  ASSERT_EQ(after->rays->size(), 6u);
  EXPECT_EQ((*after->rays)[1].direction, vec3(0, 1, 0));
  EXPECT_NE(after->rays->size(), before->rays->size());
}

TEST(FrameWorker, AnotherCameraKeepsTheGrid) {
  Running running;
  const auto before = running.begin();
  running.request.settings->camera.eye += vec3(0.05f, 0.02f, 0.0f);
  const auto after = running.ask();
  EXPECT_TRUE(after->grid == before->grid);
  EXPECT_TRUE(after->ledger == before->ledger);
  EXPECT_FALSE(sameBytes(*after->gather, *before->gather));
}

TEST(FrameWorker, ASettingThatDoesNotFitSaysWhyAndLeavesTheFrame) {
  Running running;
  const auto before = running.begin();
  const uint32_t capacity = running.request.settings->grid.capacity;
  running.request.settings->grid.capacity = 1000000;
  const auto refused = running.ask();
  EXPECT_FALSE(refused->fault.empty());
  EXPECT_EQ(refused->request.settings->grid.capacity, capacity);
  EXPECT_TRUE(refused->hits == before->hits);

  // And goes on from there.
  running.request.settings = refused->request.settings;
  running.request.settings->grid.capacity = capacity + 1;
  const auto after = running.ask();
  EXPECT_EQ(after->grid->parameters.capacity, int(capacity) + 1);
}

TEST(FrameWorker, ASceneThatCantBeLoadedLeavesTheOldOne) {
  Running running;
  const auto before = running.begin();
  running.request.source.scene = "nowhere.glb";
  const auto refused = running.ask();
  EXPECT_NE(refused->fault.find("nowhere.glb"), std::string::npos) << refused->fault;
  EXPECT_TRUE(refused->scene == before->scene);
  EXPECT_TRUE(refused->hits == before->hits);
  EXPECT_EQ(refused->request.source.scene, before->request.source.scene);
}

TEST(FrameWorker, RequestsThatFollowFastAreAnsweredByTheLast) {
  Running running;
  running.begin();
  for (int i = 1; i <= 20; ++i) {
    running.request.settings->bounce.seed = uint32_t(i);
    running.worker.ask(running.request);
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  const auto frame = settle(running.worker);
  EXPECT_EQ(frame->request.settings->bounce.seed, 20u);
  EXPECT_EQ(frame->parameters.bounce.seed, 20u);
  EXPECT_FALSE(frame->stale);
}

TEST(FrameWorker, AHiddenInstanceLosesItsTrianglesAndKeepsItsNumber) {
  Running running(startOptions("hall"));
  const auto before = running.begin();
  running.request.edits = {{.sceneInstance = 0, .kind = InstanceEdit::Kind::hide}};
  const auto after = running.ask();
  EXPECT_LT(after->scene->numbered.triangleCount, before->scene->numbered.triangleCount);
  for (const InstanceSource& source : after->scene->numbered.sources) EXPECT_NE(source.sceneInstance, 0u);
  EXPECT_EQ(after->scene->names.instances, before->scene->names.instances);
  EXPECT_EQ(after->parameters.grid.cellCount, before->parameters.grid.cellCount);
}

TEST(FrameWorker, ACaptureOfTheFrameShowsTheSameHits) {
  const std::string file = (std::filesystem::temp_directory_path() / "frame_worker_test.gridcap").string();
  Running running;
  const auto before = running.begin();
  running.capture(file, "as the window writes it");
  running.open(file, "final");
  const auto captured = running.ask();
  EXPECT_EQ(captured->scene->captureFrames, 1u) << captured->fault;
  EXPECT_EQ(captured->scene->note, "as the window writes it");
  EXPECT_TRUE(sameBytes(*captured->hits, *before->hits));
  EXPECT_TRUE(sameBytes(captured->grid->words, before->grid->words));
  std::filesystem::remove(file);
}

TEST(FrameWorker, ACapturesHitsAreShownUntilASettingOfTheTraceChanges) {
  const std::string file = (std::filesystem::temp_directory_path() / "frame_worker_hits_test.gridcap").string();
  Running running;
  const auto before = running.begin();
  running.capture(file);
  Capture capture = readCapture(file);
  for (size_t i = 0; i < capture.frames[0].hits.size(); i += 2) capture.frames[0].hits[i] = {kHitMiss, 0.0f, kNoReference, 0.0f, 0.0f};
  writeCapture(file, capture);
  running.open(file, "hit-kind");
  running.request.recordPixel = 96 * 20 + 40;
  const auto shown = running.begin();
  EXPECT_TRUE(sameBytes(*shown->hits, capture.frames[0].hits)) << shown->fault;
  ASSERT_EQ((*before->hits)[96 * 20 + 40].kind, kHitTriangle);
  ASSERT_TRUE(shown->record);
  EXPECT_FALSE(shown->record->equalsFrame) << "the trace hits a triangle, the capture says nothing";
  running.request.settings->trace.gate += 0.5f;
  EXPECT_EQ((*running.ask()->hits)[96 * 20 + 40].kind, kHitTriangle);
  std::filesystem::remove(file);
}

TEST(FrameWorker, TheTruthIsToldWhenItIsAskedFor) {
  Running running;
  EXPECT_FALSE(running.begin()->truths);
  running.request.truth = true;
  running.request.recordPixel = 96 * 20 + 40;
  const auto frame = running.ask();
  ASSERT_TRUE(frame->truths && frame->exact);
  EXPECT_EQ(frame->truths->size(), frame->hits->size());
  const TruthTotals& totals = frame->truthTotals;
  EXPECT_EQ(totals.rays, totals.agreeHit + totals.agreeMiss + totals.differ());
  ASSERT_TRUE(frame->record && frame->record->truth && frame->record->exact);
}

TEST(FrameWorker, ACaptureKeepsTheOrderOfItsReferencesAndTakesOtherGrids) {
  const std::string file = (std::filesystem::temp_directory_path() / "frame_worker_order_test.gridcap").string();
  Running running;
  running.begin();
  running.capture(file);
  running.open(file, "final");
  const auto captured = running.begin();
  running.request.settings->grid.numberBy = NumberBy::area;
  const auto refused = running.ask();
  EXPECT_NE(refused->fault.find("keep their order"), std::string::npos) << refused->fault;
  running.request.settings = refused->request.settings;
  running.request.settings->grid.capacity += 3;
  const auto after = running.ask();
  EXPECT_EQ(after->fault, "");
  EXPECT_EQ(after->grid->parameters.capacity, captured->grid->parameters.capacity + 3);
  running.request.edits = {{.sceneInstance = 0, .kind = InstanceEdit::Kind::hide}};
  EXPECT_NE(running.ask()->fault.find("of a capture"), std::string::npos);
  std::filesystem::remove(file);
}

TEST(FrameWorker, EditsOfInstancesThatAreGoneAreLeftOut) {
  Running running;
  running.request.source.teapots = 2;
  const auto two = running.begin();
  const uint32_t last = uint32_t(two->scene->names.instances.size()) - 1;
  running.request.edits = {{.sceneInstance = 0, .kind = InstanceEdit::Kind::hide},
                           {.sceneInstance = last, .kind = InstanceEdit::Kind::hide}};
  EXPECT_EQ(running.ask()->fault, "");
  running.request.source.teapots = 1;
  const auto one = running.ask();
  EXPECT_EQ(one->fault, "");
  ASSERT_EQ(one->request.edits.size(), 1u);
  EXPECT_EQ(one->request.edits[0].sceneInstance, 0u);
  EXPECT_FALSE(one->stale);
}

TEST(FrameWorker, PicturesComeWhileTheCameraMovesAllTheTime) {
  Options options = startOptions("hall");
  options.size = FrameSize{320, 180};
  Running running(options);
  const auto first = running.begin();
  auto picture = first->views.at("final");
  int pictures = 0;
  const auto began = std::chrono::steady_clock::now();
  for (int i = 1; std::chrono::steady_clock::now() - began < std::chrono::seconds(4); ++i) {
    running.request.settings->camera.eye.x += i % 200 < 100 ? 0.01f : -0.01f;
    running.worker.ask(running.request);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const auto now = running.worker.newest()->views.at("final");
    pictures += now != picture;
    picture = now;
  }
  EXPECT_GT(pictures, 4);
  settle(running.worker);
}

TEST(FrameWorker, ALayerBeyondTheGridIsItsLast) {
  Running running;
  running.begin();
  running.request.views = {"slice"};
  running.request.slice = {.axis = 2, .index = 100000};
  const auto frame = running.ask();
  ASSERT_TRUE(frame->views.contains("slice"));
  EXPECT_EQ(frame->request.slice.index, frame->parameters.grid.cellCount.z - 1);
  for (const LogLine& line : running.worker.takeLines()) EXPECT_NE(line.kind, LogLine::Kind::error) << line.text;
}

TEST(FrameWorker, TheLastUpdateIsShownWhenItIsAskedForAfterwards) {
  Options options = startOptions("hall");
  options.teapots = 1;
  Running running(options);
  running.begin();
  running.request.timeSeconds = 0.5;
  running.request.frame = 1;
  const auto before = running.ask();
  running.request.views = {"update"};
  const auto frame = running.ask();
  ASSERT_TRUE(frame->views.contains("update"));
  bool changed = false;
  for (const ViewElement& element : frame->views.at("update")->elements) changed |= element.kind != kElementNothing;
  EXPECT_TRUE(changed);
  EXPECT_TRUE(frame->grid == before->grid);

  // As it is when the view is shown while time goes on.
  Running shown(options);
  shown.request.views = {"update"};
  shown.begin();
  shown.request.timeSeconds = 0.5;
  shown.request.frame = 1;
  EXPECT_TRUE(sameBytes(shown.ask()->views.at("update")->elements, frame->views.at("update")->elements));
}

TEST(FrameWorker, ACancelThatComesTooLateDoesNotEndTheNextLoad) {
  Running running;
  running.begin();
  running.worker.cancel();
  running.request = {};
  running.request.source.scene = "hall";
  running.request.views = {"final"};
  const auto frame = running.ask();
  EXPECT_EQ(frame->fault, "");
  EXPECT_EQ(frame->scene->name, "hall");
}

TEST(FrameWorker, AProofThatWasCancelledDoesNotComeWithTheNextTruth) {
  Running running;
  running.begin();
  running.request.proveAll = 1;  // as it stands when the truth is declined while it is being proved
  running.request.truth = false;
  running.ask();
  running.request.truth = true;
  EXPECT_FALSE(running.ask()->proofs);
  running.request.proveAll = 2;
  EXPECT_TRUE(running.ask()->proofs);
}

TEST(FrameWorker, TheOccupiedCellsComeWithTheGrid) {
  Running running;
  const auto frame = running.begin();
  ASSERT_TRUE(frame->occupied);
  EXPECT_EQ(frame->occupied->size(), size_t(frame->totals.statistics.occupied));
}

}  // namespace
}  // namespace gridscope
