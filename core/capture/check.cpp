// See check.h.
#include "core/capture/check.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/parallel.h"
#include "core/grid/derive.h"
#include "core/grid/fields.h"
#include "shaders/shared/grid/grid.h"
#include "shaders/shared/scene/triangle.h"
#include "shaders/shared/trace/frame.h"

namespace gridscope {

namespace {

constexpr double kUnitTolerance = 1e-3;     // of a ray's direction: a segment must be about as long as a cell
constexpr uint32_t kMostAlphaSide = 65536;  // texels
constexpr size_t kGrain = 65536;            // elements that one core checks in a row

// Triangles that are looked at one by one, once the box of their instance has left the range of coordinates.
constexpr uint64_t kMostExactTriangles = uint64_t{1} << 28;

std::string text(uint64_t number) { return std::to_string(number); }

bool finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool finite(const vec4& v) { return finite(vec3(v)) && std::isfinite(v.w); }
bool withinLimit(const vec3& v, float limit) { return std::abs(v.x) <= limit && std::abs(v.y) <= limit && std::abs(v.z) <= limit; }

void demand(bool fulfilled, const std::string& fault) {
  if (!fulfilled) throw Error(fault);
}

void demandCount(const char* entry, uint64_t count, uint64_t wanted, const char* of) {
  if (count != wanted) throw Error(std::string(entry) + ": holds " + text(count) + " where there are " + text(wanted) + " " + of);
}

// The first of `count` elements that fails, found over the cores; count: none does.
template <class Fine>
size_t firstFault(size_t count, const Fine& fine) {
  std::atomic<size_t> first = count;
  forRanges(count, kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end && i < first; ++i) {
      if (fine(i)) continue;
      for (size_t seen = first; i < seen && !first.compare_exchange_weak(seen, i);) {
      }
      return;
    }
  });
  return first;
}

// --- Parameters

void checkTraceParameters(const TraceParameters& trace) {
  for (float value : {trace.tMin, trace.back, trace.ahead, trace.gate})
    demand(value >= 0.0f && value <= kFar, "manifest.json: trace.tMin, back, ahead and gate must be lengths from 0");
  demand(trace.gapFill <= 1 && trace.traversal <= kTraversalDda, "manifest.json: trace.gapFill or traversal is unknown");
  demand(trace.maxSegments >= 1 && trace.maxSegments <= uint32_t(INT32_MAX),
         "manifest.json: trace.maxSegments is not from 1 to 2147483647");
  demand(trace.segmentsPerPass >= 1 && trace.segmentsPerPass <= kLoopBudget, "manifest.json: trace.segmentsPerPass is not from 1 to 65535");
}

void checkSettings(const FrameSettings& settings) {
  const GridSettings& grid = settings.grid;
  for (float value : {grid.cellEdge, grid.enlargement, settings.trace.back, settings.trace.ahead, settings.trace.tMin, settings.trace.gate,
                      settings.bounce.roughness, settings.camera.verticalFovDegrees})
    demand(std::isfinite(value), "manifest.json: a setting is not finite");
  demand(finite(settings.camera.eye) && finite(settings.camera.target) && finite(settings.camera.up),
         "manifest.json: settings.camera is not finite");
  demand(!grid.bounds || (finite(grid.bounds->low) && finite(grid.bounds->high)), "manifest.json: settings.grid.bounds is not finite");
  demand(settings.width >= 1 && settings.height >= 1 && settings.width <= 65535 && settings.height <= 65535,
         "manifest.json: settings.width and height are not from 1 to 65535");
  demand(uint64_t(settings.width) * settings.height <= kMostPixels,
         "manifest.json: settings.width and height make more than " + text(kMostPixels) + " pixels");
}

void checkFrameParameters(const Capture& capture, const CaptureFrame& frame) {
  const CameraParameters& camera = frame.camera;
  demand(camera.width == capture.settings.width && camera.height == capture.settings.height,
         "manifest.json: a frame's camera has another size than settings");
  demand(finite(camera.eye) && finite(camera.right) && finite(camera.up) && finite(camera.forward) && std::isfinite(camera.nearPlane) &&
             std::isfinite(camera.tanHalfWidth) && std::isfinite(camera.tanHalfHeight),
         "manifest.json: a frame's camera is not finite");
  demand(std::isfinite(frame.timeSeconds) && std::isfinite(frame.bounce.roughness) && std::isfinite(frame.bounce.originOffset) &&
             std::isfinite(frame.view.farDistance) && finite(frame.view.sunDirection),
         "manifest.json: a frame's time, bounce or view is not finite");
}

