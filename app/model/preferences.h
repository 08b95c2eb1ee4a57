// What the window keeps between runs: splits, theme, scale, recent files, bookmarks by scene. In the platform's usual place.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "app/model/window_model.h"

namespace gridscope {

// $XDG_CONFIG_HOME/gridscope/window.json, or ~/.config/gridscope/window.json; empty: there is no home.
std::filesystem::path preferencesFile();

// Takes what the file holds over into the model; a file that is missing or damaged changes nothing.
void readPreferences(WindowModel& model, const std::filesystem::path& file = preferencesFile());

// What the file would hold now.
std::string preferencesText(const WindowModel& model);

// Quietly does nothing where the file can't be written.
void writePreferences(const std::string& text, const std::filesystem::path& file = preferencesFile());

// Writes the preferences a few seconds after they changed, so that a program that is killed loses little, and at its end.
class PreferenceKeeper {
 public:
  explicit PreferenceKeeper(const WindowModel& model, std::filesystem::path file = preferencesFile())
      : file_(std::move(file)), written_(preferencesText(model)) {}
  void look(const WindowModel& model);  // once a display frame; model.now says when
  void end(const WindowModel& model);

 private:
  std::filesystem::path file_;
  std::string written_;
  double looked_ = 0.0;  // seconds, as model.now
};

}  // namespace gridscope
