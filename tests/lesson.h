// A built-in lesson's scene and settings, at a size that a test can afford.
#pragma once

#include <string_view>

#include "core/scene/built_in_scenes.h"
#include "core/trace/settings.h"

namespace gridscope {

inline FrameSettings lessonSettings(const BuiltInScene& lesson, const Scene& scene, uint32_t width, uint32_t height) {
  FrameSettings settings;
  if (lesson.cells) settings.grid.cells = lesson.cells;
  if (lesson.cellEdge > 0.0f) settings.grid.cellEdge = lesson.cellEdge;
  if (lesson.capacity) settings.grid.capacity = lesson.capacity;
  if (lesson.ahead > 0.0f) settings.trace.ahead = lesson.ahead;
  settings.width = width;
  settings.height = height;
  settings.camera = defaultCamera(scene);
  settings.textureSize = 64;
  return settings;
}

}  // namespace gridscope
