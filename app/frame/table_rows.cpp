// See table_rows.h.
#include "app/frame/table_rows.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "app/base/text.h"
#include "app/frame/find_next.h"

namespace gridscope {

const char* tableNoun(TableKind kind, bool many) {
  switch (kind) {
    case TableKind::cells: return many ? "cells" : "cell";
    case TableKind::instances: return many ? "instances" : "instance";
    case TableKind::triangles: return many ? "triangles" : "triangle";
    case TableKind::rays: return many ? "rays" : "ray";
  }
  return "";
}

const Triangle* worldTriangle(const FrameSnapshot& frame, uint32_t reference) {
  const uint32_t instance = referenceInstance(reference), triangle = referenceTriangle(reference);
  if (!frame.instances || !frame.worldTriangles || instance >= frame.instances->size()) return nullptr;
  const Instance& placed = (*frame.instances)[instance];
  const size_t index = size_t(placed.firstWorldTriangle) + triangle;
  if (triangle >= placed.triangleCount || index >= frame.worldTriangles->size()) return nullptr;
  return &(*frame.worldTriangles)[index];
}

static void include(Bounds& bounds, const Triangle& triangle) {
  for (const vec3& corner : {triangle.a, triangle.b, triangle.c}) bounds.include(corner);
}

Bounds boundsOfTriangle(const FrameSnapshot& frame, uint32_t reference) {
  Bounds bounds;
  if (const Triangle* triangle = worldTriangle(frame, reference)) include(bounds, *triangle);
  return bounds;
}

Bounds boundsOfInstance(const FrameSnapshot& frame, uint32_t sceneInstance) {
  Bounds bounds;
  if (!frame.scene || !frame.instances) return bounds;
  const std::vector<InstanceSource>& sources = frame.scene->numbered.sources;
  for (uint32_t instance = 0; instance < sources.size(); ++instance) {
    if (sources[instance].sceneInstance != sceneInstance || instance >= frame.instances->size()) continue;
    for (uint32_t triangle = 0; triangle < (*frame.instances)[instance].triangleCount; ++triangle)
      bounds.include(boundsOfTriangle(frame, makeReference(instance, triangle)));
  }
  return bounds;
}

namespace {

template <typename Column>
constexpr size_t at(Column column) {
  return static_cast<size_t>(column);
}

SheetColumn numbers(const char* title, const char* about, ColumnKind kind = ColumnKind::whole, bool known = true) {
  return {.title = title, .about = about, .kind = kind, .known = known};
}

SheetColumn words(const char* title, const char* about, std::vector<std::string> list) {
  return {.title = title, .about = about, .kind = ColumnKind::word, .words = std::move(list)};
}

SheetColumn places(const char* title, const char* about, const ivec3& extent) {
  return {.title = title, .about = about, .kind = ColumnKind::place, .extent = extent};
}

void addRow(Sheet& sheet, uint32_t id, std::initializer_list<double> values) {
  sheet.ids.push_back(id);
  size_t column = 0;
  for (const double value : values) sheet.columns[column++].values.push_back(value);
}

// What the rays of an area saw and hit.
struct AreaTargets {
  std::vector<uint8_t> references;  // by world triangle
  std::vector<uint8_t> instances;   // of the scene
  std::vector<uint8_t> cells;       // x fastest
};

class AreaMarker {
 public:
  explicit AreaMarker(const FrameSnapshot& frame) : frame_(frame), grid_(frame.gridShape()) {
    targets_.references.resize(frame.worldTriangles ? frame.worldTriangles->size() : 0);
    for (const InstanceSource& source : frame.scene->numbered.sources)
      targets_.instances.resize(std::max<size_t>(targets_.instances.size(), source.sceneInstance + size_t{1}));
    targets_.cells.resize(size_t(grid_.cellCount.x) * size_t(grid_.cellCount.y) * size_t(grid_.cellCount.z));
  }

