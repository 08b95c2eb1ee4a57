// gridscope scenes: the built-in scenes with their lessons and the settings that they bring.
#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/report.h"
#include "core/base/error.h"

namespace gridscope {

// What a lesson sets, as options; empty: nothing.
static std::string lessonSettings(const BuiltInScene& builtIn) {
  std::vector<std::string> parts;
  if (builtIn.cells != 0) parts.push_back(printed("--cells %u", builtIn.cells));
  if (builtIn.cellEdge != 0.0f) parts.push_back(printed("--cell-edge %g", builtIn.cellEdge));
  if (builtIn.capacity != 0) parts.push_back(printed("--capacity %u", builtIn.capacity));
  if (builtIn.ahead != 0.0f) parts.push_back(printed("--ahead %g", builtIn.ahead));
  if (builtIn.width != 0 && builtIn.height != 0) parts.push_back(printed("--size %ux%u", builtIn.width, builtIn.height));
  return joined(parts, " ");
}

static uint64_t triangleCount(const Scene& scene) {
  uint64_t count = 0;
  for (const SceneInstance& instance : scene.instances) count += scene.meshes[instance.mesh].triangleCount();
  return count;
}

void addScenesOptions(CLI::App& command, Options& options) { addJsonOption(command, options); }

int runScenes(const Options& options) {
  Table table("lrrll");
  table.add({"scene", "triangles", "instances", "settings it brings", "lesson"});
  nlohmann::ordered_json scenes = nlohmann::ordered_json::array();
  for (const BuiltInScene& builtIn : builtInScenes()) {
    const Scene scene = builtIn.make();
    const uint64_t triangles = triangleCount(scene);
    const std::string settings = lessonSettings(builtIn);
    table.add({std::string(builtIn.name), grouped(triangles), grouped(scene.instances.size()), settings, std::string(builtIn.lesson)});
    scenes.push_back({{"name", builtIn.name},
                      {"triangles", triangles},
                      {"instances", scene.instances.size()},
                      {"settings", settings},
                      {"lesson", builtIn.lesson}});
  }
  table.print(textStream(options));
  writeJson(options, {{"scenes", scenes}});
  return kExitDone;
}

}  // namespace gridscope
