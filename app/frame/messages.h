// What worker and window tell each other beside requests and snapshots: lines of the log, long work, captures to write.
#pragma once

#include <string>

namespace gridscope {

struct LogLine {
  enum class Kind { note, warning, error } kind = Kind::note;
  double seconds = 0.0;  // since the start
  std::string text;
  bool shown = false;  // for a moment over the viewport too: it answers what a person asked for
};

// Long work that the worker is doing.
struct LongWork {
  enum class Kind { source, grid, truth, shaders } kind = Kind::source;
  std::string what;      // "Loading sponza.glb"
  float share = 0.0f;    // 0..1; below 0: not known
  double seconds = 0.0;  // so far
};

// A capture to write of the frame that is shown.
struct CaptureWish {
  std::string file;
  std::string note;
};

}  // namespace gridscope
