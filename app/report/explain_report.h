// What `explain` says about a frame: verdicts, causes, proofs, what was lost where, as text and as JSON.
#pragma once

#include <cstdio>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/report/pixel_story.h"
#include "core/grid/invariants.h"
#include "core/pipeline/frame_truth.h"

namespace gridscope {

struct ExplainReport {
  FrameTruth frame;
  uint32_t frameNumber = 0;   // of a sequence
  GridTotals grid;            // of the device
  bool countsRefused = true;  // the grid counts what it refuses; otherwise references tried and refused are not known
  std::optional<uint64_t>
      foreignHits;  // of a capture's hits: how many are not what the trace ends with; nothing: the trace's are explained
  Ledger ledger;
  std::optional<ProofTotals> proofs;  // of --verify
  std::vector<uint32_t> worst;        // rays, the worst first
  uint32_t width = 0;                 // of the frame, pixels
  double explainMs = 0.0;             // demand, exact hits and causes
  double proveMs = 0.0;
};

// One ray in sentences, with its proof when proofs were asked for.
struct ToldRay {
  uint32_t pixel = 0;
  std::optional<Proof> proof;
  std::vector<StoryPart> story;
};
ToldRay tellRay(const ExplainReport& report, const CaptureNames& names, uint32_t pixel);

// The tables: verdicts, causes, the meshes and cells that cost most, the worst rays.
void printExplain(std::FILE* out, const ExplainReport& report, const CaptureNames& names);

// Adds wrong, agree, verdicts and causes.
void addTruthTotals(nlohmann::ordered_json& json, const TruthTotals& totals);

// One ray: its story, cause, reason, what its cell holds and refused, and each link of its proof.
nlohmann::ordered_json pixelJson(const ExplainReport& report, const CaptureNames& names, const ToldRay& ray);

// rays, wrong, agree, verdicts, causes, [confirmed, control, controlChain,] references, cells, meshes, fullest cells, worst rays, times.
nlohmann::ordered_json explainJson(const ExplainReport& report, const CaptureNames& names);

// "references" and "cells" of the JSON of explain and check. What a grid does not count is null.
void addGridTotals(nlohmann::ordered_json& json, const GridTotals& grid, bool countsRefused);

}  // namespace gridscope
