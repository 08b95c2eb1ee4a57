// What is made of a frame once its picture stands: products for the panels, the recorded ray, invariants, demand and ledger, the truth,
// captures (frame_maker.h).
#include <cstring>

#include "app/capture_pictures.h"
#include "app/frame_maker.h"
#include "core/frame_capture.h"

namespace gridscope {

template <typename T>
static std::shared_ptr<const std::vector<T>> shared(std::vector<T> values) {
  return std::make_shared<const std::vector<T>>(std::move(values));
}

bool FrameMaker::readProducts() {
  if (!productsRead_) {
    if (interrupted()) return false;
    current_.gather = shared(pipeline_->gatherPixels());
    current_.rays = shared(pipeline_->rays());
    current_.hits = shared(pipeline_->hits());
    current_.counters = shared(pipeline_->counters());
    current_.traceNumber++;
    productsRead_ = true;
    publish(false);
  }
  if (!gridRead_) {
    if (interrupted()) return false;
    current_.grid = std::make_shared<const Grid>(pipeline_->grid());
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
  RecordedRay recorded{.pixel = *pixel, .ray = (*current_.rays)[*pixel], .record = pipeline_->record(*pixel), .frameHit = (*current_.hits)[*pixel]};
  recorded.equalsFrame = std::memcmp(&recorded.record.hit, &recorded.frameHit, sizeof(Hit)) == 0;
  current_.record = std::make_shared<const RecordedRay>(std::move(recorded));
  publish(false);
  return true;
}

// Slower than the picture: only when nothing else is asked for.
bool FrameMaker::measureGrid() {
  if (gridMeasured_) return true;
  if (interrupted()) return false;
  const bool foreign = current_.scene->foreign;
  current_.brokenInvariants = checkInvariants(*current_.grid, pipeline_->numbered(), foreign ? nullptr : &current_.tried);
  publish(false);
  if (interrupted()) return false;
  gridMeasured_ = true;
  return true;
}

// The truth is told elsewhere.
bool FrameMaker::tellTruth() { return true; }

void FrameMaker::writeCapture(const CaptureWish& wish) {
  if (!pipeline_ || dirty_.any() || !productsRead_) throw Error(wish.file + ": the frame is not complete yet; capture it again in a moment");
  Capture capture = startCapture(*pipeline_, current_.scene->names, loaded_->bounds);
  capture.writer = std::string(kWriterName) + GRIDSCOPE_VERSION;
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

// Compiling shaders while the program runs comes with the library that does it.
std::string FrameMaker::reloadShaders() { return ""; }

}  // namespace gridscope
