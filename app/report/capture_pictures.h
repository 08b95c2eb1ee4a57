// Pictures of captured and replayed products: previews, what differs, and two sides in one strip.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/image_file.h"
#include "core/capture/capture.h"
#include "core/checks/replay.h"

namespace gridscope {

// A frame's product on either side: hits of both, or else grids of both.
struct TwoSides {
  std::vector<Hit> hitsA, hitsB;
  Grid gridA, gridB;
  uint32_t width = 0;  // of the hits
  uint32_t height = 0;
};

// Distance of the hits where hits differ, else the layer of cells with the first difference. `difference`: orange where the sides differ,
// over A in grey; `strip`: A on the left, B on the right, one range.
struct DifferencePictures {
  Picture difference;
  Picture strip;
};
DifferencePictures drawDifference(const TwoSides& sides);

// The two pictures of a replay that differs, as FOLDER/NAME.difference.png and NAME.ab.png; returns their paths; none
// where neither hits nor grids are on both sides.
std::vector<std::string> writeDifference(const std::filesystem::path& folder, const std::string& name, const TwoSides& sides);
TwoSides sidesOf(const Capture& capture, const DifferentFrame& different);

// `a.b_c` for the path a.b/c.gridcap: one name a file, whatever its folder.
std::string pictureName(const std::filesystem::path& file);

}  // namespace gridscope
