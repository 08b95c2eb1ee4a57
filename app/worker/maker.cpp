// See maker.h. details.cpp has what is made once the picture stands.
#include "app/worker/maker.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "app/base/text.h"
#include "app/frame/scene_edits.h"
#include "app/session/session.h"
#include "app/worker/work.h"
#include "core/base/error.h"
#include "core/pipeline/frame_capture.h"

namespace gridscope {

namespace {

constexpr double kTileMs = 60.0;        // wanted for one tile of the trace: an interruption waits no longer
constexpr double kPartialMs = 250.0;    // between two published parts of one trace
constexpr double kLeastTraceMs = 80.0;  // traced of a request although another waits: who moves the camera sees what rays hit, too
constexpr uint32_t kLeastTileRays = 1024;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// For a person; what is no Error comes from libraries.
std::string faultText(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) return "out of memory; take a smaller scene, grid or frame";
  return error.what();
}

}  // namespace

FrameMaker::FrameMaker(GpuContext& gpu, const Options& start, FrameListener listener)
    : gpu_(gpu), start_(start), listener_(std::move(listener)), device_(start.onCpu() ? StageDevice::cpu : StageDevice::vulkan) {
  current_.device = start.onCpu() ? "cpu" : gpu.report().name;
}

FrameMaker::~FrameMaker() = default;

void FrameMaker::publish(bool stale) {
  current_.number++;
  current_.stale = stale;
  if (pipeline_) {
    current_.parameters = pipeline_->parameters();
    current_.times = pipeline_->times();
  }
  listener_.publish(std::make_shared<const FrameSnapshot>(current_));
}

void FrameMaker::fail(const std::string& fault) {
  current_.fault = fault;
  publish(dirty_.any());
  current_.fault.clear();
}

void FrameMaker::forgetPixels() {
  current_.gather.reset(), current_.rays.reset(), current_.hits.reset(), current_.counters.reset();
  current_.exact.reset(), current_.truths.reset(), current_.proofs.reset(), current_.cellRays.reset(), current_.record.reset();
  current_.truthTotals = {};
}

void FrameMaker::make(const FrameRequest& wanted) {
  FrameRequest request = wanted;
  const FrameRequest before = made_;
  try {
    if (!bringSource(request) || givenUp_) return;
    if (!bringPipeline() || !buildAndUpdate() || !makeRays() || !traceTiles()) return;
    if (!readProducts() || !recordRay() || !measureGrid() || !findAboutCells()) return;
    if (tellTruth()) showTruths();
  } catch (const std::exception& error) {
    // What was shown before stays what is asked for; its stages run again as far as the attempt came.
    const bool back = before.settings && loaded_ && before.source == loaded_->source;
    if (back)
      made_ = current_.request = before;
    else
      givenUp_ = loaded_.has_value() && !productsRead_;
    fail(faultText(error));
  }
}

