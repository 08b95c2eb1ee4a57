// The hall, shown when no scene is named: a vaulted nave with aisles, a mirror-like floor, ivy whose leaves are cut out by
// alpha, a filigree that saturates its cells, and three teapots that move. Its parts are in scene_hall_*.cpp.
#include "core/scene/hall.h"

#include "core/scene/built_in_scenes.h"
#include "core/scene/teapot.h"

namespace gridscope {

namespace hall {

void addPart(Scene& scene, Mesh mesh) {
  const Material& material = scene.materials[mesh.materialIndex];
  // A metal's colour is the colour of what it mirrors, which has its own light: half of the shading is enough.
  const float share = material.metallic > 0.5f ? 0.4f : 1.0f;
  if (!material.unlit) {
    shadeMesh(mesh, [share](const vec3& place, const vec3& normal) { return glm::mix(vec3(1.0f), bakedLight(place, normal), share); });
  }
  const uint32_t index = static_cast<uint32_t>(scene.meshes.size());
  scene.nodes.push_back({.name = mesh.name});
  scene.instances.push_back({.name = mesh.name, .node = static_cast<uint32_t>(scene.nodes.size() - 1), .mesh = index});
  scene.meshes.push_back(std::move(mesh));
}

}  // namespace hall

Scene makeHall() {
  using namespace hall;
  Scene scene;
  scene.name = "hall";
  scene.cameras = {
      {.name = "nave", .eye = {-0.7f, 1.95f, 15.0f}, .target = {0.2f, 4.6f, -8.0f}, .verticalFovDegrees = 58.0f},
      {.name = "filigree",
       .eye = kFiligree + vec3(-0.75f, 0.35f, 1.5f),
       .target = kFiligree - vec3(0.0f, 0.08f, 0.0f),
       .verticalFovDegrees = 45.0f},
      {.name = "aisle", .eye = {-6.6f, 1.9f, 13.6f}, .target = {-5.6f, 2.6f, -6.0f}, .verticalFovDegrees = 58.0f},
      {.name = "floor", .eye = {0.6f, 1.2f, 10.5f}, .target = {-0.4f, -0.2f, 2.0f}, .verticalFovDegrees = 55.0f},
  };

  addMaterials(scene);
  addFloors(scene);
  addArcades(scene);
  addOuterWalls(scene);
  addEndWalls(scene);
  addVaults(scene);
  addColumns(scene);
  addGlass(scene);
  addFiligree(scene);
  addPlanters(scene);
  addIvy(scene);
  addChandeliers(scene);

  addTeapot(scene, {.centre = {-1.5f, 0.35f, 7.2f},
                    .length = 1.5f,
                    .radius = 0.7f,
                    .bob = 0.15f,
                    .periodSeconds = 7.0f,
                    .baseColour = {0.48f, 0.03f, 0.02f, 1.0f}});
  addTeapot(scene, {.centre = {1.2f, 0.8f, 2.2f},
                    .length = 1.5f,
                    .radius = 1.1f,
                    .bob = 0.3f,
                    .periodSeconds = 9.1f,
                    .startTurn = 0.3f,
                    .baseColour = {0.02f, 0.12f, 0.34f, 1.0f}});
  addTeapot(scene, {.centre = {-0.9f, 1.1f, -3.0f},
                    .length = 1.5f,
                    .radius = 1.4f,
                    .bob = 0.4f,
                    .periodSeconds = 11.3f,
                    .startTurn = 0.6f,
                    .baseColour = {0.90f, 0.60f, 0.22f, 1.0f},
                    .metallic = 1.0f});
  return scene;
}

}  // namespace gridscope
