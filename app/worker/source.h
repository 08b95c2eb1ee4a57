// Loading what the window shows: a scene or a capture, with the settings that it brings and the facts that panels want to know of it.
#pragma once

#include <future>
#include <memory>
#include <optional>

#include "app/frame/snapshot.h"
#include "app/session/options.h"

namespace gridscope {

struct LoadedSource {
  FrameSource source;
  Scene scene;  // of a capture: its name, materials and warnings alone
  std::optional<Capture> capture;
  FrameSettings settings;           // the source's own, with what the command line gave
  std::vector<Ray> rays;            // of the command line, instead of the bounce's; empty: none
  Bounds bounds;                    // of the scene over its whole animation
  std::vector<CameraPose> cameras;  // the file's, or the default one
  double duration = 0.0;            // seconds of the longest animation
};

// `start`: the command line, which goes with the source that it names. Throws Error.
LoadedSource loadSource(const FrameSource& source, const Options& start);

// The same on a thread of its own that nobody must wait for. loadsUnderWay(): how many such threads have not ended; while there are any, the
// process must not take down what they use.
std::future<LoadedSource> loadAside(const FrameSource& source, const Options& start);
uint32_t loadsUnderWay();

// The source that a command line names.
FrameSource sourceOf(const Options& options);

// Facts without the numbered scene.
SceneFacts factsOf(const LoadedSource& loaded);

}  // namespace gridscope
