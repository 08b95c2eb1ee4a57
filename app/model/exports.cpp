// See exports.h.
#include "app/model/exports.h"

#include <algorithm>
#include <filesystem>
#include <span>

#include "app/base/text.h"
#include "app/frame/sheet.h"
#include "app/session/settings_table.h"
#include "core/base/error.h"
#include "core/base/image_file.h"
#include "core/base/write_file.h"
#include "views/picture.h"
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

void exportCsv(WindowModel& model, const std::string& table, size_t rowCount, std::function<std::string()> csv) {
  const std::string scene = model.frame && model.frame->scene ? model.frame->scene->name : "scene";
  const std::filesystem::path file = model.files.claim(std::filesystem::absolute(csvName(scene, table)));
  model.files.start([file, rowCount, csv = std::move(csv)] {
    const std::string text = csv();
    try {
      writeWholeFile(file, std::as_bytes(std::span(text)));
    } catch (const Error& error) {
      throw error.within(file.string());
    }
    return "Exported " + grouped(rowCount) + (rowCount == 1 ? " row to " : " rows to ") + file.string();
  });
}

void exportCsv(WindowModel& model, const std::string& table, CsvRows rows) {
  const size_t rowCount = rows.size() - 1;
  exportCsv(model, table, rowCount, [rows = std::move(rows)] { return csvText(rows); });
}

}  // namespace gridscope
