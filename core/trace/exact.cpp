// See exact.h. Triangles are Embree's user geometry: its hierarchy proposes the triangles whose padded boxes a ray meets, the trace's own
// test decides. So no candidate is lost where Embree's arithmetic and the trace's differ in the last bit.
// Source: Wald, Woop, Benthin, Johnson and Ernst, Embree: A Kernel Framework for Efficient CPU Ray Tracing, 2014.
#include "core/trace/exact.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <string>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/trace/loads.h"

namespace gridscope {

namespace {

struct ExactTrace : TraceLoads {
  using TraceLoads::TraceLoads;
#include "shaders/shared/trace/traverse.h"
};

// Boxes are padded by this share of the largest coordinate, of the triangles or of the ray's origin: more than the rounding of the ray test.
constexpr float kBoxPadding = 1e-5f;

// Rays that start farther away than the scene's largest coordinate get a hierarchy of their own, each for origins so many times as far as the
// one before. Where its padding would be as large as the scene, every triangle is tried: at most 6 times 8, as 1e-5 * 8^6 > 2.
constexpr float kFartherBy = 8.0f;
constexpr size_t kMostHierarchies = 6;

// A ray on its way through the hierarchy.
struct Query {
  RTCIntersectContext context;  // first: Embree hands it back by this address
  const Ray* ray;
  float best;
  uint32_t reference;
};

[[noreturn]] void failEmbree(RTCDevice device, const char* call) {
  const int error = int(rtcGetDeviceError(device));
  throw Error(std::string("exact reference: ") + call + " failed in Embree, error " + std::to_string(error), kExitDevice);
}

}  // namespace

struct ExactReference::Parts {
  // Built when the first ray asks for it.
  struct Hierarchy {
    const Parts* parts = nullptr;
    float padding = 0.0f;  // of boxes, world units
    std::once_flag built;
    RTCScene scene = nullptr;
  };

  TraceInput input;
  mutable ExactTrace loads;          // holds nothing that a ray changes
  std::vector<uint32_t> references;  // of the primitives, rising
  std::vector<uint32_t> triangles;   // their world triangles
  float largest = 0.0f;              // coordinate of any of them
  float extent = 0.0f;               // of the scene, its longest side
  RTCDevice device = nullptr;
  mutable std::array<Hierarchy, kMostHierarchies> hierarchies;

  explicit Parts(const TraceInput& traceInput) : input(traceInput), loads(input) {}
  ~Parts() {
    for (Hierarchy& hierarchy : hierarchies)
      if (hierarchy.scene) rtcReleaseScene(hierarchy.scene);
    if (device) rtcReleaseDevice(device);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  const Triangle& triangleOf(uint32_t primitive) const { return input.worldTriangles[triangles[primitive]]; }
  void listPrimitives();
  RTCScene sceneFor(const Ray& ray) const;
  void build(Hierarchy& hierarchy) const;
  void bound(uint32_t primitive, float padding, RTCBounds& bounds) const;
  static void cast(Query& query, RTCScene scene);
  void offer(Query& query, uint32_t primitive) const;
};

// Every triangle, those too that the build leaves out as having no area: whether a ray hits them is the test's to say.
void ExactReference::Parts::listPrimitives() {
  vec3 low(kFar), high(-kFar);
  for (uint32_t i = 0; i < input.scene.instanceCount(); ++i) {
    const Instance& instance = input.scene.instances[i];
    for (uint32_t k = 0; k < instance.triangleCount; ++k) {
      const Triangle& triangle = input.worldTriangles[instance.firstWorldTriangle + k];
      references.push_back(makeReference(i, k));
      triangles.push_back(instance.firstWorldTriangle + k);
      low = min(low, min(triangle.a, min(triangle.b, triangle.c)));
      high = max(high, max(triangle.a, max(triangle.b, triangle.c)));
    }
  }
  for (int axis = 0; axis < 3 && !references.empty(); ++axis) {
    largest = std::max({largest, std::abs(low[axis]), std::abs(high[axis])});
    extent = std::max(extent, high[axis] - low[axis]);
  }
}

// The trace's own test, tMin and alpha keying. Of equal distances the smaller reference, in whatever order they are offered. Embree is
// never told how near a hit is, and offers every box along the ray: the distance of a triangle that the ray nearly runs along is rounding,
// and may lie anywhere, before its box too.
void ExactReference::Parts::offer(Query& query, uint32_t primitive) const {
  const Triangle& triangle = triangleOf(primitive);
  const uint32_t reference = references[primitive];
  const TriangleTest test = testTriangle(*query.ray, triangle, input.parameters.tMin, kFar);
  if (test.verdict != kTestHit || test.t > query.best || (test.t == query.best && reference > query.reference)) return;
  uint alphaByte;
  if (!loads.alphaPasses(reference, triangle, rayPoint(*query.ray, test.t), alphaByte)) return;
  query.best = test.t;
  query.reference = reference;
}

void ExactReference::Parts::bound(uint32_t primitive, float padding, RTCBounds& bounds) const {
  const Triangle& triangle = triangleOf(primitive);
  const vec3 low = min(triangle.a, min(triangle.b, triangle.c)) - padding;
  const vec3 high = max(triangle.a, max(triangle.b, triangle.c)) + padding;
  bounds.lower_x = low.x, bounds.lower_y = low.y, bounds.lower_z = low.z;
  bounds.upper_x = high.x, bounds.upper_y = high.y, bounds.upper_z = high.z;
}

// The hierarchy whose padding suits a ray; null: try every triangle.
RTCScene ExactReference::Parts::sceneFor(const Ray& ray) const {
  const float away = std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)});
  float reach = 1.01f * largest;  // a hair more: rays start on the scene's surfaces, give or take their rounding
  for (Hierarchy& hierarchy : hierarchies) {
    if (!(kBoxPadding * reach < extent)) return nullptr;
    if (away <= reach) {
      std::call_once(hierarchy.built, [&] {
        hierarchy.parts = this;
        hierarchy.padding = kBoxPadding * reach;
        build(hierarchy);
      });
      return hierarchy.scene;
    }
    reach *= kFartherBy;
  }
  return nullptr;
}

