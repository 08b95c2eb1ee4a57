// What the worker hands to the window: one frame's products as they stood together, never changed after. Pieces that did not change are
// shared with the snapshot before.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/frame/full_cells.h"
#include "app/frame/request.h"
#include "core/capture/capture.h"
#include "core/grid/demand.h"
#include "core/grid/invariants.h"
#include "core/pipeline/pipeline.h"
#include "core/truth/ledger.h"
#include "core/truth/proof.h"
#include "core/truth/truth.h"

namespace gridscope {

// What holds for all frames of a source, until an edit or a grid setting changes it.
struct SceneFacts {
  std::string path;  // or the built-in scene's name
  std::string name;  // for the title
  CaptureNames names;
  std::vector<std::string> meshOfInstance;  // by scene instance
  NumberedScene numbered;                   // static transforms; dynamic ones as of numbering
  Bounds bounds;
  std::vector<CameraPose> cameras;  // the file's, and the default
  double duration = 0.0;            // seconds of the longest animation; 0: nothing moves
  uint32_t captureFrames = 0;       // of a capture's sequence; 0: not a capture
  bool foreign = false;             // another engine's grid: build and update do not apply
  std::string note;                 // of a capture
  bool lacksDiffuseMaps = false;    // a capture whose surfaces show their base colour
  FrameSettings ownSettings;        // the source's own, for a reset
  std::vector<std::string> warnings;
};

// The recorded ray of a pixel.
struct RecordedRay {
  uint32_t pixel = 0;
  Ray ray{};
  uint32_t surface = kNoReference;  // the reference of the triangle that it was launched from; blank: not known
  RayRecord record;
  Hit frameHit{};            // the frame's, from the fast trace
  bool equalsFrame = false;  // record.hit is frameHit, bit for bit
  std::optional<Hit> exact;
  std::optional<RayTruth> truth;
  std::optional<Proof> proof;
};

struct FrameSnapshot {
  uint64_t number = 0;       // rises with every snapshot
  uint64_t traceNumber = 0;  // rises when hits changed
  FrameRequest request;      // that it answers; settings given
  std::shared_ptr<const SceneFacts> scene;
  FrameParameters parameters{};  // of the stages; while they run again `grid` may still be of other parameters, which it carries itself
  StageTimes times;
  std::string device;   // that runs build, update and trace
  std::string fault;    // why the request before this one could not be met; empty: it was. `request` is what is shown instead
  bool stale = false;   // stages are running again: values hold for the request before
  float traced = 1.0f;  // share of the rays that this frame's trace has done

  GridTotals totals;
  uint64_t tried = 0;  // references
  UpdateReport update;
  std::optional<std::vector<std::string>> brokenInvariants;  // of grid and hits, a line each; empty: all hold; nothing: not tested yet

  std::shared_ptr<const Grid> grid;
  std::shared_ptr<const std::vector<CellFacts>> occupied;  // of `grid`: its cells that hold or refused a reference, x fastest
  std::shared_ptr<const std::vector<Triangle>> worldTriangles;
  std::shared_ptr<const std::vector<Instance>> instances;  // transforms of the frame
  std::shared_ptr<const std::vector<GatherPixel>> gather;
  std::shared_ptr<const std::vector<Ray>> rays;
  std::shared_ptr<const std::vector<Hit>> hits;
  std::shared_ptr<const std::vector<RayCounters>> counters;
  std::map<std::string, std::shared_ptr<const Pipeline::ViewImage>> views;

  std::shared_ptr<const Demand> demand;                 // null until first asked for
  std::shared_ptr<const Ledger> ledger;                 // likewise; with costs in rays once the truth is told
  std::shared_ptr<const std::vector<Hit>> exact;        // null until the truth is told
  std::shared_ptr<const std::vector<RayTruth>> truths;  // likewise
  TruthTotals truthTotals;
  std::shared_ptr<const std::vector<CellRays>> cellRays;  // by cell, x fastest; null until asked for
  std::shared_ptr<const ProofTotals> proofs;              // null until asked for
  std::shared_ptr<const RecordedRay> record;              // of request.recordPixel; null: none, or on its way

  const GridParameters& gridShape() const { return grid ? grid->parameters : parameters.grid; }  // of `grid`, where there is one
  uint32_t pixelCount() const { return request.settings ? request.settings->width * request.settings->height : 0; }
};

}  // namespace gridscope