  void markPixel(uint32_t pixel) {
    if (frame_.gather && pixel < frame_.gather->size()) {
      const GatherPixel& seen = (*frame_.gather)[pixel];
      if (seen.reference != kNoReference) markReference(seen.reference), markCell(gridCell(grid_, seen.position));
    }
    if (frame_.hits && frame_.rays && pixel < frame_.hits->size() && pixel < frame_.rays->size()) {
      const Hit& hit = (*frame_.hits)[pixel];
      const Ray& ray = (*frame_.rays)[pixel];
      if (hit.reference != kNoReference) markReference(hit.reference), markCell(gridCell(grid_, ray.origin + hit.t * ray.direction));
    }
    if (frame_.truths && pixel < frame_.truths->size()) {
      const RayTruth& truth = (*frame_.truths)[pixel];
      if (truth.cause != kCauseNone) markReference(truth.exactReference), markCell(truth.cell);
    }
  }

  const AreaTargets& targets() const { return targets_; }

 private:
  void markReference(uint32_t reference) {
    const Triangle* triangle = worldTriangle(frame_, reference);
    if (!triangle) return;
    targets_.references[size_t(triangle - frame_.worldTriangles->data())] = 1;
    const uint32_t instance = referenceInstance(reference);
    if (instance < frame_.scene->numbered.sources.size()) targets_.instances[frame_.scene->numbered.sources[instance].sceneInstance] = 1;
  }
  void markCell(const ivec3& cell) {
    if (gridContains(grid_, cell)) targets_.cells[idOfCell(grid_, cell)] = 1;
  }

