// See derive.h.
#include "core/trace/derive.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/grid/derive.h"

namespace gridscope {

TraceParameters deriveTrace(const TraceSettings& settings, const GridParameters& grid) {
  checkNumber("--back", settings.back, 0.0f, 1e6f);
  checkNumber("--ahead", settings.ahead, 0.0f, 1e6f);
  checkNumber("--tmin", settings.tMin, 0.0f, 1e6f);
  checkNumber("--gate", settings.gate, 0.0f, 1e6f);

  const double edge = grid.cellEdge;
  TraceParameters trace{};
  trace.tMin = stored(static_cast<float>(settings.tMin * edge));
  trace.back = stored(static_cast<float>(settings.back * edge));
  trace.ahead = static_cast<float>((1.0 + settings.ahead) * edge);
  trace.gate = stored(static_cast<float>(settings.gate * edge));
  trace.gapFill = settings.gapFill ? 1u : 0u;
  trace.traversal = settings.traversal;

  // Enough to cross: the diagonal in cell edges, or a step for every face.
  const glm::dvec3 cells(grid.cellCount);
  const double crossing = settings.traversal == kTraversalDda ? cells.x + cells.y + cells.z + 3.0 : std::ceil(glm::length(cells)) + 2.0;
  trace.maxSegments = settings.maxSegments != 0 ? settings.maxSegments : static_cast<uint32_t>(crossing);

  // A segment costs a step and a test for every slot; half of the budget, so that what a compiler adds has room.
  trace.segmentsPerPass = std::max(1u, kLoopBudget / (2 * (static_cast<uint32_t>(grid.capacity) + 2)));
  return trace;
}

CameraParameters deriveCamera(const CameraPose& pose, uint32_t width, uint32_t height, float sceneDiagonal) {
  if (width < 1 || height < 1 || width > 65535 || height > 65535)
    throw Error(printed("--size %ux%u: give a width and a height from 1 to 65535", width, height));
  if (!isFinite(pose.eye) || !isFinite(pose.target) || !isFinite(pose.up)) throw Error("--camera: a coordinate is not finite");
  checkNumber("--camera: vertical field of view", pose.verticalFovDegrees, 0.1f, 179.0f);
  const glm::dvec3 view = glm::dvec3(pose.target) - glm::dvec3(pose.eye);
  if (!(glm::length(view) > 1e-9)) throw Error("--camera: the eye and the target coincide; move one of them");

  // Axes; a view along `up` takes the axis that lies most across it instead.
  const glm::dvec3 forward = glm::normalize(view);
  glm::dvec3 right = glm::cross(forward, glm::dvec3(pose.up));
  if (!(glm::length(right) > 1e-4 * glm::length(glm::dvec3(pose.up))))
    right = glm::cross(forward, std::abs(forward.z) < 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0));
  right = glm::normalize(right);

  CameraParameters camera{};
  camera.eye = pose.eye;
  camera.nearPlane = std::max(1e-3f * sceneDiagonal, 1e-6f);
  camera.right = vec3(right);
  camera.up = vec3(glm::cross(right, forward));
  camera.forward = vec3(forward);
  const double tangent = std::tan(glm::radians(double(pose.verticalFovDegrees)) / 2.0);
  camera.tanHalfHeight = static_cast<float>(tangent);
  camera.tanHalfWidth = static_cast<float>(tangent * width / height);
  camera.width = width;
  camera.height = height;
  return camera;
}

}  // namespace gridscope
