// What the window's model says and remembers (window_model.h).
#include <cstdio>

#include "app/model/window_model.h"

namespace gridscope {

static constexpr size_t kMostLogLines = 5000;
static constexpr size_t kMostUndo = 200;
static constexpr double kToastSeconds = 4.0, kErrorToastSeconds = 8.0;

void WindowModel::say(LogLine::Kind kind, std::string text) {
  if (logToStandardError || kind == LogLine::Kind::error) std::fprintf(stderr, "%s\n", text.c_str());
  log.push_back({kind, now, std::move(text)});
  if (log.size() > kMostLogLines) log.pop_front();
}

void WindowModel::announce(LogLine::Kind kind, std::string text) {
  toast = text;
  toastUntil = now + (kind == LogLine::Kind::note ? kToastSeconds : kErrorToastSeconds);
  say(kind, std::move(text));
}

void WindowModel::changeSettings(const std::function<void(FrameSettings&)>& change) {
  if (!request.settings) return;
  rememberForUndo(*request.settings);
  change(*request.settings);
}

void WindowModel::rememberForUndo(const FrameSettings& settings) {
  undo.push_back(settings);
  if (undo.size() > kMostUndo) undo.erase(undo.begin());
}

}  // namespace gridscope