// --- Scene

void checkMaterials(const NumberedScene& scene) {
  demand(!scene.materials.empty(), "materials_shading.npy: holds no material");
  const uint64_t alphaBytes = uint64_t(scene.alphaBytes.size()) * 4;
  for (size_t i = 0; i < scene.materials.size(); ++i) {
    const TraceMaterial& m = scene.materials[i];
    demand(finite(m.baseColour) && std::isfinite(m.metallic) && std::isfinite(m.roughness),
           "materials_shading.npy: material " + text(i) + " is not finite");
    const std::string name = "materials_keying.npy: material " + text(i);
    demand(m.flags <= (kMaterialAlphaKeyed | kMaterialUnlit | kMaterialDoubleSided), name + " has an unknown flag");
    demand(m.wrapU <= 2 && m.wrapV <= 2, name + " has an unknown wrap mode");
    demand(m.alphaThreshold <= 256, name + " has an alpha threshold above 256");
    demand(m.alphaWidth <= kMostAlphaSide && m.alphaHeight <= kMostAlphaSide && (m.alphaWidth == 0) == (m.alphaHeight == 0),
           name + " has an impossible alpha map");
    demand(m.alphaFirstByte + uint64_t(m.alphaWidth) * m.alphaHeight <= alphaBytes, name + " has an alpha map that leads beyond alpha.npy");
  }
}

void checkInstances(const Capture& capture) {
  const NumberedScene& scene = capture.scene;
  demand(!scene.instances.empty() && scene.instances.size() <= kMostInstances,
         "instances.npy: holds " + text(scene.instances.size()) + " instances, not 1 to 65535");
  demandCount("instances.npy", scene.sources.size(), scene.instances.size(), "instances");
  uint64_t triangles = 0;
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const InstanceSource& source = scene.sources[i];
    const std::string name = "instances.npy: instance " + text(i);
    demand(instance.triangleCount >= 1 && instance.triangleCount <= kMostTrianglesPerInstance,
           name + " has " + text(instance.triangleCount) + " triangles, not 1 to 65536");
    demand(uint64_t(instance.firstTriangle) + instance.triangleCount <= scene.objectTriangles.size(),
           name + " leads beyond the " + text(scene.objectTriangles.size()) + " of triangles.npy");
    demand(instance.material < scene.materials.size(),
           name + " has material " + text(instance.material) + " of " + text(scene.materials.size()));
    demand(source.mesh < capture.names.meshes.size(), name + " has mesh " + text(source.mesh) + " of " + text(capture.names.meshes.size()));
    demand(source.sceneInstance < capture.names.instances.size(),
           name + " is of scene instance " + text(source.sceneInstance) + " of " + text(capture.names.instances.size()));
    demand(source.firstTriangle == instance.firstTriangle && instance.firstWorldTriangle == triangles,
           name + " does not follow the one before it");
    triangles += instance.triangleCount;
    demand(triangles <= kMostWorldTriangles, "instances.npy: places more than " + text(kMostWorldTriangles) + " triangles");
  }

  // What the grid's parameters say of it.
  demand(scene.staticInstanceCount <= scene.instances.size(), "manifest.json: grid.staticInstanceCount is " +
                                                                  text(scene.staticInstanceCount) + " of " + text(scene.instances.size()) +
                                                                  " instances");
  const uint64_t staticTriangles =
      scene.staticInstanceCount == scene.instances.size() ? triangles : scene.instances[scene.staticInstanceCount].firstWorldTriangle;
  demand(scene.triangleCount == triangles && scene.staticTriangleCount == staticTriangles, "instances.npy: its triangles do not add up");
  const GridParameters& grid = capture.grid;
  demand(grid.instanceCount == scene.instances.size() && grid.staticInstanceCount == scene.staticInstanceCount &&
             grid.triangleCount == triangles && grid.staticTriangleCount == staticTriangles,
         "manifest.json: grid's instance and triangle counts are not those of instances.npy");
}

