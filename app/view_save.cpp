// See view_save.h.
#include "app/view_save.h"

#include <algorithm>
#include <filesystem>

#include "app/report.h"
#include "core/error.h"
#include "core/image_file.h"
#include "views/view.h"

namespace gridscope {

std::string saveView(const WindowModel& model, const std::string& name) {
  const View* view = findView(name);
  if (!view || !model.frame || !model.frame->views.contains(name)) throw Error(name + ": this view is not shown yet");
  const FrameSnapshot& frame = *model.frame;
  const Pipeline::ViewImage& image = *frame.views.at(name);
  const auto pane = std::ranges::find(model.panes, name, &Pane::view);
  const FrameSettings& settings = *frame.request.settings;
  const GridParameters& grid = frame.parameters.grid;
  const SliceSettings& slice = frame.request.slice;
  const ViewPictureSettings picture{.range = pane != model.panes.end() ? pane->range : std::nullopt,
                                    .colourMap = model.colourMap,
                                    .capacity = uint32_t(grid.capacity),
                                    .lines = {frame.scene->name + ": " + gridText(grid), refusedFirst(settings.grid)},
                                    .frameWidth = settings.width,
                                    .frameHeight = settings.height,
                                    .sliceAxis = slice.axis,
                                    .sliceIndex = slice.index < 0 ? grid.cellCount[slice.axis] / 2 : slice.index,
                                    .sliceCount = grid.cellCount[slice.axis]};
  const std::string file = std::filesystem::path(frame.scene->name).stem().string() + "_" + name + ".png";
  writePng(file, makeViewPicture(*view, image.elements, image.width, image.height, picture).picture);
  return file;
}

}  // namespace gridscope
