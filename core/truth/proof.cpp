// Proof of causes by taking events away; see proof.h.
#include "core/truth/proof.h"

#include <algorithm>
#include <atomic>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/truth/edits.h"

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
  uint16_t links = 0;  // of a confirmed proof
  bool confirmed = false;
  bool controlled = false;  // there was another ray to draw from
  bool controlAlone = false;
  bool controlConfirmed = false;  // alone or as a chain
};

// The rays of each cause, rising.
std::array<std::vector<uint32_t>, kCauseCount> raysByCause(std::span<const RayTruth> truths) {
  std::array<std::vector<uint32_t>, kCauseCount> rays;
  for (uint32_t i = 0; i < truths.size(); ++i)
    if (truths[i].cause != kCauseNone) rays[truths[i].cause].push_back(i);
  return rays;
}

bool sameHit(const Hit& a, const Hit& b) { return a.kind == b.kind && a.t == b.t && a.reference == b.reference; }

// Where along the ray a record departs from the one before it: the start of its first step that is another one; where one just goes on
// longer, or only the hit is another one, of the last step that both have. kFar: nowhere.
float departure(const RayRecord& before, const RayRecord& after) {
  const auto [one, other] = std::ranges::mismatch(before.steps, after.steps);
  const bool oneEnds = one == before.steps.end(), otherEnds = other == after.steps.end();
  if (oneEnds && otherEnds && sameHit(before.hit, after.hit)) return kFar;
  if (!oneEnds && !otherEnds) return std::min(one->start, other->start);
  return other == after.steps.begin() ? 0.0f : std::prev(other)->start;
}

// What one ray's proof is after. Of a hit of this trace: that the ray agrees; the next event is the edited record's. Of a foreign hit: that
// the trace ends with it; the next event is the next rule by which the two differ.
struct Prover {
  const TruthInput& input;
  const Ray& ray;
  const Hit& traced;
  const Hit& exact;
  const RayRecord own = recordRay(input.trace, ray);
  const bool foreign = !endsAlike(traced, own.hit, input.trace.grid.parameters);

  bool reached(const RayRecord& record) const {
    const GridParameters& grid = input.trace.grid.parameters;
    return foreign ? endsAlike(traced, record.hit, grid) : judge(record.hit, exact, grid) == kVerdictAgrees;
  }
  TruthEvent firstEvent(const RayRecord& record) const {
    return foreign ? findForeignEvent(input, ray, traced, record.hit) : findEvent(input, ray, record, exact);
  }
  // Only rules can make a foreign hit again.
  bool canRemove(const TruthEvent& event) const {
    if (event.cause == kCauseNumeric) return false;
    return !foreign || event.cause == kCauseAlpha || event.cause == kCauseSelfHit;
  }
  // An event that was removed must be gone: what comes first then is another one, and not earlier than where the ray went another way.
  bool follows(const TruthEvent& next, const TruthEvent& before, float departed) const {
    return next != before && (foreign || next.along >= departed);
  }

  Proof prove(const TruthEvent& given) const {
    Proof proof{.confirmed = false, .foreign = foreign, .links = {given}, .hit = own.hit};
    RayRecord record = own;
    TruthEvent first = firstEvent(record);
    while (canRemove(proof.links.back())) {
      RayRecord edited = recordWithout(input.trace, ray, proof.links);
      const float departed = departure(record, edited);
      if (departed == kFar) break;
      proof.hit = edited.hit;
      proof.confirmed = reached(edited);
      if (proof.confirmed || proof.links.size() == kMostProofLinks) break;
      const TruthEvent next = firstEvent(edited);
      if (!follows(next, first, departed) || std::ranges::find(proof.links, next) != proof.links.end()) break;
      proof.links.push_back(next);
      record = std::move(edited);
      first = next;
    }
    return proof;
  }
};

}  // namespace

Proof proveRay(const TruthInput& input, const Ray& ray, const Hit& traced, const Hit& exact, const RayTruth& truth) {
  if (truth.cause == kCauseNone) return {};
  return Prover{input, ray, traced, exact}.prove(eventOf(truth));
}

ProofTotals::Count ProofTotals::sum() const {
  Count sum;
  for (const Count& count : causes) {
    sum.alone += count.alone;
    sum.chain += count.chain;
    sum.total += count.total;
    sum.controlConfirmed += count.controlConfirmed;
    sum.controlChained += count.controlChained;
    sum.controlTotal += count.controlTotal;
  }
  return sum;
}

ProofTotals proveFrame(const TruthInput& input, const ProofRays& frame, const TruthProgress& progress) {
  const std::span<const RayTruth> truths = frame.truths;
  CHECK_EQ(truths.size(), frame.rays.size());
  CHECK_EQ(frame.hits.size(), frame.rays.size());
  CHECK_EQ(frame.exact.size(), frame.rays.size());
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
      const Prover prover{input, frame.rays[ray], frame.hits[ray], frame.exact[ray]};
      const Proof proof = prover.prove(eventOf(truths[ray]));
      proofs[i].confirmed = proof.confirmed;
      proofs[i].links = uint16_t(proof.links.size());
      const std::vector<uint32_t>& others = byCause[truths[ray].cause];
      if (others.size() < 2) continue;
      uint32_t other = others[draw(ray, uint32_t(others.size() - 1))];
      if (other == ray) other = others.back();
      const Proof control = prover.prove(eventOf(truths[other]));
      proofs[i].controlled = true;
      proofs[i].controlConfirmed = control.confirmed;
      proofs[i].controlAlone = control.confirmed && control.links.size() == 1;
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
    count.controlConfirmed += proof.controlAlone ? 1 : 0;
    count.controlChained += proof.controlConfirmed ? 1 : 0;
    if (proof.confirmed)
      totals.mostLinks = std::max<uint64_t>(totals.mostLinks, proof.links);
    else
      totals.notConfirmed.push_back(todo[i]);
  }
  return totals;
}

}  // namespace gridscope