vec3 rowsPoint(const InstanceRows& rows, const vec3& p) { return transformPoint(Instance{rows.row0, rows.row1, rows.row2}, p); }

// Are the instance's triangles where a float can count? Its bounding box says so at once, nearly always; `exact`: triangles that may still
// be looked at.
bool withinWorld(const NumberedScene& scene, const Instance& instance, const InstanceRows& rows, const Bounds& box, uint64_t& exact) {
  bool all = true;
  for (int corner = 0; corner < 8 && all; ++corner)
    all = withinLimit(
        rowsPoint(rows, {corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y, corner & 4 ? box.high.z : box.low.z}),
        2.0f * kCoordinateLimit);
  if (all) return true;
  if (exact < instance.triangleCount) return false;
  exact -= instance.triangleCount;
  return std::ranges::all_of(std::span(scene.objectTriangles).subspan(instance.firstTriangle, instance.triangleCount),
                             [&](const Triangle& triangle) {
                               for (const vec3& point : {triangle.a, triangle.b, triangle.c})
                                 if (!withinLimit(rowsPoint(rows, point), 2.0f * kCoordinateLimit)) return false;
                               return true;
                             });
}

void checkTransforms(const Capture& capture) {
  const NumberedScene& scene = capture.scene;
  std::vector<Bounds> boxes(scene.instances.size());
  uint64_t exact = kMostExactTriangles;
  for (size_t f = 0; f < capture.frames.size(); ++f) {
    const std::vector<InstanceRows>& rows = capture.frames[f].rows;
    demandCount("instances_transform.npy", rows.size(), scene.instances.size(), "instances");
    for (size_t i = f == 0 ? 0 : scene.staticInstanceCount; i < rows.size(); ++i) {
      const Instance& instance = scene.instances[i];
      if (f == 0)
        for (uint32_t t = 0; t < instance.triangleCount; ++t)
          for (const vec3& point :
               {scene.objectTriangles[instance.firstTriangle + t].a, scene.objectTriangles[instance.firstTriangle + t].b,
                scene.objectTriangles[instance.firstTriangle + t].c})
            boxes[i].include(point);
      const std::string name = "instances_transform.npy: instance " + text(i) + " of frame " + text(f);
      demand(finite(rows[i].row0) && finite(rows[i].row1) && finite(rows[i].row2), name + " has a transform that is not finite");
      demand(withinWorld(scene, instance, rows[i], boxes[i], exact), name + " lies beyond the coordinates that are supported (1e6)");
    }
    if (f > 0)
      demand(std::memcmp(rows.data(), capture.frames[0].rows.data(), scene.staticInstanceCount * sizeof(InstanceRows)) == 0,
             "instances_transform.npy: a static instance moves in frame " + text(f));
  }
  for (size_t i = 0; i < scene.instances.size(); ++i)
    demand(std::memcmp(&scene.instances[i], &capture.frames[0].rows[i], sizeof(InstanceRows)) == 0,
           "instances_transform.npy: the scene is not as in its first frame");
}

void checkGeometry(const NumberedScene& scene) {
  const size_t count = scene.objectTriangles.size();
  demand(count >= 1 && count <= kMostWorldTriangles,
         "triangles.npy: holds " + text(count) + " triangles, not 1 to " + text(kMostWorldTriangles));
  demandCount("corners_normal.npy", scene.corners.size(), 3 * count, "corners of triangles");
  demandCount("triangles_number.npy", scene.meshTriangles.size(), count, "triangles");
  size_t fault = firstFault(count, [&](size_t i) {
    const Triangle& t = scene.objectTriangles[i];
    return finite(t.a) && finite(t.b) && finite(t.c);
  });
  demand(fault == count, "triangles.npy: triangle " + text(fault) + " is not finite");
  fault = firstFault(scene.corners.size(), [&](size_t i) {
    return finite(scene.corners[i].normal) && std::isfinite(scene.corners[i].uv.x) && std::isfinite(scene.corners[i].uv.y);
  });
  demand(fault == scene.corners.size(), "corners_normal.npy or corners_uv.npy: corner " + text(fault) + " is not finite");
}

