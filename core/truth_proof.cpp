// Proof of causes by taking events away; see truth_proof.h.
#include "core/truth_proof.h"

#include <algorithm>
#include <atomic>

#include "core/error.h"
#include "core/parallel.h"
#include "core/truth_edits.h"

namespace gridscope {

namespace {

constexpr uint32_t kControlSeed = 0x9E3779B9u;  // of the control's draw

TruthEvent eventOf(const RayTruth& truth) { return {truth.cause, truth.cell, truth.reference, truth.segment}; }

// A draw below `count` that depends on the ray and the seed alone.
uint32_t draw(uint32_t ray, uint32_t count) {
  uint32_t bits = ray * 0x85EBCA6Bu ^ kControlSeed;
  bits ^= bits >> 16, bits *= 0x7FEB352Du, bits ^= bits >> 15, bits *= 0x846CA68Bu, bits ^= bits >> 16;
  return uint32_t((uint64_t(bits) * count) >> 32);
}

// What was found out about one ray.
struct RayProof {
  uint16_t links = 0;                  // of a confirmed proof
  bool confirmed = false;
  bool controlled = false;             // there was another ray to draw from
  bool controlConfirmed = false;
};

// The rays of each cause, rising.
std::array<std::vector<uint32_t>, kCauseCount> raysByCause(std::span<const RayTruth> truths) {
  std::array<std::vector<uint32_t>, kCauseCount> rays;
  for (uint32_t i = 0; i < truths.size(); ++i)
    if (truths[i].cause != kCauseNone) rays[truths[i].cause].push_back(i);
  return rays;
}

}  // namespace

Proof proveRay(const TruthInput& input, const Ray& ray, const Hit& exact, const RayTruth& truth) {
  Proof proof;
  if (truth.cause == kCauseNone) return proof;
  std::vector<TruthEvent> removed;
  TruthEvent next = eventOf(truth);
  while (removed.size() < kMostProofLinks && std::ranges::find(removed, next) == removed.end()) {
    removed.push_back(next);
    proof.links.push_back({next.cause, next.cell, next.reference, next.segment});
    const RayRecord record = recordWithout(input.trace, ray, removed);
    proof.hit = record.hit;
    proof.confirmed = judge(record.hit, exact, input.trace.grid.parameters) == kVerdictAgrees;
    if (proof.confirmed) break;
    next = findEvent(input, ray, record, exact);
  }
  return proof;
}

ProofTotals::Count ProofTotals::sum() const {
  Count sum;
  for (const Count& count : causes) {
    sum.alone += count.alone;
    sum.chain += count.chain;
    sum.total += count.total;
    sum.controlConfirmed += count.controlConfirmed;
    sum.controlTotal += count.controlTotal;
  }
  return sum;
}

ProofTotals proveFrame(const TruthInput& input, const ExactReference& exact, std::span<const Ray> rays, std::span<const RayTruth> truths,
                       const TruthProgress& progress) {
  return proveFrame(input, exact.trace(rays), rays, truths, progress);
}

ProofTotals proveFrame(const TruthInput& input, std::span<const Hit> exact, std::span<const Ray> rays, std::span<const RayTruth> truths,
                       const TruthProgress& progress) {
  CHECK_EQ(truths.size(), rays.size());
  CHECK_EQ(exact.size(), rays.size());
  const auto byCause = raysByCause(truths);
  std::vector<uint32_t> todo;
  for (uint32_t i = 0; i < truths.size(); ++i)
    if (truths[i].cause != kCauseNone) todo.push_back(i);

  // Each ray's proof, and the control: the same with another ray's event.
  std::vector<RayProof> proofs(todo.size());
  std::atomic<size_t> done{0};
  std::atomic<bool> abandoned{false};
  forRanges(todo.size(), 64, [&](size_t begin, size_t end) {
    if (abandoned) return;
    for (size_t i = begin; i < end; ++i) {
      const uint32_t ray = todo[i];
      const Proof proof = proveRay(input, rays[ray], exact[ray], truths[ray]);
      proofs[i].confirmed = proof.confirmed;
      proofs[i].links = uint16_t(proof.links.size());
      const std::vector<uint32_t>& others = byCause[truths[ray].cause];
      if (others.size() < 2) continue;
      uint32_t other = others[draw(ray, uint32_t(others.size() - 1))];
      if (other == ray) other = others.back();
      const TruthEvent drawn = eventOf(truths[other]);
      proofs[i].controlled = true;
      const Hit hit = recordWithout(input.trace, rays[ray], {&drawn, 1}).hit;
      proofs[i].controlConfirmed = judge(hit, exact[ray], input.trace.grid.parameters) == kVerdictAgrees;
    }
    done += end - begin;
    if (progress && !progress(float(done) / float(todo.size()))) abandoned = true;
  });
  if (abandoned) return {};

  ProofTotals totals;
  for (size_t i = 0; i < todo.size(); ++i) {
    ProofTotals::Count& count = totals.causes[truths[todo[i]].cause];
    const RayProof& proof = proofs[i];
    count.total += 1;
    count.alone += proof.confirmed && proof.links == 1 ? 1 : 0;
    count.chain += proof.confirmed && proof.links > 1 ? 1 : 0;
    count.controlTotal += proof.controlled ? 1 : 0;
    count.controlConfirmed += proof.controlConfirmed ? 1 : 0;
    if (proof.confirmed) totals.mostLinks = std::max<uint64_t>(totals.mostLinks, proof.links);
    else totals.notConfirmed.push_back(todo[i]);
  }
  return totals;
}

}  // namespace gridscope