  const FrameSnapshot& frame_;
  const GridParameters& grid_;
  AreaTargets targets_;
};

bool contains(const PixelArea& area, uint32_t pixel, uint32_t width) {
  const ivec2 place(int(pixel % width), int(pixel / width));
  return place.x >= area.begin.x && place.y >= area.begin.y && place.x < area.end.x && place.y < area.end.y;
}

AreaTargets targetsOf(const FrameSnapshot& frame, const PixelArea& area) {
  AreaMarker marker(frame);
  const uint32_t width = frame.request.settings->width;
  for (uint32_t pixel = 0; pixel < frame.pixelCount(); ++pixel)
    if (contains(area, pixel, width)) marker.markPixel(pixel);
  return marker.targets();
}

Sheet cellSheet(const FrameSnapshot& frame, const std::optional<PixelArea>& area) {
  const Grid& grid = *frame.grid;
  const GridParameters& shape = grid.parameters;
  const bool costs = frame.ledger && frame.truths;
  Sheet sheet{.name = "cells"};
  sheet.columns = {
      places("cell", "x, y, z of the cell", shape.cellCount),
      numbers("tried", "References that the cell was asked to take: stored and refused"),
      numbers("stored", "References in its slots"),
      numbers("refused", "References that found no slot"),
      numbers("occupancy", "Slots taken", ColumnKind::percent),
      numbers("read by rays", "Rays of this frame that tested its references", ColumnKind::whole, bool(frame.cellRays)),
      numbers("rays lost", "Rays that do not agree with the exact hit because of what took place here", ColumnKind::whole, costs)};

  std::vector<uint32_t> raysLost(costs ? size_t(shape.cellCount.x) * size_t(shape.cellCount.y) * size_t(shape.cellCount.z) : 0);
  if (costs)
    for (const CellLoss& loss : frame.ledger->cells)
      if (gridContains(shape, loss.cell)) raysLost[idOfCell(shape, loss.cell)] = loss.rays;
  const AreaTargets targets = area ? targetsOf(frame, *area) : AreaTargets{};

  const uint32_t cellCount = uint32_t(shape.cellCount.x) * uint32_t(shape.cellCount.y) * uint32_t(shape.cellCount.z);
  for (uint32_t id = 0; id < cellCount; ++id) {
    const CellFacts cell = cellFacts(grid, cellOfId(shape, id));
    if (cell.tried() == 0) continue;
    const double readBy = frame.cellRays && id < frame.cellRays->size() ? double((*frame.cellRays)[id].read) : NAN;
    addRow(sheet, id,
           {double(id), double(cell.tried()), double(cell.stored), double(cell.refused), 100.0 * cell.stored / shape.capacity, readBy,
            costs ? double(raysLost[id]) : NAN});
    if (area) sheet.inArea.push_back(targets.cells[id]);
  }
  return sheet;
}

// Of every world triangle: cells that hold it, cells that refused it, and the rays that this cost.
struct TriangleCounts {
  std::vector<uint32_t> stored;
  std::vector<uint32_t> lost;  // empty without the ledger
  std::vector<uint32_t> rays;  // empty without the truth
};

// Of the ledger, or read off the grid's slots, which know nothing of what was refused.
TriangleCounts countTriangleCells(const FrameSnapshot& frame) {
  const size_t count = frame.worldTriangles->size();
  TriangleCounts counts;
  counts.stored.resize(count);
  const auto indexOf = [&](uint32_t reference) -> std::optional<size_t> {
    const Triangle* triangle = worldTriangle(frame, reference);
    if (!triangle) return std::nullopt;
    return size_t(triangle - frame.worldTriangles->data());
  };
  if (frame.ledger) {
    counts.lost.resize(count);
    if (frame.truths) counts.rays.resize(count);
    for (const TriangleLoss& loss : frame.ledger->triangles) {
      const std::optional<size_t> index = indexOf(loss.reference);
      if (!index) continue;
      counts.stored[*index] = loss.stored, counts.lost[*index] = loss.lost;
      if (frame.truths) counts.rays[*index] = loss.rays;
    }
    return counts;
  }
  const GridParameters& shape = frame.grid->parameters;
  forCellsOfLayers(shape, 0, shape.cellCount.z, [&](ivec3 cell) {
    for (uint32_t reference : storedIn(*frame.grid, cell))
      if (const std::optional<size_t> index = indexOf(reference)) ++counts.stored[*index];
  });
  return counts;
}

double countAt(const std::vector<uint32_t>& counts, size_t index) { return counts.empty() ? NAN : double(counts[index]); }

double areaOf(const Triangle& triangle) { return 0.5 * double(glm::length(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a))); }

std::string nameAt(const std::vector<std::string>& names, size_t index, const char* noun) {
  return index < names.size() && !names[index].empty() ? names[index] : std::string(noun) + " " + std::to_string(index);
}

// All names up to the largest index that is used, none of them empty.
std::vector<std::string> namesUpTo(const std::vector<std::string>& names, size_t count, const char* noun) {
  std::vector<std::string> result(count);
  for (size_t index = 0; index < count; ++index) result[index] = nameAt(names, index, noun);
  return result;
}

size_t meshCount(const SceneFacts& scene) {
  size_t count = scene.names.meshes.size();
  for (const InstanceSource& source : scene.numbered.sources) count = std::max<size_t>(count, source.mesh + size_t{1});
  return count;
}

Sheet triangleSheet(const FrameSnapshot& frame, const std::optional<PixelArea>& area) {
  const NumberedScene& numbered = frame.scene->numbered;
  const TriangleCounts counts = countTriangleCells(frame);
  Sheet sheet{.name = "triangles"};
  sheet.columns = {numbers("reference", "Its 32 bits in a slot: instance in the high half, triangle in the low one", ColumnKind::reference),
                   words("mesh", "Name in the file", namesUpTo(frame.scene->names.meshes, meshCount(*frame.scene), "mesh")),
                   numbers("triangle", "Number in its mesh, in the file's order"),
                   numbers("area", "World units squared", ColumnKind::decimal),
                   numbers("stored", "Cells that hold it"),
                   numbers("lost", "Cells that refused it", ColumnKind::whole, !counts.lost.empty()),
                   numbers("rays lost", "Rays that should have hit it and do not agree", ColumnKind::whole, !counts.rays.empty())};
  const AreaTargets targets = area ? targetsOf(frame, *area) : AreaTargets{};
  for (uint32_t instance = 0; instance < frame.instances->size() && instance < numbered.sources.size(); ++instance) {
    for (uint32_t triangle = 0; triangle < (*frame.instances)[instance].triangleCount; ++triangle) {
      const uint32_t reference = makeReference(instance, triangle);
      const Triangle* corners = worldTriangle(frame, reference);
      if (!corners) continue;
      const size_t index = size_t(corners - frame.worldTriangles->data());
      const TriangleName name = nameTriangle(numbered, reference);
      addRow(sheet, reference,
             {double(reference), double(name.mesh), double(name.triangle), areaOf(*corners), double(counts.stored[index]),
              countAt(counts.lost, index), countAt(counts.rays, index)});
      if (area) sheet.inArea.push_back(targets.references[index]);
    }
  }
  return sheet;
}

// Sums over the pieces of one instance of the scene.
struct InstanceSums {
  std::optional<uint32_t> mesh;  // not given: it has no triangles in the grid's numbering
  bool dynamic = false;
  double triangles = 0.0, stored = 0.0, lost = 0.0, rays = 0.0;
};

std::vector<InstanceSums> sumInstances(const FrameSnapshot& frame) {
  const NumberedScene& numbered = frame.scene->numbered;
  const TriangleCounts counts = countTriangleCells(frame);
  std::vector<InstanceSums> sums(std::max(frame.scene->names.instances.size(), frame.scene->meshOfInstance.size()));
  for (uint32_t instance = 0; instance < frame.instances->size() && instance < numbered.sources.size(); ++instance) {
    const InstanceSource& source = numbered.sources[instance];
    const Instance& placed = (*frame.instances)[instance];
    sums.resize(std::max<size_t>(sums.size(), source.sceneInstance + size_t{1}));
    InstanceSums& sum = sums[source.sceneInstance];
    sum.mesh = source.mesh;
    sum.dynamic = instance >= numbered.staticInstanceCount;
    sum.triangles += placed.triangleCount;
    for (size_t index = placed.firstWorldTriangle; index < size_t(placed.firstWorldTriangle) + placed.triangleCount; ++index) {
      sum.stored += counts.stored[index];
      sum.lost += countAt(counts.lost, index);
      sum.rays += countAt(counts.rays, index);
    }
  }
  return sums;
}

enum InstanceState : uint32_t { kStatic, kDynamic, kHidden, kRemoved };

InstanceState stateOf(const FrameSnapshot& frame, uint32_t sceneInstance, bool dynamic) {
  InstanceState state = dynamic ? kDynamic : kStatic;
  for (const InstanceEdit& edit : frame.request.edits) {
    if (edit.sceneInstance != sceneInstance) continue;
    if (edit.kind == InstanceEdit::Kind::hide) state = kHidden;
    if (edit.kind == InstanceEdit::Kind::remove) state = kRemoved;
  }
  return state;
}

Sheet instanceSheet(const FrameSnapshot& frame, const std::optional<PixelArea>& area) {
  const std::vector<InstanceSums> sums = sumInstances(frame);
  std::vector<std::string> meshes = namesUpTo(frame.scene->names.meshes, meshCount(*frame.scene), "mesh");
  Sheet sheet{.name = "instances"};
  sheet.columns = {words("instance", "Its node's name", namesUpTo(frame.scene->names.instances, sums.size(), "instance")),
                   words("mesh", "Name in the file", {}),
                   words("state", "Dynamic: cleared and added again every frame", {"static", "dynamic", "hidden", "removed"}),
                   numbers("triangles", "Of its mesh"),
                   numbers("stored", "References to its triangles in the grid"),
                   numbers("lost", "References to its triangles that found no slot", ColumnKind::whole, bool(frame.ledger)),
                   numbers("rays lost", "Rays that should have hit it and do not agree", ColumnKind::whole, frame.ledger && frame.truths)};
  const AreaTargets targets = area ? targetsOf(frame, *area) : AreaTargets{};
  for (uint32_t instance = 0; instance < sums.size(); ++instance) {
    const InstanceSums& sum = sums[instance];
    const InstanceState state = stateOf(frame, instance, sum.dynamic);
    if (!sum.mesh && state != kHidden && state != kRemoved) continue;
    double mesh = sum.mesh.value_or(0);
    if (!sum.mesh) mesh = double(meshes.size()), meshes.push_back(nameAt(frame.scene->meshOfInstance, instance, "mesh"));
    addRow(sheet, instance, {double(instance), mesh, double(state), sum.triangles, sum.stored, sum.lost, sum.rays});
    if (area) sheet.inArea.push_back(instance < targets.instances.size() && targets.instances[instance]);
  }
  sheet.columns[at(InstanceColumn::mesh)].words = std::move(meshes);
  return sheet;
}

std::vector<std::string> truthWords(const TruthName& (*nameOf)(uint32_t), uint32_t count) {
  std::vector<std::string> list(count);
  for (uint32_t index = 0; index < count; ++index) list[index] = nameOf(index).title;
  return list;
}

Sheet raySheet(const FrameSnapshot& frame, const std::optional<PixelArea>& area) {
  const FrameSettings& settings = *frame.request.settings;
  const bool truth = frame.truths && frame.truths->size() == frame.hits->size();
  const bool counted = frame.counters && frame.counters->size() == frame.hits->size();
  Sheet sheet{.name = "rays"};
  sheet.columns = {places("pixel", "x, y; 0, 0 is the top left", ivec3(int(settings.width), int(settings.height), 0)),
                   words("kind", "How the ray ended", {"no ray", "triangle hit", "voxel hit", "miss", "limit", "unfinished", "cut"}),
                   numbers("t", "Distance of the hit along the ray, world units", ColumnKind::decimal),
                   numbers("visits", "Cells whose first slot was read", ColumnKind::whole, counted),
                   numbers("tests", "Triangle tests begun", ColumnKind::whole, counted),
                   words("verdict", "What the hit is worth beside the exact one", truthWords(verdictName, kVerdictCount)),
                   words("cause", "The first event along the ray that made it differ", truthWords(causeName, kCauseCount))};
  sheet.columns[at(RayColumn::verdict)].known = sheet.columns[at(RayColumn::cause)].known = truth;
  for (uint32_t pixel = 0; pixel < frame.hits->size(); ++pixel) {
    const Hit& hit = (*frame.hits)[pixel];
    if (hit.kind == kHitNoRay || hit.kind > kHitCut) continue;
    const bool found = hit.kind == kHitTriangle || hit.kind == kHitVoxel;
    const RayTruth* told = truth ? &(*frame.truths)[pixel] : nullptr;
    addRow(sheet, pixel,
           {double(pixel), double(hit.kind), found ? double(hit.t) : NAN, counted ? double((*frame.counters)[pixel].visits) : NAN,
            counted ? double((*frame.counters)[pixel].tests) : NAN, told ? double(told->verdict) : NAN,
            told && told->cause != kCauseNone ? double(told->cause) : NAN});
    if (area) sheet.inArea.push_back(contains(*area, pixel, settings.width));
  }
  return sheet;
}

}  // namespace

