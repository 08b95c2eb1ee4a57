// Everything that the window's frame depends on, as one value. The window changes it; the worker compares it with the one before and runs
// only the stages that a change feeds.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/pipeline/pipeline.h"
#include "core/scene/scene.h"
#include "core/trace/settings.h"

namespace gridscope {

// Where the frame comes from.
struct FrameSource {
  std::string scene = "hall";      // path of a .gltf, .glb or .gridcap, or a built-in scene's name
  uint32_t teapots = 0;            // added to the scene
  std::optional<uint32_t> moving;  // of the added teapots; all when not given
  std::string rays;                // path of a .npy file with rays of one's own; empty: the bounce makes them
  uint32_t loadCount = 0;          // raised to load the same source again
  bool operator==(const FrameSource&) const = default;
};

// What a person did to an instance of the scene. The static grid is built again, as after destruction in a game.
struct InstanceEdit {
  enum class Kind { hide, remove, makeDynamic };
  uint32_t sceneInstance = 0;
  Kind kind = Kind::hide;
  vec3 offset{0.0f};  // world units, of one made dynamic and dragged
  bool operator==(const InstanceEdit&) const = default;
};

struct FrameRequest {
  FrameSource source;
  std::optional<FrameSettings> settings;  // not given: the source's own, which the first snapshot then says
  std::vector<InstanceEdit> edits;
  uint32_t frame = 0;           // number of the frame: of a capture's sequence, and of the bounce's hash
  double timeSeconds = 0.0;     // of a scene's animations
  std::set<std::string> views;  // names of the views whose elements are wanted
  SliceSettings slice;
  bool truth = false;                   // exact hits, verdicts, causes and the ledger, in C++ on the worker: seconds
  std::optional<uint32_t> recordPixel;  // ray to record
  bool proveRecorded = false;           // prove the recorded ray's cause
  uint32_t proveAll = 0;                // raised: prove every ray's cause, once
  uint32_t shaderReloads = 0;           // raised by F5
};

}  // namespace gridscope
