// See trace_stages.h.
#include "core/gpu/trace_stages.h"

#include <algorithm>
#include <bit>

#include "shaders/shared/gpu/bindings.h"

namespace gridscope {
namespace {

constexpr uint32_t kMostRaysPerDispatch = 65535 * 64;  // 65,535 workgroups of 64: what every device takes

float asFloat(uint32_t word) { return std::bit_cast<float>(word); }

// Reads what trace_record.comp wrote.
RayRecord decodeRecord(const RayRecordHeader& header, std::span<const uint32_t> words) {
  RayRecord record;
  record.hit = header.hit;
  for (size_t at = 0; at < words.size();) {
    const uint32_t* w = &words[at];
    switch (w[0]) {
      case kRecordSegment:
        record.steps.push_back(
            {.segment = int32_t(w[1]), .start = asFloat(w[2]), .cell = {int(w[3]), int(w[4]), int(w[5])}, .outcome = w[6]});
        at += 7;
        break;
      case kRecordTest:
        record.steps.back().tests.push_back({.slot = w[1], .reference = w[2], .verdict = w[3], .t = asFloat(w[4]), .alphaByte = w[5]});
        at += 6;
        break;
      case kRecordCell:
        record.steps.back().stored = int32_t(w[1]);
        record.steps.back().saturated = w[2] != 0;
        record.steps.back().travel = asFloat(w[3]);
        at += 4;
        break;
      default: CHECK_EQ(w[0], kRecordSegment);
    }
  }
  return record;
}

void throwCut(const std::string& what) {
  throw Error("trace: " + what + ": the driver cut loops short; use a smaller --capacity, or --device cpu", kExitDevice);
}

}  // namespace

TraceStages::TraceStages(GpuPrograms& programs) : programs_(programs) {
  programs.bound().makeBuffer(kBindTraceReport, "trace report", 2 * sizeof(uint32_t));
}

void TraceStages::makeTargets(uint64_t rayCount) {
  BoundResources& bound = programs_.bound();
  bound.makeBuffer(kBindRays, "rays", rayCount * sizeof(Ray));
  bound.makeBuffer(kBindHits, "hits", rayCount * sizeof(Hit));
  bound.makeBuffer(kBindCounters, "counters", rayCount * sizeof(RayCounters));
  bound.makeBuffer(kBindTraceStates, "trace states", rayCount * sizeof(TraceState));
}

void TraceStages::setParameters(const TraceParameters& trace) {
  trace_ = trace;
  programs_.specialize({{kConstantTraversal, trace.traversal}});
}

// As many passes as the segments of the longest ray need; a pass after the first takes only the rays that are not done.
double TraceStages::trace(uint32_t firstRay, uint32_t endRay, bool counting) {
  const std::string stem = counting ? "trace_counting" : "trace";
  uint32_t segments = trace_.maxSegments + 2;  // it may take one more to say "limit"
  uint32_t passes = (segments + trace_.segmentsPerPass - 1) / trace_.segmentsPerPass;
  double time = 0.0;
  for (uint32_t pass = 0; pass < std::max(passes, 1u); ++pass) {
    GpuCommands commands(programs_.gpu());
    programs_.zero(commands, kBindTraceReport);
    commands.pass(stem, [&] {
      for (uint32_t first = firstRay; first < endRay; first += kMostRaysPerDispatch) {
        TraceArguments arguments{first, first + std::min(kMostRaysPerDispatch, endRay - first), pass > 0};
        programs_.dispatch(commands, stem, {int(arguments.endRay - first), 1, 1}, bytesOf(arguments));
      }
    });
    time += commands.run()[stem];
    std::vector<uint32_t> report = programs_.read<uint32_t>(kBindTraceReport, 2);
    if (report[1] > 0) throwCut(std::to_string(report[1]) + " rays ended without a reason");
    if (report[0] == 0) return time;
    if (pass + 1 >= passes) throwCut(std::to_string(report[0]) + " rays were not finished after " + std::to_string(passes) + " passes");
  }
  return time;
}

RayRecord TraceStages::record(uint32_t pixel) {
  uint32_t capacity = 1u << 16;
  for (;;) {
    RayRecordHeader header{};
    header.wordCapacity = capacity;
    const GpuBuffer& buffer =
        programs_.bound().makeBuffer(kBindRayRecord, "ray record", sizeof(RayRecordHeader) + uint64_t(capacity) * sizeof(uint32_t));
    uploadBytes(programs_.gpu(), buffer, bytesOf(header));
    TraceArguments arguments{pixel, pixel + 1, 0};
    do {
      GpuCommands commands(programs_.gpu());
      programs_.dispatch(commands, "trace_record", {1, 1, 1}, bytesOf(arguments));
      commands.barrier();
      commands.run();
      header = programs_.read<RayRecordHeader>(kBindRayRecord, 1)[0];
      arguments.continues = 1;
    } while (header.hit.kind == kHitUnfinished);
    if (header.hit.kind == kHitCut) throwCut("the recorded ray ended without a reason");
    if (header.wordCount <= capacity) {
      std::vector<uint32_t> words(header.wordCount);
      downloadBytes(programs_.gpu(), buffer, std::as_writable_bytes(std::span(words)), sizeof(RayRecordHeader));
      return decodeRecord(header, words);
    }
    capacity = header.wordCount;
  }
}

}  // namespace gridscope
