// See preferences.h.
#include "app/model/preferences.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <nlohmann/json.hpp>

namespace gridscope {

using nlohmann::json;

static json vectorJson(const vec3& v) { return {v.x, v.y, v.z}; }

static vec3 vectorOf(const json& value) {
  const vec3 v(value.at(0).get<float>(), value.at(1).get<float>(), value.at(2).get<float>());
  if (!std::isfinite(v.x + v.y + v.z)) throw json::other_error::create(501, "not finite", nullptr);
  return v;
}

std::filesystem::path preferencesFile() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path folder;
  if (config && *config)
    folder = config;
  else if (home && *home)
    folder = std::filesystem::path(home) / ".config";
  else
    return {};
  return folder / "gridscope" / "window.json";
}

void readPreferences(WindowModel& model, const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return;
  const json saved = json::parse(in, nullptr, false);
  if (!saved.is_object()) return;
  try {
    model.splits.left = std::clamp(saved.value("left", model.splits.left), 100.0f, 1000.0f);
    model.splits.right = std::clamp(saved.value("right", model.splits.right), 100.0f, 1000.0f);
    model.splits.bottom = std::clamp(saved.value("bottom", model.splits.bottom), 50.0f, 1200.0f);
    model.uiScale = std::clamp(saved.value("uiScale", 1.0f), 0.5f, 3.0f);
    model.theme = saved.value("theme", "dark") == "light" ? Theme::light : Theme::dark;
    model.colourMap = std::min(saved.value("colourMap", 0u), kColourMapCount - 1);
    model.recentFiles = saved.value("recentFiles", std::vector<std::string>());
    const json bookmarks = saved.value("bookmarks", json::object());
    for (const auto& [scene, list] : bookmarks.items())
      for (const json& one : list)
        model.savedBookmarks[scene].push_back({one.at("name").get<std::string>(),
                                               {.name = one.at("name").get<std::string>(),
                                                .eye = vectorOf(one.at("eye")),
                                                .target = vectorOf(one.at("target")),
                                                .up = vectorOf(one.at("up")),
                                                .verticalFovDegrees = std::clamp(one.at("fov").get<float>(), 1.0f, 170.0f)}});
  } catch (const json::exception&) {
    // What was read before the damage stands.
  }
}

std::string preferencesText(const WindowModel& model) {
  json bookmarks = json::object();
  for (const auto& [scene, list] : model.savedBookmarks)
    for (const Bookmark& one : list)
      bookmarks[scene].push_back({{"name", one.name},
                                  {"eye", vectorJson(one.pose.eye)},
                                  {"target", vectorJson(one.pose.target)},
                                  {"up", vectorJson(one.pose.up)},
                                  {"fov", one.pose.verticalFovDegrees}});
  const json saved = {{"left", model.splits.left},
                      {"right", model.splits.right},
                      {"bottom", model.splits.bottom},
                      {"uiScale", model.uiScale},
                      {"theme", model.theme == Theme::light ? "light" : "dark"},
                      {"colourMap", model.colourMap},
                      {"recentFiles", model.recentFiles},
                      {"bookmarks", bookmarks}};
  return saved.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

void writePreferences(const std::string& text, const std::filesystem::path& file) {
  if (file.empty()) return;
  std::error_code fault;
  std::filesystem::create_directories(file.parent_path(), fault);
  const std::filesystem::path temporary = file.string() + ".new";
  {
    std::ofstream out(temporary);
    out << text;
    if (!out) return;
  }
  std::filesystem::rename(temporary, file, fault);
}

void PreferenceKeeper::look(const WindowModel& model) {
  constexpr double kSeconds = 3.0;  // between two looks
  if (model.now - looked_ < kSeconds) return;
  looked_ = model.now;
  end(model);
}

void PreferenceKeeper::end(const WindowModel& model) {
  std::string text = preferencesText(model);
  if (text == written_) return;
  writePreferences(text, file_);
  written_ = std::move(text);
}

}  // namespace gridscope
