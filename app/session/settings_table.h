// Every setting of a frame as the command line names it, with its value and its default.
#pragma once

#include <string>
#include <vector>

#include "core/trace/settings.h"

namespace gridscope {

struct SettingText {
  std::string option;  // "--capacity"
  std::string value;
  std::string usual;  // the default; empty: it depends on the scene
  std::string about;  // a few words
  bool changed() const { return !usual.empty() && value != usual; }
};

std::vector<SettingText> settingTexts(const FrameSettings& settings);

// One sentence: what full cells refuse first under these settings.
std::string refusedFirst(const GridSettings& settings);

}  // namespace gridscope
