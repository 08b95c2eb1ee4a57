// Runs a capture's stages again from its inputs and compares every product that it holds, integers and the bits of floats exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/capture/capture.h"
#include "core/gpu/context.h"

namespace gridscope {

// Where a replay begins. Rays are always the captured ones: the bounce may differ by rounding between drivers and is not run again.
enum class ReplayFrom {
  automatic,  // build where this program built the grid; else trace
  build,      // the static instances, then every frame's update in turn
  update,     // frame k from the captured grid of frame k - 1
  trace,      // from the captured grid
};

enum class Verdict {
  equal,
  different,
  unusable,     // there is nothing that could be compared, or the file can't be read
  unsupported,  // the device can't do it
};
const char* verdictName(Verdict verdict);

// One product over all frames and repetitions.
struct ReplayedProduct {
  std::string name;        // "grid", "hits", "counters", "exact"
  uint64_t different = 0;  // elements: words of the grid (first-come: cells), pixels; of the repetition where most differ
  uint64_t total = 0;      // compared
  std::string first;       // the first difference in words; empty: all equal
  uint32_t distinct = 1;   // results among the repetitions
};

// Products of the first frame in which something differs, as the replay made them; empty where it does not make them.
struct DifferentFrame {
  size_t frame = 0;
  std::vector<uint32_t> grid;
  std::vector<Hit> hits;
};

struct ReplayResult {
  Verdict verdict = Verdict::equal;
  std::string reason;  // why unusable or unsupported
  std::string device;  // that ran the stages
  std::vector<ReplayedProduct> products;
  std::optional<DifferentFrame> different;
};

struct ReplayOptions {
  ReplayFrom from = ReplayFrom::automatic;
  uint32_t repeat = 1;  // runs; with more, results that are not the same in each are different too
};

// gpu: the device, which must pass the self-test (whyUnsupported() is empty); nullptr: in C++, without Vulkan. Throws Error.
ReplayResult replay(const Capture& capture, const ReplayOptions& options, GpuContext* gpu);

// Why a device gives no verdict: its self-test fails. Empty: it does. Takes about a second.
std::string whyUnsupported(GpuContext& gpu);

// Why a capture can't be replayed from there; empty: it can.
std::string whyNotFrom(const Capture& capture, ReplayFrom from);

}  // namespace gridscope