// --- Products

// Which references there are.
class References {
 public:
  explicit References(const NumberedScene& scene) {
    for (const Instance& instance : scene.instances) counts_.push_back(instance.triangleCount);
  }
  bool exists(uint32_t reference) const { return (reference >> 16) < counts_.size() && (reference & 0xFFFFu) < counts_[reference >> 16]; }
  std::string fault(uint32_t reference) const {
    return "names instance " + text(reference >> 16) + ", triangle " + text(reference & 0xFFFFu) + ", which is not in the scene";
  }

 private:
  std::vector<uint32_t> counts_;
};

void checkGrid(const Capture& capture, const CaptureFrame& frame, const References& references) {
  demandCount("grid.npy", frame.grid.size(), gridWordCount(capture.grid), "texels");
  const size_t fault = firstFault(frame.grid.size(), [&](size_t i) {
    const uint32_t word = frame.grid[i];
    return word == kNoReference || references.exists(word) || !wordIsReference(capture.grid, i);
  });
  if (fault < frame.grid.size()) throw Error("grid.npy: " + wordText(capture.grid, fault) + " " + references.fault(frame.grid[fault]));
}

std::string pixelName(const Capture& capture, size_t index) {
  return "pixel (" + text(index % capture.settings.width) + ", " + text(index / capture.settings.width) + ")";
}

void checkGather(const Capture& capture, const CaptureFrame& frame, const References& references) {
  const size_t fault = firstFault(frame.gather.size(), [&](size_t i) {
    const GatherPixel& pixel = frame.gather[i];
    if (pixel.reference == kNoReference) return true;
    return references.exists(pixel.reference) && pixel.material < capture.scene.materials.size() && finite(pixel.position) &&
           finite(pixel.geometricNormal) && finite(pixel.shadingNormal) && std::isfinite(pixel.depth);
  });
  if (fault == frame.gather.size()) return;
  const GatherPixel& pixel = frame.gather[fault];
  if (!references.exists(pixel.reference))
    throw Error("gather_reference.npy: " + pixelName(capture, fault) + " " + references.fault(pixel.reference));
  if (pixel.material >= capture.scene.materials.size())
    throw Error("gather_material.npy: " + pixelName(capture, fault) + " has material " + text(pixel.material) + " of " +
                text(capture.scene.materials.size()));
  throw Error("gather_position.npy, a normal or gather_depth.npy: " + pixelName(capture, fault) + " is not finite");
}

void checkRays(const Capture& capture, const CaptureFrame& frame) {
  const char* what = "";
  const auto faultOf = [](const Ray& ray) {
    if (ray.valid > 1) return "rays_valid.npy: %: neither 0 nor 1";
    if (ray.valid == 0) return "";
    if (!finite(ray.origin) || !withinLimit(ray.origin, 2.0f * kCoordinateLimit))
      return "rays_origin.npy: % starts beyond the coordinates that are supported (1e6)";
    if (!finite(ray.direction) || std::abs(glm::length(glm::dvec3(ray.direction)) - 1.0) > kUnitTolerance)
      return "rays_direction.npy: % has a direction that is not of length 1";
    if (!finite(ray.launchNormal) || glm::length(glm::dvec3(ray.launchNormal)) > 1.0 + kUnitTolerance)
      return "rays_launch_normal.npy: % has a normal that is longer than 1";
    return "";
  };
  const size_t fault = firstFault(frame.rays.size(), [&](size_t i) { return *faultOf(frame.rays[i]) == '\0'; });
  if (fault == frame.rays.size()) return;
  what = faultOf(frame.rays[fault]);
  std::string message = what;
  throw Error(message.replace(message.find('%'), 1, pixelName(capture, fault)));
}

