// See frame_maker.h. frame_details.cpp has what is made once the picture stands.
#include "app/frame_maker.h"

#include <algorithm>
#include <cstring>

#include "app/scene_edits.h"
#include "app/text.h"
#include "core/frame_capture.h"

namespace gridscope {

namespace {

constexpr double kTileMs = 60.0;                // wanted for one tile of the trace: an interruption waits no longer
constexpr double kPartialMs = 250.0;            // between two published parts of one trace
constexpr uint32_t kLeastTileRays = 1024;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
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
    if (!bringSource(request)) return;
    if (!bringPipeline() || !buildAndUpdate() || !makeRays() || !traceTiles()) return;
    if (!readProducts() || !recordRay() || !measureGrid() || !findAboutCells()) return;
    if (tellTruth()) showTruths();
  } catch (const Error& error) {
    // What was shown before stays what is asked for; its stages run again as far as the attempt came.
    if (before.settings && before.source == loaded_->source) made_ = current_.request = before;
    listener_.working(std::nullopt);
    fail(error.what());
  }
}

// Loading runs on a thread of its own, so that it can be left alone.
bool FrameMaker::waitForLoad(std::future<LoadedSource>& loading, const std::string& what) {
  const Clock::time_point start = Clock::now();
  while (loading.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
    listener_.working(LongWork{.what = what, .share = -1.0f, .seconds = millisecondsSince(start) / 1000.0});
    if (!listener_.cancelled()) continue;
    abandoned_.push_back(std::move(loading));
    listener_.working(std::nullopt);
    return false;
  }
  listener_.working(std::nullopt);
  return true;
}

void FrameMaker::replaceSource(LoadedSource loaded) {
  pipeline_.reset();
  loaded_ = std::move(loaded);
  auto facts = std::make_shared<SceneFacts>(factsOf(*loaded_));
  current_.scene = facts;
  current_.grid.reset(), current_.worldTriangles.reset(), current_.instances.reset();
  current_.demand.reset(), current_.ledger.reset(), current_.views.clear();
  current_.totals = {}, current_.brokenInvariants.reset();
  forgetPixels();
}

// The source, and from here on a request with settings; what it changes is added to what must run.
bool FrameMaker::bringSource(FrameRequest& request) {
  const bool another = !loaded_ || loaded_->source != request.source;
  if (another) {
    std::erase_if(abandoned_, [](auto& load) { return load.wait_for(std::chrono::seconds(0)) == std::future_status::ready; });
    std::future<LoadedSource> loading = std::async(std::launch::async, loadSource, request.source, start_);
    if (!waitForLoad(loading, "Loading " + request.source.scene)) {
      fail("Loading " + request.source.scene + " was cancelled");
      return false;
    }
    LoadedSource loaded = loading.get();   // throws what the load threw: the old source stays
    if (!request.settings) request.settings = loaded.settings;
    replaceSource(std::move(loaded));
    dirty_.source = true;
    dirty_.spread();
    for (const std::string& warning : loaded_->scene.warnings) listener_.say(LogLine::Kind::warning, "warning: " + warning);
  } else {
    if (!request.settings) request.settings = made_.settings ? made_.settings : loaded_->settings;
    FrameChanges changes = changesBetween(made_, request);
    if (loaded_->capture && made_.frame != request.frame) changes.update = changes.gather = true;
    dirty_.add(changes);
  }
  if (dirty_.slice) std::erase_if(viewsDone_, [](const std::string& name) { return !findView(name) || findView(name)->scope == ViewScope::slice; });
  dirty_.slice = false;
  if (dirty_.trace) traced_ = 0, productsRead_ = false;
  if (dirty_.update) gridRead_ = gridMeasured_ = false;
  made_ = request;
  current_.request = request;
  return true;
}

// What the pipeline is made with: edits keep the grid where it was.
FrameSettings FrameMaker::pipelineSettings() const {
  FrameSettings settings = *made_.settings;
  if (!made_.edits.empty() && !settings.grid.bounds) settings.grid.bounds = loaded_->bounds;
  return settings;
}

// A new pipeline where the numbering changes; else the old one takes the new settings.
bool FrameMaker::bringPipeline() {
  if (interrupted()) return false;
  if (!dirty_.any() && pipeline_) return true;
  const FrameSettings settings = pipelineSettings();
  if (dirty_.size || dirty_.scene || !pipeline_) forgetPixels(), viewsDone_.clear(), findings_.clear();
  if (dirty_.scene || !pipeline_) {
    listener_.working(LongWork{.what = "Preparing " + current_.scene->name, .share = -1.0f});
    pipeline_.reset();
    if (loaded_->capture) {
      PipelineInputs inputs = pipelineInputs(*loaded_->capture, made_.frame % loaded_->capture->frames.size());
      pipeline_ = std::make_unique<Pipeline>(gpu_, std::move(inputs), device_);
    } else {
      edited_ = editedScene(loaded_->scene, made_.edits);
      pipeline_ = std::make_unique<Pipeline>(gpu_, edited_, settings, device_);
    }
    listener_.working(std::nullopt);
    auto facts = std::make_shared<SceneFacts>(*current_.scene);
    facts->numbered = pipeline_->numbered();
    current_.scene = facts;
    current_.grid.reset(), current_.worldTriangles.reset(), current_.demand.reset(), current_.ledger.reset();
  }
  applySettings(settings);
  dirty_.source = dirty_.scene = dirty_.size = dirty_.grid = false;
  return !interrupted();
}

