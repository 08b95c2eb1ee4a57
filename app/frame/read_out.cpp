// See read_out.h.
#include "app/frame/read_out.h"

#include "app/base/text.h"
#include "app/frame/find_next.h"
#include "app/frame/view_paint.h"
#include "shaders/shared/grid/slice.h"

namespace gridscope {

static constexpr const char* kBetween = "  |  ";

std::vector<std::string> readOutParts(const FrameSnapshot& frame, const View& view, const Pipeline::ViewImage& image, uvec2 pixel) {
  const uint32_t index = pixel.y * image.width + pixel.x;
  const std::string value = elementText(image.elements[index], view.unit);
  const GridParameters& grid = frame.parameters.grid;
  if (view.scope == ViewScope::slice) {
    const SliceSettings& slice = frame.request.slice;
    const ivec3 cell = sliceCell(grid.cellCount, slice.axis, slice.index < 0 ? grid.cellCount[slice.axis] / 2 : slice.index, index);
    return {printed("cell %d, %d, %d", cell.x, cell.y, cell.z), value};
  }
  std::vector<std::string> parts{printed("pixel %u, %u", pixel.x, pixel.y)};
  if (view.range != ViewRange::none) parts.push_back(value);
  if (!frame.gather || index >= frame.gather->size()) return parts;
  const GatherPixel& seen = (*frame.gather)[index];
  if (seen.reference == kNoReference) {
    parts.push_back("nothing seen");
    return parts;
  }
  const ivec3 cell = gridCell(grid, seen.position);
  parts.push_back(printed("cell %d, %d, %d", cell.x, cell.y, cell.z));
  if (frame.scene && referenceInstance(seen.reference) < frame.scene->numbered.sources.size()) {
    const TriangleName name = nameTriangle(frame.scene->numbered, seen.reference);
    const std::string mesh = name.mesh < frame.scene->names.meshes.size() ? frame.scene->names.meshes[name.mesh] : "mesh";
    parts.push_back(mesh + ", triangle " + grouped(name.triangle));
  }
  parts.push_back(printed("depth %.3g", double(seen.depth)));
  return parts;
}

std::vector<std::string> readOutLines(const std::vector<std::string>& parts, size_t width, size_t most) {
  std::vector<std::string> lines;
  for (const std::string& part : parts) {
    if (!lines.empty() && lines.back().size() + std::char_traits<char>::length(kBetween) + part.size() <= width) {
      lines.back() += kBetween + part;
      continue;
    }
    if (lines.size() == most) break;
    lines.push_back(part);
  }
  return lines;
}

}  // namespace gridscope