void checkHits(const Capture& capture, const CaptureFrame& frame, const References& references) {
  const auto isHit = [](const Hit& hit) { return hit.kind == kHitTriangle || hit.kind == kHitVoxel; };
  const size_t fault = firstFault(frame.hits.size(), [&](size_t i) {
    const Hit& hit = frame.hits[i];
    return hit.kind <= kHitLimit && std::isfinite(hit.t) && (isHit(hit) ? references.exists(hit.reference) : hit.reference == kNoReference);
  });
  if (fault == frame.hits.size()) return;
  const Hit& hit = frame.hits[fault];
  const std::string pixel = pixelName(capture, fault);
  if (hit.kind > kHitLimit) throw Error("hits_kind.npy: " + pixel + " has kind " + text(hit.kind) + ", not 0 to 4");
  if (!std::isfinite(hit.t)) throw Error("hits_t.npy: " + pixel + " is not finite");
  if (!isHit(hit)) throw Error("hits_reference.npy: " + pixel + " hits nothing and names a reference");
  throw Error("hits_reference.npy: " + pixel + " " + references.fault(hit.reference));
}

void checkExact(const Capture& capture, const CaptureFrame& frame, const References& references) {
  for (size_t i = 0; i < frame.exact.size(); ++i) {
    const ExactHit& hit = frame.exact[i];
    const std::string pixel = pixelName(capture, i);
    if (!std::isfinite(hit.t)) throw Error("exact_t.npy: " + pixel + " is not finite");
    if (hit.reference != kNoReference && !references.exists(hit.reference))
      throw Error("exact_reference.npy: " + pixel + " " + references.fault(hit.reference));
  }
}

template <class Element>
void checkPixelCount(const Capture& capture, Part part, const std::vector<Element>& elements) {
  const uint64_t pixels = uint64_t(capture.settings.width) * capture.settings.height;
  if (elements.size() != pixels)
    throw Error(std::string(partRow(part).name) + ": " + text(elements.size()) + " pixels where settings say " + text(pixels));
}

}  // namespace

void checkCaptureInputs(const Capture& capture) {
  demand(!capture.frames.empty(), "manifest.json: holds no frame");
  try {
    checkGridParameters(capture.grid);
  } catch (const Error& error) {
    throw error.within("manifest.json");
  }
  checkTraceParameters(capture.trace);
  checkSettings(capture.settings);
  demand(finite(capture.bounds.low) && finite(capture.bounds.high), "manifest.json: scene.bounds is not finite");
  for (const CaptureFrame& frame : capture.frames) checkFrameParameters(capture, frame);
  checkGeometry(capture.scene);
  checkMaterials(capture.scene);
  demandCount("manifest.json: scene.materials", capture.names.materials.size(), capture.scene.materials.size(), "materials");
  checkInstances(capture);
  checkTransforms(capture);
}

void checkCaptureProduct(const Capture& capture, Part part) {
  const References references(capture.scene);
  const auto held = [part](const CaptureFrame& frame) {
    switch (part) {
      case Part::grid: return !frame.grid.empty();
      case Part::gather: return !frame.gather.empty();
      case Part::rays: return !frame.rays.empty();
      case Part::hits: return !frame.hits.empty();
      case Part::counters: return !frame.counters.empty();
      default: return !frame.exact.empty();
    }
  };
  const bool present = held(capture.frames[0]);
  for (const CaptureFrame& frame : capture.frames) {
    demand(held(frame) == present, std::string(partRow(part).name) + ": some frames hold it and others do not");
    if (!present) continue;
    if (part == Part::grid) checkGrid(capture, frame, references);
    if (part == Part::gather) checkPixelCount(capture, part, frame.gather), checkGather(capture, frame, references);
    if (part == Part::rays) checkPixelCount(capture, part, frame.rays), checkRays(capture, frame);
    if (part == Part::hits) checkPixelCount(capture, part, frame.hits), checkHits(capture, frame, references);
    if (part == Part::counters) checkPixelCount(capture, part, frame.counters);
    if (part == Part::exact) checkPixelCount(capture, part, frame.exact), checkExact(capture, frame, references);
  }
}

void checkCapture(const Capture& capture) {
  checkCaptureInputs(capture);
  for (Part part : {Part::grid, Part::gather, Part::rays, Part::hits, Part::counters, Part::exact}) checkCaptureProduct(capture, part);
}

}  // namespace gridscope
