// See capture.h: the pieces of a captured frame.
#include <cstring>

#include "core/capture/capture.h"

namespace gridscope {

namespace {

void setRows(Instance& instance, const InstanceRows& rows) {
  instance.row0 = rows.row0;
  instance.row1 = rows.row1;
  instance.row2 = rows.row2;
}

}  // namespace

FrameParameters frameParameters(const Capture& capture, size_t frame) {
  CHECK_LT(frame, capture.frames.size());
  const CaptureFrame& captured = capture.frames[frame];
  return {capture.grid, capture.trace, captured.camera, captured.bounce, captured.view};
}

NumberedScene frameScene(const Capture& capture, size_t frame) {
  CHECK_LT(frame, capture.frames.size());
  NumberedScene scene = capture.scene;
  for (size_t i = 0; i < scene.instances.size(); ++i) setRows(scene.instances[i], capture.frames[frame].rows[i]);
  return scene;
}

Grid frameGrid(const Capture& capture, size_t frame) {
  CHECK_LT(frame, capture.frames.size());
  CHECK(!capture.frames[frame].grid.empty());
  return {capture.grid, capture.frames[frame].grid};
}

std::vector<uint32_t> movedInstances(const Capture& capture, size_t frame) {
  CHECK_LT(frame, capture.frames.size());
  std::vector<uint32_t> moved;
  for (uint32_t i = capture.scene.staticInstanceCount; i < capture.scene.instanceCount(); ++i) {
    const auto rowsIn = [&](size_t f) { return &capture.frames[f].rows[i]; };
    if (frame == 0 || std::memcmp(rowsIn(frame), rowsIn(frame - 1), sizeof(InstanceRows)) != 0) moved.push_back(i);
  }
  return moved;
}

std::vector<InstanceRows> rowsOf(std::span<const Instance> instances) {
  std::vector<InstanceRows> rows;
  rows.reserve(instances.size());
  for (const Instance& instance : instances) rows.push_back({instance.row0, instance.row1, instance.row2});
  return rows;
}

}  // namespace gridscope