// On a thread of its own, which is left alone when the person or the program does not want to wait.
std::optional<LoadedSource> FrameMaker::load(const FrameSource& source) {
  const Work work(listener_, LongWork::Kind::source, "Loading " + source.scene);
  std::future<LoadedSource> loading = loadAside(source, start_);
  while (loading.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
    if (!work.tell(-1.0f)) return std::nullopt;
  return loading.get();  // throws what the load threw: the old source stays
}

void FrameMaker::replaceSource(LoadedSource loaded) {
  pipeline_.reset();
  loaded_ = std::move(loaded);
  loadedInstances_ = loaded_->scene.instances;
  auto facts = std::make_shared<SceneFacts>(factsOf(*loaded_));
  current_.scene = facts;
  current_.grid.reset(), current_.occupied.reset(), current_.worldTriangles.reset(), current_.instances.reset();
  current_.demand.reset(), current_.ledger.reset(), current_.views.clear();
  current_.totals = {}, current_.brokenInvariants.reset();
  forgetPixels();
}

// What a capture has fixed.
void FrameMaker::checkFixed(const FrameRequest& request) const {
  if (!loaded_->capture) return;
  const std::string& name = current_.scene->name;
  if (!request.edits.empty()) throw Error(name + ": instances of a capture can't be hidden, removed or moved; open its scene for that");
  if (request.settings->grid.numberBy != loaded_->settings.grid.numberBy)
    throw Error(name + ": the references of a capture keep their order; open its scene for another");
  if (current_.scene->foreign && !sameGrid(request.settings->grid, loaded_->settings.grid))
    throw Error("the grid of " + name + " is another engine's: its settings are fixed");
}

// The source, and from here on a request with settings; what it changes is added to what must run.
bool FrameMaker::bringSource(FrameRequest& request) {
  const bool another = !loaded_ || loaded_->source != request.source;
  if (another) {
    std::optional<LoadedSource> loaded = load(request.source);
    if (!loaded) {
      fail("Loading " + request.source.scene + " was cancelled");
      return false;
    }
    if (!request.settings) request.settings = loaded->settings;
    if (!loaded->rays.empty()) request.settings->width = loaded->settings.width, request.settings->height = loaded->settings.height;
    replaceSource(std::move(*loaded));
    dirty_.source = true;
    dirty_.spread();
    givenUp_ = false;
    for (const std::string& warning : loaded_->scene.warnings) listener_.say(LogLine::Kind::warning, "warning: " + warning);
  }
  if (!loaded_->capture && editsWithin(request.edits, loadedInstances_.size()).size() < request.edits.size()) {
    request.edits = editsWithin(request.edits, loadedInstances_.size());
    if (another)
      listener_.say(LogLine::Kind::warning,
                    "warning: " + current_.scene->name + " has fewer instances now: edits of those that are gone are left out");
  }
  if (another && loaded_->capture) request.edits.clear();
  if (!request.settings) request.settings = made_.settings ? made_.settings : loaded_->settings;
  checkFixed(request);
  if (!another) {
    FrameChanges changes = changesBetween(made_, request);
    if (loaded_->capture && made_.frame != request.frame) changes.update = changes.gather = true;
    if (changes.build || changes.size) givenUp_ = false;
    dirty_.add(changes);
  }
  takeRequest(request);
  return true;
}

void FrameMaker::takeRequest(const FrameRequest& request) {
  if (dirty_.slice)
    std::erase_if(viewsDone_, [](const std::string& name) { return !findView(name) || findView(name)->scope == ViewScope::slice; });
  dirty_.slice = false;
  if (dirty_.trace) traced_ = 0, productsRead_ = false;
  if (dirty_.update) gridRead_ = gridMeasured_ = false;
  if (!request.truth && !request.proveRecorded) proved_ = request.proveAll;  // a proof that was cancelled is not for the next truth
  made_ = request;
  current_.request = request;
}

// What the pipeline is made with: edits keep the grid where it was.
FrameSettings FrameMaker::pipelineSettings() const {
  FrameSettings settings = *made_.settings;
  if (!made_.edits.empty() && !settings.grid.bounds) settings.grid.bounds = loaded_->bounds;
  return settings;
}

// A new pipeline where the numbering changes; else the old one takes the new settings.
bool FrameMaker::bringPipeline() {
  if (listener_.ends()) return false;
  if (!dirty_.any() && pipeline_) return true;
  if (dirty_.size || dirty_.scene || !pipeline_) forgetPixels(), viewsDone_.clear(), findings_.clear();
  if (dirty_.scene || !pipeline_) preparePipeline();
  applySettings(pipelineSettings());
  dirty_.source = dirty_.scene = dirty_.size = dirty_.grid = false;
  return !listener_.ends();
}

void FrameMaker::preparePipeline() {
  const Work work(listener_, LongWork::Kind::grid, "Preparing " + current_.scene->name);
  pipeline_.reset();
  if (loaded_->capture) {
    PipelineInputs inputs = pipelineInputs(*loaded_->capture, made_.frame % loaded_->capture->frames.size());
    pipeline_ = std::make_unique<Pipeline>(gpu_, std::move(inputs), device_);
  } else {
    applyEdits(loaded_->scene, loadedInstances_, made_.edits);
    pipeline_ = std::make_unique<Pipeline>(gpu_, loaded_->scene, pipelineSettings(), device_);
  }
  auto facts = std::make_shared<SceneFacts>(*current_.scene);
  facts->numbered = pipeline_->numbered();
  current_.scene = facts;
  current_.grid.reset(), current_.occupied.reset(), current_.worldTriangles.reset(), current_.instances.reset();
  current_.demand.reset(), current_.ledger.reset();
  if (!work.tell(-1.0f)) throw Error("Preparing " + current_.scene->name + " was cancelled; change a setting of the grid to go on");
}

void FrameMaker::applySettings(const FrameSettings& settings) {
  const FrameSettings before = pipeline_->settings();
  if (!sameGrid(before.grid, settings.grid)) {
    GridSettings grid = settings.grid;
    grid.numberBy = before.grid.numberBy;  // the pipeline's references have their order
    pipeline_->setGrid(grid);
  }
  if (before.width != settings.width || before.height != settings.height) pipeline_->setSize(settings.width, settings.height);
  if (!sameCamera(before.camera, settings.camera)) pipeline_->setCamera(settings.camera);
  if (!sameTrace(before.trace, settings.trace)) pipeline_->setTrace(settings.trace);
  if (!sameBounce(before.bounce, settings.bounce)) pipeline_->setBounce(settings.bounce);
}

const CaptureFrame& FrameMaker::capturedFrame() const { return loaded_->capture->frames[made_.frame % loaded_->capture->frames.size()]; }

// Captured products stand as long as nothing that they depend on was changed.
bool FrameMaker::capturedGridHolds() const {
  return loaded_->capture && made_.edits.empty() && !capturedFrame().grid.empty() && sameGrid(made_.settings->grid, loaded_->settings.grid);
}

bool FrameMaker::capturedRaysHold() const {
  if (!loaded_->capture) return false;
  const FrameSettings &now = *made_.settings, &own = loaded_->settings;
  const std::vector<CameraPose>& cameras = loaded_->cameras;
  const CameraPose& camera = cameras.size() > 1 ? cameras[made_.frame % cameras.size()] : own.camera;
  return made_.edits.empty() && sameCamera(now.camera, camera) && sameBounce(now.bounce, own.bounce) && now.width == own.width &&
         now.height == own.height;
}

bool FrameMaker::capturedHitsHold() const {
  return capturedRaysHold() && !capturedFrame().hits.empty() && sameGrid(made_.settings->grid, loaded_->settings.grid) &&
         sameTrace(made_.settings->trace, loaded_->settings.trace);
}

bool FrameMaker::buildAndUpdate() {
  const bool foreign = current_.scene->foreign, built = dirty_.build;
  if (built && !foreign) {
    const Work work(listener_, LongWork::Kind::grid, "Building the grid");
    pipeline_->build([&](float share) { return work.tell(share); });
  }
  if (built) dirty_.build = false, dirty_.update = true;
  if (listener_.ends()) return false;
  if (!dirty_.update) return true;
  keepGridBeforeUpdate();
  instancesBefore_ = built ? nullptr : current_.instances;
  findings_.clear();
  if (!loaded_->capture) {
    if (!made_.edits.empty()) applyEdits(loaded_->scene, loadedInstances_, made_.edits);
    pipeline_->update(float(made_.timeSeconds));
  } else if (!foreign) {
    pipeline_->update(frameInstances(*loaded_->capture, made_.frame % loaded_->capture->frames.size()));
  }
  if (capturedGridHolds()) pipeline_->useGrid(capturedFrame().grid);
  dirty_.update = false;
  gridRead_ = gridMeasured_ = false;
  current_.demand.reset(), current_.ledger.reset();
  current_.totals = pipeline_->gridTotals();
  current_.tried = foreign || capturedGridHolds() ? current_.totals.stored() + current_.totals.refused() : pipeline_->referencesTried();
  current_.update = pipeline_->updateReport();
  current_.instances = std::make_shared<const std::vector<Instance>>(pipeline_->numbered().instances);
  viewsDone_.clear();
  return !listener_.ends();
}

bool FrameMaker::makeRays() {
  if (dirty_.gather) {
    pipeline_->gather();
    if (capturedRaysHold() && !capturedFrame().gather.empty()) pipeline_->useGather(capturedFrame().gather);
    dirty_.gather = false;
    dirty_.bounce = true;
    viewsDone_.clear();
  }
  if (!dirty_.bounce) return true;
  if (capturedRaysHold() && !capturedFrame().rays.empty())
    pipeline_->useRays(capturedFrame().rays);
  else if (loaded_->rays.size() == pipeline_->rayCount())
    pipeline_->useRays(loaded_->rays);
  else
    pipeline_->bounce(made_.frame);
  dirty_.bounce = false;
  dirty_.trace = true;
  traced_ = 0;
  // Hits of other rays must not be taken for these rays' own.
  pipeline_->useHits(std::vector<Hit>(pipeline_->rayCount(), Hit{kHitNoRay, 0.0f, kNoReference, 0.0f, 0.0f}));
  forgetPixels();
  return true;
}

// In tiles whose size follows the time that they take.
bool FrameMaker::traceTiles() {
  if (!dirty_.trace) return fillViews(true), true;
  const uint32_t rays = pipeline_->rayCount();
  current_.traced = float(traced_) / float(rays);
  if (traced_ == 0) {
    std::erase_if(viewsDone_, [](const std::string& name) {
      const View* view = findView(name);
      return !view || view->scope == ViewScope::ray || view->needsCounters;
    });
    current_.exact.reset(), current_.truths.reset(), current_.proofs.reset(), current_.cellRays.reset(), current_.record.reset();
    findings_ = findings_.contains(ViewNeed::cellUpdates) ? std::set{ViewNeed::cellUpdates} : std::set<ViewNeed>{};
    if (!interrupted()) fillViews(false);
  }
  const Clock::time_point began = Clock::now();
  Clock::time_point published = began;
  while (traced_ < rays) {
    if (listener_.ends()) return false;
    if (interrupted() && millisecondsSince(began) >= kLeastTraceMs) return fillViews(false), false;
    const Clock::time_point start = Clock::now();
    const uint32_t end = std::min(rays, traced_ + tileRays_);
    pipeline_->traceTile(traced_, end, true);
    const double tileMs = std::max(millisecondsSince(start), 0.05);
    tileRays_ = std::clamp(uint32_t(double(end - traced_) * std::clamp(kTileMs / tileMs, 0.25, 4.0)), kLeastTileRays, 1u << 24);
    traced_ = end;
    current_.traced = float(traced_) / float(rays);
    if (traced_ == rays || millisecondsSince(published) < kPartialMs) continue;
    fillViews(false);
    published = Clock::now();
  }
  if (capturedHitsHold())
    if (const uint64_t different = useCapturedHits(*pipeline_, capturedFrame().hits))
      listener_.say(LogLine::Kind::warning, foreignHitsText(different));
  dirty_.trace = false;
  fillViews(true);
  return true;
}

// Views that are asked for and not there yet. While the trace is not complete those of rays are shown as far as they are, and filled again.
void FrameMaker::fillViews(bool complete) {
  SliceSettings slice = made_.slice;
  slice.index = std::min(slice.index, pipeline_->parameters().grid.cellCount[slice.axis] - 1);  // the grid may have become coarser
  current_.request.slice = slice;
  bool changed = false;
  for (const std::string& name : made_.views) {
    const View* view = findView(name);
    if (!view || viewsDone_.contains(name) || (view->need != ViewNeed::nothing && !findings_.contains(view->need))) continue;
    try {
      current_.views[name] = std::make_shared<const Pipeline::ViewImage>(pipeline_->view(name, slice, view->needsGrid));
    } catch (const Error& error) {
      listener_.say(LogLine::Kind::error, std::string(view->title) + ": " + error.what());
    }
    changed = true;
    if (complete || (view->scope != ViewScope::ray && !view->needsCounters)) viewsDone_.insert(name);
  }
  std::erase_if(current_.views, [&](const auto& entry) { return !made_.views.contains(entry.first); });
  std::erase_if(viewsDone_, [&](const std::string& name) { return !made_.views.contains(name); });
  if (changed) publish(!complete);
}

}  // namespace gridscope
