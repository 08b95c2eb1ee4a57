// Values that are of a request before keep their place at half opacity.
#pragma once

#include <imgui.h>

#include "app/model/window_model.h"

namespace gridscope {

// What is drawn while it lives is at half opacity, if `stale`.
class StaleDim {
 public:
  explicit StaleDim(bool stale) : stale_(stale) {
    if (stale_) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f * ImGui::GetStyle().Alpha);
  }
  ~StaleDim() {
    if (stale_) ImGui::PopStyleVar();
  }
  StaleDim(const StaleDim&) = delete;
  StaleDim& operator=(const StaleDim&) = delete;

 private:
  bool stale_;
};

}  // namespace gridscope
