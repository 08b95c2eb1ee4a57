// See view_save.h.
#include "app/frame/view_save.h"

#include <algorithm>
#include <filesystem>

#include "app/base/text.h"
#include "app/report/report.h"
#include "core/base/image_file.h"
#include "views/view.h"

namespace gridscope {

void saveView(WindowModel& model, const std::string& name) {
  const View* view = findView(name);
  if (!view || !model.frame || !model.frame->views.contains(name))
    return model.showMessage(viewLabel(name) + ": this view is not shown yet");
  const std::shared_ptr<const FrameSnapshot> frame = model.frame;
  const auto pane = std::ranges::find(model.panes, name, &Pane::view);
  const FrameSettings& settings = *frame->request.settings;
  const GridParameters& grid = frame->parameters.grid;
  const SliceSettings& slice = frame->request.slice;
  const ViewPictureSettings picture{.range = pane != model.panes.end() ? pane->range : std::nullopt,
                                    .colourMap = model.colourMap,
                                    .capacity = uint32_t(grid.capacity),
                                    .lines = {frame->scene->name + ": " + gridText(grid), refusedFirst(settings.grid)},
                                    .frameWidth = settings.width,
                                    .frameHeight = settings.height,
                                    .sliceAxis = slice.axis,
                                    .sliceIndex = slice.index < 0 ? grid.cellCount[slice.axis] / 2 : slice.index,
                                    .sliceCount = grid.cellCount[slice.axis]};
  const std::filesystem::path file = model.files.claim(std::filesystem::path(frame->scene->name).stem().string() + "_" + name + ".png");
  model.files.start([view, picture, file, image = frame->views.at(name)] {
    writePng(file.string(), makeViewPicture(*view, image->elements, image->width, image->height, picture).picture);
    return "Wrote " + file.string();
  });
}

}  // namespace gridscope
