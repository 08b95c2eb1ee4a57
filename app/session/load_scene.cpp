// See load_scene.h.
#include "app/session/load_scene.h"

#include <algorithm>
#include <cctype>

#include "app/base/text.h"
#include "app/session/option_values.h"
#include "core/base/error.h"
#include "core/gltf/gltf.h"
#include "core/scene/teapot.h"

namespace gridscope {

static bool isGltfPath(const std::string& text) {
  std::string ending = std::filesystem::path(text).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return ending == ".gltf" || ending == ".glb";
}

static const BuiltInScene& findBuiltIn(const std::string& name) {
  try {
    return findBuiltInScene(name);
  } catch (const Error& error) {
    throw Error("SCENE " + name + ": neither a .gltf or .glb file nor a built-in scene: " + error.what());
  }
}

static CameraPose parseCamera(const std::string& text) {
  const std::vector<double> n = parseNumbers("--camera", text, {6, 7}, "ex,ey,ez,tx,ty,tz[,fovDegrees], or a camera's name");
  CameraPose pose{.name = text, .eye = vec3(n[0], n[1], n[2]), .target = vec3(n[3], n[4], n[5])};
  if (n.size() == 7) pose.verticalFovDegrees = static_cast<float>(n[6]);
  if (!(pose.verticalFovDegrees >= 0.1f && pose.verticalFovDegrees <= 179.0f))
    throw Error("--camera " + text + ": the vertical field of view must lie from 0.1 to 179 degrees");
  return pose;
}

// The camera of that name; a text that is no name but reads as numbers is a pose.
static CameraPose findCamera(const Scene& scene, const std::string& text) {
  if (text.empty()) return defaultCamera(scene);
  const auto named = std::ranges::find(scene.cameras, text, &CameraPose::name);
  if (named != scene.cameras.end()) return *named;
  if (looksLikeNumber(text)) return parseCamera(text);

  std::vector<std::string> names;
  for (const CameraPose& camera : scene.cameras)
    if (!camera.name.empty() && names.size() < 8) names.push_back(camera.name);
  const std::string known = names.empty() ? "the scene names none" : "the scene has " + joined(names, ", ");
  throw Error("--camera " + text + ": no such camera (" + known + "); give a name or ex,ey,ez,tx,ty,tz[,fovDegrees]");
}

LoadedScene loadScene(const Options& options) {
  LoadedScene loaded;
  if (isGltfPath(options.scene)) {
    loaded.scene = loadGltf(options.scene);
    loaded.settings = settingsOf(options, nullptr);
  } else {
    const BuiltInScene& builtIn = findBuiltIn(options.scene);
    loaded.scene = builtIn.make();
    loaded.settings = settingsOf(options, &builtIn);
  }

  // The camera is the scene's own, whatever is added.
  loaded.settings.camera = findCamera(loaded.scene, options.camera);
  if (options.teapots > 0) addTeapots(loaded.scene, options.teapots, options.moving.value_or(options.teapots));
  return loaded;
}

}  // namespace gridscope