void FrameMaker::applySettings(const FrameSettings& settings) {
  const FrameSettings before = pipeline_->settings();
  if (!sameGrid(before.grid, settings.grid)) {
    if (current_.scene->foreign) throw Error("the grid of " + current_.scene->name + " is another engine's: its settings are fixed");
    pipeline_->setGrid(settings.grid);
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
  const FrameSettings &now = *made_.settings, &own = loaded_->settings;
  return loaded_->capture && made_.edits.empty() && sameCamera(now.camera, own.camera) && sameBounce(now.bounce, own.bounce) &&
         now.width == own.width && now.height == own.height;
}

bool FrameMaker::buildAndUpdate() {
  const bool foreign = current_.scene->foreign;
  if (dirty_.build) {
    if (!foreign) pipeline_->build();
    dirty_.build = false;
    dirty_.update = true;
  }
  if (interrupted()) return false;
  if (!dirty_.update) return true;
  keepGridBeforeUpdate();
  findings_.clear();
  if (!loaded_->capture) {
    if (!made_.edits.empty()) edited_ = editedScene(loaded_->scene, made_.edits);
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
  return !interrupted();
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
  if (capturedRaysHold() && !capturedFrame().rays.empty()) pipeline_->useRays(capturedFrame().rays);
  else if (loaded_->rays.size() == pipeline_->rayCount()) pipeline_->useRays(loaded_->rays);
  else pipeline_->bounce(made_.frame);
  dirty_.bounce = false;
  dirty_.trace = true;
  traced_ = 0;
  // Hits of other rays must not be taken for these rays' own.
  pipeline_->useHits(std::vector<Hit>(pipeline_->rayCount(), Hit{kHitNoRay, 0.0f, kBlank, 0.0f, 0.0f}));
  forgetPixels();
  return true;
}

// In tiles whose size follows the time that they take.
bool FrameMaker::traceTiles() {
  if (!dirty_.trace) return fillViews(true);
  const uint32_t rays = pipeline_->rayCount();
  current_.traced = float(traced_) / float(rays);
  if (traced_ == 0) {
    std::erase_if(viewsDone_, [](const std::string& name) {
      const View* view = findView(name);
      return !view || view->scope == ViewScope::ray || view->needsCounters;
    });
    current_.exact.reset(), current_.truths.reset(), current_.proofs.reset(), current_.cellRays.reset(), current_.record.reset();
    findings_ = findings_.contains(ViewNeed::cellUpdates) ? std::set{ViewNeed::cellUpdates} : std::set<ViewNeed>{};
    if (!fillViews(false)) return false;
  }
  Clock::time_point published = Clock::now();
  while (traced_ < rays) {
    if (interrupted()) return false;
    const Clock::time_point start = Clock::now();
    const uint32_t end = std::min(rays, traced_ + tileRays_);
    pipeline_->traceTile(traced_, end, true);
    const double tileMs = std::max(millisecondsSince(start), 0.05);
    tileRays_ = std::clamp(uint32_t(double(end - traced_) * std::clamp(kTileMs / tileMs, 0.25, 4.0)), kLeastTileRays, 1u << 24);
    traced_ = end;
    if (traced_ == rays || millisecondsSince(published) < kPartialMs) continue;
    current_.traced = float(traced_) / float(rays);
    if (!fillViews(false)) return false;
    published = Clock::now();
  }
  dirty_.trace = false;
  current_.traced = 1.0f;
  return fillViews(true);
}

// Views that are asked for and not there yet. While the trace is not complete those of rays are shown as far as they are, and filled again.
bool FrameMaker::fillViews(bool complete) {
  bool changed = false;
  for (const std::string& name : made_.views) {
    const View* view = findView(name);
    if (!view || viewsDone_.contains(name) || (view->need != ViewNeed::nothing && !findings_.contains(view->need))) continue;
    if (interrupted()) return false;
    try {
      current_.views[name] = std::make_shared<const Pipeline::ViewImage>(pipeline_->view(name, made_.slice, view->needsGrid));
    } catch (const Error& error) {
      listener_.say(LogLine::Kind::error, std::string(view->title) + ": " + error.what());
    }
    changed = true;
    if (complete || (view->scope != ViewScope::ray && !view->needsCounters)) viewsDone_.insert(name);
  }
  std::erase_if(current_.views, [&](const auto& entry) { return !made_.views.contains(entry.first); });
  std::erase_if(viewsDone_, [&](const std::string& name) { return !made_.views.contains(name); });
  if (changed) publish(!complete);
  return true;
}

}  // namespace gridscope
