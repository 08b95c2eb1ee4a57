// What the window keeps between runs: splits, theme, scale, recent files, bookmarks by scene. In the platform's usual place.
#pragma once

#include <filesystem>

#include "app/window_model.h"

namespace gridscope {

// $XDG_CONFIG_HOME/gridscope/window.json, or ~/.config/gridscope/window.json; empty: there is no home.
std::filesystem::path preferencesFile();

// Takes what the file holds over into the model; a file that is missing or damaged changes nothing.
void readPreferences(WindowModel& model, const std::filesystem::path& file = preferencesFile());

// Quietly does nothing where the file can't be written.
void writePreferences(const WindowModel& model, const std::filesystem::path& file = preferencesFile());

}  // namespace gridscope
