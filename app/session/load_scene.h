// From the SCENE argument and the options to a scene with its settings.
#pragma once

#include "app/session/options.h"
#include "core/scene/scene.h"

namespace gridscope {

struct LoadedScene {
  Scene scene;
  FrameSettings settings;  // complete, camera too
};

// Loads a file, or makes a built-in scene with the settings of its lesson; adds teapots; finds the camera. Throws Error.
LoadedScene loadScene(const Options& options);

}  // namespace gridscope