bool canMakeSheet(TableKind kind, const FrameSnapshot& frame) {
  if (!frame.scene || !frame.request.settings) return false;
  if (kind == TableKind::rays) return bool(frame.hits);
  return frame.grid && (kind == TableKind::cells || (frame.instances && frame.worldTriangles));
}

Sheet makeSheet(TableKind kind, const FrameSnapshot& frame, const std::optional<PixelArea>& area) {
  if (!canMakeSheet(kind, frame)) return {};
  switch (kind) {
    case TableKind::cells: return cellSheet(frame, area);
    case TableKind::instances: return instanceSheet(frame, area);
    case TableKind::triangles: return triangleSheet(frame, area);
    case TableKind::rays: return raySheet(frame, area);
  }
  return {};
}

std::vector<const void*> sheetSources(TableKind kind, const FrameSnapshot& frame) {
  std::vector<const void*> sources = {frame.scene.get(), frame.truths.get()};
  if (kind == TableKind::rays) {
    sources.insert(sources.end(), {frame.hits.get(), frame.counters.get()});
  } else {
    sources.insert(sources.end(), {frame.grid.get(), frame.ledger.get(), frame.instances.get(), frame.worldTriangles.get()});
    if (kind == TableKind::cells) sources.push_back(frame.cellRays.get());
  }
  return sources;
}

}  // namespace gridscope