void ExactReference::Parts::build(Hierarchy& hierarchy) const {
  RTCScene scene = hierarchy.scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, unsigned(references.size()));
  rtcSetGeometryUserData(geometry, &hierarchy);
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* arguments) {
        const Hierarchy& asked = *static_cast<const Hierarchy*>(arguments->geometryUserPtr);
        asked.parts->bound(arguments->primID, asked.padding, *arguments->bounds_o);
      },
      nullptr);
  rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments* arguments) {
    Query& query = *reinterpret_cast<Query*>(arguments->context);
    static_cast<const Hierarchy*>(arguments->geometryUserPtr)->parts->offer(query, arguments->primID);
  });
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) failEmbree(device, "rtcCommitScene");
}

// Offers the triangles whose boxes the ray meets.
void ExactReference::Parts::cast(Query& query, RTCScene scene) {
  const Ray& ray = *query.ray;
  rtcInitIntersectContext(&query.context);
  RTCRayHit rayHit{};
  rayHit.ray.org_x = ray.origin.x, rayHit.ray.org_y = ray.origin.y, rayHit.ray.org_z = ray.origin.z;
  rayHit.ray.dir_x = ray.direction.x, rayHit.ray.dir_y = ray.direction.y, rayHit.ray.dir_z = ray.direction.z;
  rayHit.ray.tfar = kFar;
  rayHit.ray.mask = ~0u;
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &query.context, &rayHit);
}

ExactReference::ExactReference(const TraceInput& input) : parts_(std::make_unique<Parts>(input)) {
  parts_->listPrimitives();
  parts_->device = rtcNewDevice(nullptr);
  if (!parts_->device) failEmbree(nullptr, "rtcNewDevice");
}

ExactReference::~ExactReference() = default;
ExactReference::ExactReference(ExactReference&&) noexcept = default;

Hit ExactReference::trace(const Ray& ray) const {
  ExactTrace& loads = parts_->loads;
  if (ray.valid == 0u) return missedHit(kHitNoRay);
  Query query{.context = {}, .ray = &ray, .best = kFar, .reference = kNoReference};
  const RTCScene scene = parts_->sceneFor(ray);
  if (scene) Parts::cast(query, scene);
  for (uint32_t primitive = 0; !scene && primitive < parts_->references.size(); ++primitive) parts_->offer(query, primitive);
  if (query.reference == kNoReference) return missedHit(kHitMiss);
  return loads.finishHit(ray, makeHit(kHitTriangle, query.best, query.reference));
}

std::vector<Hit> ExactReference::trace(std::span<const Ray> rays) const {
  std::vector<Hit> hits(rays.size());
  forRanges(rays.size(), 256, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) hits[i] = trace(rays[i]);
  });
  return hits;
}

}  // namespace gridscope
