// Makes the frame that a request asks for: runs the stages whose inputs changed, in an order in which something new can be shown soon. A request
// that was begun is carried on to its first picture, so that something is seen while one follows the other; behind that it stops between two
// pieces of work when another has come. What was done by then is kept.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <set>

#include "app/frame/changes.h"
#include "app/frame/messages.h"
#include "app/frame/snapshot.h"
#include "app/worker/source.h"
#include "core/gpu/context.h"
#include "views/view.h"

namespace gridscope {

// What the maker tells, and asks, while it works. All are called on its thread.
struct FrameListener {
  std::function<void(std::shared_ptr<const FrameSnapshot>)> publish;
  std::function<bool()> interrupted;                     // has another request come, or does the program end?
  std::function<bool()> ends;                            // does the program end?
  std::function<bool()> cancelled;                       // has the person cancelled the long work? true once
  std::function<void(std::optional<LongWork>)> working;  // nothing: the long work is over
  std::function<void(LogLine::Kind, std::string)> say;
};

class FrameMaker {
 public:
  FrameMaker(GpuContext& gpu, const Options& start, FrameListener listener);
  ~FrameMaker();

  // Returns when the frame is made or another request has come.
  void make(const FrameRequest& request);

  // Writes the present frame. Throws Error; also when no frame is complete.
  void writeCapture(const CaptureWish& wish);

  // The passes are compiled anew from shaders/ and replace the embedded ones; the frame is made again with the next request. Returns the
  // compiler's text where one fails, and everything stays as it was.
  std::string reloadShaders();

 private:
  using Clock = std::chrono::steady_clock;

  // Long work, told of as long as this lives; what was cancelled before it began does not count.
  class Work;

  // The stages, in order; each returns false when it goes no further with this request.
  bool bringSource(FrameRequest& request);
  bool bringPipeline();
  bool buildAndUpdate();
  bool makeRays();
  bool traceTiles();
  void fillViews(bool complete);
  bool readProducts();
  bool recordRay();
  bool measureGrid();
  bool tellTruth();
  bool findTruths(const TruthInput& input);
  bool tellRecorded(const TruthInput& input);

  // findings.cpp
  bool wantsFinding(ViewNeed need) const;
  void found(ViewNeed need);
  void keepGridBeforeUpdate();
  void findUpdates();
  bool countReads();
  bool findAboutCells();
  void compareSomeBuilds();
  bool showTruths();

  TraceInput traceInput() const;                // of what was read; likewise the next
  std::vector<std::string> gridFaults() const;  // of what must hold of the grid, what does not

  void publish(bool stale);
  bool interrupted() const { return listener_.interrupted(); }
  std::optional<LoadedSource> load(const FrameSource& source);  // nothing: it was cancelled
  void checkFixed(const FrameRequest& request) const;
  void takeRequest(const FrameRequest& request);
  void preparePipeline();
  void fail(const std::string& fault);  // keeps what there was, and says why
  void forgetPixels();
  void replaceSource(LoadedSource loaded);
  void applySettings(const FrameSettings& settings);
  FrameSettings pipelineSettings() const;
  bool capturedGridHolds() const;
  bool capturedRaysHold() const;
  bool capturedHitsHold() const;
  const CaptureFrame& capturedFrame() const;
  void countTime(const FrameRequest& request);

  GpuContext& gpu_;
  Options start_;
  FrameListener listener_;
  StageDevice device_;

  std::optional<LoadedSource> loaded_;
  std::vector<SceneInstance> loadedInstances_;  // of the scene without the edits that loaded_->scene has, which is the pipeline's
  std::unique_ptr<Pipeline> pipeline_;

  FrameRequest made_;         // what the stages were last asked for; settings given
  FrameChanges dirty_;        // stages that must run before made_ is met
  bool givenUp_ = false;      // the grid that made_ asks for was cancelled, and there is none before it
  uint32_t traced_ = 0;       // rays of this frame's trace that are done
  uint32_t tileRays_ = 4096;  // of the next tile
  std::set<std::string> viewsDone_;
  std::set<ViewNeed> findings_;                                   // that the pipeline has of this frame
  Grid gridBefore_;                                               // before the last update; empty: not kept
  std::shared_ptr<const std::vector<Instance>> instancesBefore_;  // likewise; null: the last update followed a build
  bool productsRead_ = false;                                     // rays, hits, counters, gather of the complete frame are in current_
  bool gridRead_ = false;                                         // grid, triangles, totals likewise
  bool gridMeasured_ = false;                                     // demand, ledger, invariants
  std::vector<std::string> gridFaults_;                           // a line for each broken one
  uint32_t proved_ = 0;                                           // FrameRequest::proveAll that was answered last
  FrameSnapshot current_;                                         // what is published next
};

}  // namespace gridscope
