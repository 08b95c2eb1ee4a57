// What is made of a frame once its picture stands: products for the panels, the recorded ray, invariants, demand and ledger, the truth,
// captures (maker.h).
#include <algorithm>
#include <cstring>

#include "app/worker/maker.h"
#include "app/worker/shader_compiler.h"
#include "app/worker/work.h"
#include "core/base/error.h"
#include "core/base/image_file.h"
#include "core/base/version.h"
#include "core/gpu/shader_code.h"
#include "core/pipeline/frame_capture.h"
#include "core/trace/invariants_frame.h"
#include "views/picture.h"

namespace gridscope {

template <typename T>
static std::shared_ptr<const std::vector<T>> shared(std::vector<T> values) {
  return std::make_shared<const std::vector<T>>(std::move(values));
}

bool FrameMaker::readProducts() {
  if (!productsRead_) {
    if (interrupted()) return false;
    if (!current_.gather) current_.gather = shared(pipeline_->gatherPixels());
    if (!current_.rays) current_.rays = shared(pipeline_->rays());
    current_.hits = shared(pipeline_->hits());
    current_.counters = shared(pipeline_->counters());
    current_.traceNumber++;
    current_.brokenInvariants.reset();
    productsRead_ = true;
    publish(false);
  }
  if (!gridRead_) {
    if (interrupted()) return false;
    current_.grid = std::make_shared<const Grid>(pipeline_->grid());
    current_.occupied = shared(occupiedCells(*current_.grid));
    current_.worldTriangles = shared(pipeline_->worldTriangles());
    gridRead_ = true;
    publish(false);
  }
  return true;
}

bool FrameMaker::recordRay() {
  if (interrupted()) return false;
  const std::optional<uint32_t> pixel = made_.recordPixel;
  if (!pixel || *pixel >= pipeline_->rayCount()) {
    if (current_.record) current_.record.reset(), publish(false);
    return true;
  }
  if (current_.record && current_.record->pixel == *pixel) return true;
  RecordedRay recorded{
      .pixel = *pixel, .ray = (*current_.rays)[*pixel], .record = pipeline_->record(*pixel), .frameHit = (*current_.hits)[*pixel]};
  if (current_.gather && *pixel < current_.gather->size()) recorded.surface = (*current_.gather)[*pixel].reference;
  recorded.equalsFrame = std::memcmp(&recorded.record.hit, &recorded.frameHit, sizeof(Hit)) == 0;
  current_.record = std::make_shared<const RecordedRay>(std::move(recorded));
  publish(false);
  return true;
}

// Slower than the picture: only when nothing else is asked for.
bool FrameMaker::measureGrid() {
  if (!gridMeasured_) {
    if (interrupted()) return false;
    current_.demand = std::make_shared<const Demand>(current_.grid->parameters, pipeline_->numbered(), *current_.worldTriangles);
    publish(false);
    if (interrupted()) return false;
    current_.ledger = std::make_shared<const Ledger>(makeLedger(TruthInput{traceInput(), *current_.demand}, {}));
    publish(false);
    if (interrupted()) return false;
    gridFaults_ = gridFaults();
    gridMeasured_ = true;
    current_.brokenInvariants.reset();
  }
  if (current_.brokenInvariants) return true;
  current_.brokenInvariants = gridFaults_;
  for (std::string& fault : faultsOf(testFrameHits(pipeline_->numbered(), pipeline_->parameters().trace, *current_.rays, *current_.hits)))
    current_.brokenInvariants->push_back(std::move(fault));
  publish(false);
  return !interrupted();
}

std::vector<std::string> FrameMaker::gridFaults() const {
  GridFacts facts{.grid = *current_.grid,
                  .scene = pipeline_->numbered(),
                  .demand = &*current_.demand,
                  .tried = capturedGridHolds() ? current_.demand->total() : current_.tried};
  if (capturedGridHolds() && !builtHere(*loaded_->capture))
    facts.builtBy = loaded_->capture->writer.empty() ? "another program" : loaded_->capture->writer;
  return faultsOf(testGrid(facts));
}

TraceInput FrameMaker::traceInput() const {
  return {*current_.grid, pipeline_->numbered(), *current_.worldTriangles, pipeline_->parameters().trace};
}

// Seconds of work in C++, given up when another request comes.
bool FrameMaker::tellTruth() {
  if (!made_.truth && !made_.proveRecorded) return true;
  const TruthInput input{traceInput(), *current_.demand};
  if (!current_.truths && !findTruths(input)) return false;
  if (tellRecorded(input)) publish(false);
  if (made_.proveAll == proved_ || made_.proveAll == 0) return true;
  const Work work(listener_, LongWork::Kind::truth, "Proving every cause");
  ProofTotals totals = proveFrame(input, {*current_.rays, *current_.hits, *current_.exact, *current_.truths},
                                  [&](float share) { return work.tell(share), !interrupted(); });
  if (interrupted()) return false;
  proved_ = made_.proveAll;
  current_.proofs = std::make_shared<const ProofTotals>(std::move(totals));
  publish(false);
  return true;
}

bool FrameMaker::findTruths(const TruthInput& input) {
  Work work(listener_, LongWork::Kind::truth, "Finding the exact hits");
  work.tell(0.0f);
  const ExactReference exact(input.trace);
  std::vector<Hit> exactHits;
  constexpr size_t kRaysPerPiece = 16384;
  const std::span<const Ray> rays(*current_.rays);
  for (size_t first = 0; first < rays.size(); first += kRaysPerPiece) {
    work.tell(0.5f * float(first) / float(rays.size()));
    if (interrupted()) return false;
    const std::vector<Hit> piece = exact.trace(rays.subspan(first, std::min(kRaysPerPiece, rays.size() - first)));
    exactHits.insert(exactHits.end(), piece.begin(), piece.end());
  }
  work.call("Finding the cause of each wrong ray");
  std::vector<RayTruth> truths = gridscope::tellTruth(input, rays, *current_.hits, exactHits,
                                                      [&](float share) { return work.tell(0.5f + 0.5f * share), !interrupted(); });
  if (truths.size() != rays.size()) return false;
  current_.truthTotals = countTruths(truths);
  current_.ledger = std::make_shared<const Ledger>(makeLedger(input, truths));
  current_.exact = shared(std::move(exactHits));
  current_.truths = shared(std::move(truths));
  tellRecorded(input);
  publish(false);
  return true;
}

// The recorded ray's own truth and proof; true when something was added.
bool FrameMaker::tellRecorded(const TruthInput& input) {
  const auto& record = current_.record;
  if (!record || record->pixel >= current_.truths->size()) return false;
  const RayTruth& truth = (*current_.truths)[record->pixel];
  const bool prove = made_.proveRecorded && !record->proof && truth.cause != kCauseNone;
  if (record->truth && !prove) return false;
  RecordedRay told = *record;
  told.exact = (*current_.exact)[record->pixel];
  told.truth = truth;
  if (prove) told.proof = proveRay(input, told.ray, (*current_.hits)[record->pixel], *told.exact, truth);
  current_.record = std::make_shared<const RecordedRay>(std::move(told));
  return true;
}

void FrameMaker::writeCapture(const CaptureWish& wish) {
  if (!pipeline_ || dirty_.any() || !productsRead_)
    throw Error(wish.file + ": the frame is not complete yet; capture it again in a moment");
  Capture capture = startCapture(*pipeline_, current_.scene->names, loaded_->bounds);
  capture.writer = std::string(kWriterName) + kVersion;
  capture.device = current_.device;
  capture.driver = gpu_.report().driver;
  capture.note = wish.note;
  if (const auto& before = loaded_->capture) {
    // What a foreign engine built stays its own: that name says from where a replay begins.
    if (!builtHere(*before)) capture.writer = before->writer;
    if (capture.note.empty()) capture.note = before->note;
    capture.unknownEntries = before->unknownEntries;
    capture.unknownKeys = before->unknownKeys;
    capture.scene.materials = before->scene.materials;
  }
  const float time = loaded_->capture ? capturedFrame().timeSeconds : float(made_.timeSeconds);
  capture.frames.push_back(takeFrame(*pipeline_, CaptureProducts{}, time));
  capture.preview = pngBytes(plainView(*pipeline_, "final"));
  gridscope::writeCapture(wish.file, capture);
}

std::string FrameMaker::reloadShaders() {
  const Work work(listener_, LongWork::Kind::shaders, "Compiling shaders");
  CompiledShaders compiled = compileShaders("", [&](float share) { return work.tell(share); });
  if (!compiled.fault.empty()) return compiled.fault;

  // The device must take all of them before the old ones go.
  ShaderWords before = replaceShaders(std::move(compiled.words));
  try {
    tryShaders(gpu_);
  } catch (const std::exception& error) {
    replaceShaders(std::move(before));
    return error.what();
  }
  listener_.say(LogLine::Kind::note, "Shaders: all passes compiled and in use");
  dirty_.scene = true;
  dirty_.spread();
  traced_ = 0;
  productsRead_ = gridRead_ = gridMeasured_ = false;
  return "";
}

}  // namespace gridscope
