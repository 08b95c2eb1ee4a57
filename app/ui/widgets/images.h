// Pictures inside the interface: textures by key, drawn from ImGui's draw lists (the packaged ImGui backend knows no texture but its font's).
// The window gives them; widgets know nothing of the device.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <span>
#include <string>

namespace gridscope {

class WindowImages {
 public:
  virtual ~WindowImages() = default;

  // Replaces the picture of `key`: width x height of sRGB bytes RGBA, first row at the top.
  virtual void set(const std::string& key, uint32_t width, uint32_t height, std::span<const uint8_t> rgba) = 0;

  // Adds the picture to a draw list: screen rectangle `low` to `high` shows its part `uvLow` to `uvHigh`, cut by the clip rectangle. Nothing
  // where there is no such key.
  virtual void draw(ImDrawList& list, const std::string& key, ImVec2 low, ImVec2 high, ImVec2 uvLow, ImVec2 uvHigh) = 0;
};

// The window's; set before the first frame.
WindowImages*& windowImages();

}  // namespace gridscope
