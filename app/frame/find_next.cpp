// See find_next.h.
#include "app/frame/find_next.h"

#include <algorithm>

namespace gridscope {

namespace {

// The order of the rays, and where `from` stands in it.
class RayWalk {
 public:
  RayWalk(const FrameSnapshot& frame, std::span<const uint32_t> order, std::optional<uint32_t> from)
      : order_(order), count_(order.empty() ? frame.pixelCount() : order.size()) {
    if (!from) return;
    if (order.empty()) {
      if (*from < count_) at_ = *from;
    } else if (const auto found = std::find(order.begin(), order.end(), *from); found != order.end()) {
      at_ = size_t(found - order.begin());
    }
  }

  // The first pixel that `accepts` takes, going forward or back from behind the start; the start itself comes last.
  template <typename Accepts>
  std::optional<uint32_t> first(bool forward, const Accepts& accepts) const {
    const size_t start = at_.value_or(forward ? count_ - 1 : 0);
    for (size_t step = 1; step <= count_; ++step) {
      const size_t place = forward ? (start + step) % count_ : (start + count_ - step) % count_;
      const uint32_t pixel = order_.empty() ? static_cast<uint32_t>(place) : order_[place];
      if (accepts(pixel)) return pixel;
    }
    return std::nullopt;
  }

 private:
  std::span<const uint32_t> order_;
  size_t count_;
  std::optional<size_t> at_;
};

// Where the rays of a picture are looked at first.
std::optional<uint32_t> middlePixel(const FrameSnapshot& frame) {
  if (!frame.request.settings) return std::nullopt;
  const FrameSettings& settings = *frame.request.settings;
  return settings.height / 2 * settings.width + settings.width / 2;
}

bool isRay(const FrameSnapshot& frame, uint32_t pixel) {
  return frame.hits && pixel < frame.hits->size() && (*frame.hits)[pixel].kind != kHitNoRay;
}

}  // namespace

std::optional<uint32_t> nextRay(const FrameSnapshot& frame, std::span<const uint32_t> order, std::optional<uint32_t> from,
                                const RayWanted& wanted) {
  if (wanted.asksForTruth() && !frame.truths) return std::nullopt;
  if (!from && order.empty()) from = middlePixel(frame);
  return RayWalk(frame, order, from).first(true, [&](uint32_t pixel) {
    if (!isRay(frame, pixel)) return false;
    if (wanted.kind && (*frame.hits)[pixel].kind != *wanted.kind) return false;
    if (!wanted.asksForTruth()) return true;
    if (pixel >= frame.truths->size()) return false;
    const RayTruth& truth = (*frame.truths)[pixel];
    return (!wanted.verdict || truth.verdict == *wanted.verdict) && (!wanted.cause || truth.cause == *wanted.cause);
  });
}

std::optional<uint32_t> nextHole(const FrameSnapshot& frame, std::span<const uint32_t> order, std::optional<uint32_t> from) {
  return nextRay(frame, order, from, {.verdict = kVerdictHole});
}

std::optional<uint32_t> nextVoxelWrong(const FrameSnapshot& frame, std::span<const uint32_t> order, std::optional<uint32_t> from) {
  return nextRay(frame, order, from, {.verdict = kVerdictVoxelWrong});
}

std::optional<uint32_t> neighbourRay(const FrameSnapshot& frame, std::span<const uint32_t> order, std::optional<uint32_t> from,
                                     int places) {
  std::optional<uint32_t> pixel = from;
  for (int step = 0; step < std::abs(places); ++step)
    pixel = RayWalk(frame, order, pixel).first(places > 0, [&](uint32_t candidate) { return isRay(frame, candidate); });
  return pixel;
}

}  // namespace gridscope
