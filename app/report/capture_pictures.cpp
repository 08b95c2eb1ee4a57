// See capture_pictures.h.
#include "app/report/capture_pictures.h"

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/capture/compare.h"
#include "shaders/shared/views/element_colour.h"
#include "views/picture.h"

namespace gridscope {

namespace {

constexpr uint32_t kGap = 4;  // pixels between the two sides of a strip

// Elements of both sides over one area, and where they differ.
struct Elements {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<ViewElement> a, b;
  std::vector<bool> different;
};

ViewElement hitElement(const Hit& hit) {
  if (hit.kind == kHitTriangle) return valueElement(hit.t);
  return hit.kind == kHitVoxel ? markedElement(hit.t) : noElement();
}

Elements hitElements(const TwoSides& sides) {
  Elements elements{.width = sides.width, .height = sides.height, .a = {}, .b = {}, .different = {}};
  for (size_t i = 0; i < sides.hitsA.size(); ++i) {
    elements.a.push_back(hitElement(sides.hitsA[i]));
    elements.b.push_back(hitElement(sides.hitsB[i]));
    elements.different.push_back(std::memcmp(&sides.hitsA[i], &sides.hitsB[i], sizeof(Hit)) != 0);
  }
  return elements;
}

// The layer across y that holds the first difference, seen from above.
Elements gridElements(const TwoSides& sides) {
  const ivec3 count = sides.gridA.parameters.cellCount;
  const NumberedScene none;
  const Difference difference = compareGrids(sides.gridA, sides.gridB, {"a", "b", none});
  const int layer = cellOfWord(sides.gridA.parameters, difference.firstIndex).y;

  Elements elements{.width = uint32_t(count.x), .height = uint32_t(count.z), .a = {}, .b = {}, .different = {}};
  for (int z = 0; z < count.z; ++z)
    for (int x = 0; x < count.x; ++x) {
      const ivec3 cell(x, layer, z);
      const CellFacts a = cellFacts(sides.gridA, cell), b = cellFacts(sides.gridB, cell);
      const auto element = [&](const CellFacts& facts) {
        return facts.saturated ? markedElement(float(facts.stored)) : valueElement(float(facts.stored));
      };
      elements.a.push_back(element(a));
      elements.b.push_back(element(b));
      elements.different.push_back(a != b || storedIn(sides.gridA, cell) != storedIn(sides.gridB, cell));
    }
  return elements;
}

Picture coloured(const Elements& elements, const std::vector<ViewElement>& side, ValueRange range) {
  const View view{.name = "difference", .title = "", .unit = "", .about = "", .scope = ViewScope::ray};
  return makeViewPicture(view, side, elements.width, elements.height, {.range = range, .legend = false}).picture;
}

void setPixel(Picture& picture, size_t index, uint32_t colour) {
  for (uint32_t channel = 0; channel < 3; ++channel) picture.rgba[4 * index + channel] = static_cast<uint8_t>(colour >> (16 - 8 * channel));
}

Picture besides(const Picture& a, const Picture& b) {
  Picture strip = makePicture(a.width + kGap + b.width, std::max(a.height, b.height), kColourWindow);
  for (uint32_t y = 0; y < a.height; ++y)
    std::copy_n(&a.rgba[size_t{4} * y * a.width], size_t{4} * a.width, &strip.rgba[size_t{4} * y * strip.width]);
  for (uint32_t y = 0; y < b.height; ++y)
    std::copy_n(&b.rgba[size_t{4} * y * b.width], size_t{4} * b.width, &strip.rgba[4 * (size_t{y} * strip.width + a.width + kGap)]);
  return strip;
}

// Each pixel as a square of them: layers of few cells are hard to see.
Picture enlarged(const Picture& picture) {
  const uint32_t factor = std::clamp(192u / std::max(picture.width, 1u), 1u, 16u);
  Picture large = makePicture(picture.width * factor, picture.height * factor, kColourWindow);
  for (size_t i = 0; i < size_t{large.width} * large.height; ++i) {
    const size_t x = i % large.width / factor, y = i / large.width / factor;
    std::copy_n(&picture.rgba[4 * (y * picture.width + x)], 4, &large.rgba[4 * i]);
  }
  return large;
}

}  // namespace

DifferencePictures drawDifference(const TwoSides& sides) {
  const Elements elements = sides.hitsA.empty() ? gridElements(sides) : hitElements(sides);
  const View view{.name = "difference", .title = "", .unit = "", .about = "", .scope = ViewScope::ray, .range = ViewRange::automatic};
  const ValueRange range = viewRange(view, elements.a, 0);
  const Picture a = coloured(elements, elements.a, range), b = coloured(elements, elements.b, range);

  // A in dark grey, and what differs on it.
  Picture difference = a;
  for (size_t i = 0; i < elements.different.size(); ++i) {
    const uint32_t grey = (a.rgba[4 * i] + a.rgba[4 * i + 1] + a.rgba[4 * i + 2]) / 6;
    setPixel(difference, i, elements.different[i] ? kColourHole : grey << 16 | grey << 8 | grey);
  }
  return {enlarged(difference), besides(enlarged(a), enlarged(b))};
}

std::vector<std::string> writeDifference(const std::filesystem::path& folder, const std::string& name, const TwoSides& sides) {
  // Counters alone have no picture.
  if (sides.hitsA.empty() && (sides.gridA.empty() || sides.gridB.empty())) return {};
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault) throw Error("--out " + folder.string() + ": can't be made: " + fault.message());
  const DifferencePictures pictures = drawDifference(sides);
  const std::vector<std::string> files = {(folder / (name + ".difference.png")).string(), (folder / (name + ".ab.png")).string()};
  writePng(files[0], pictures.difference);
  writePng(files[1], pictures.strip);
  return files;
}

TwoSides sidesOf(const Capture& capture, const DifferentFrame& different) {
  const CaptureFrame& captured = capture.frames[different.frame];
  TwoSides sides{.hitsA = {}, .hitsB = {}, .gridA = {capture.grid, captured.grid}, .gridB = {capture.grid, different.grid}};
  sides.width = capture.settings.width, sides.height = capture.settings.height;
  const bool hitsDiffer = captured.hits.size() == different.hits.size() &&
                          std::memcmp(captured.hits.data(), different.hits.data(), captured.hits.size() * sizeof(Hit)) != 0;
  if (hitsDiffer || different.grid.empty() || captured.grid.empty()) sides.hitsA = captured.hits, sides.hitsB = different.hits;
  if (sides.hitsA.size() != sides.hitsB.size()) sides.hitsA.clear(), sides.hitsB.clear();
  return sides;
}

std::string pictureName(const std::filesystem::path& file) {
  std::string name = std::filesystem::path(file).replace_extension().relative_path().generic_string();
  while (name.starts_with("../")) name.erase(0, 3);
  std::ranges::replace(name, '/', '_');
  return name;
}

}  // namespace gridscope
