// Results as JSON; see report.h.
#include "app/report/report.h"

#include <filesystem>
#include <fstream>
#include <iostream>

#include "core/base/error.h"
#include "core/base/version.h"

namespace gridscope {

using Json = nlohmann::ordered_json;

static Json vectorJson(const vec3& v) { return Json::array({v.x, v.y, v.z}); }
static Json vectorJson(const ivec3& v) { return Json::array({v.x, v.y, v.z}); }

static Json referencesJson(const FrameReport& frame) {
  const GridStatistics& s = frame.grid.statistics;
  return {{"tried", frame.tried},
          {"stored", frame.grid.stored()},
          {"refused", frame.grid.refused()},
          {"outside", frame.triangles.outside},
          {"staticStored", s.staticStored},
          {"staticRefused", s.staticRefused},
          {"dynamicStored", s.dynamicStored},
          {"dynamicRefused", s.dynamicRefused}};
}

static Json cellsJson(const FrameReport& frame) {
  const GridStatistics& s = frame.grid.statistics;
  return {{"occupied", s.occupied},
          {"saturated", s.saturated},
          {"maxDemand", s.maxDemand},
          {"occupancyHistogram", frame.grid.occupancyHistogram}};
}

static Json raysJson(const RayTotals& rays) {
  return {{"count", rays.count}, {"triangleHits", rays.triangleHits}, {"voxelHits", rays.voxelHits}, {"misses", rays.misses}};
}

static Json summaryJson(const Summary& summary) { return {{"mean", summary.mean}, {"p99", summary.p99}, {"max", summary.max}}; }

static Json timesJson(const StageTimes& t) {
  return {{"build", t.build},   {"clear", t.clear}, {"add", t.add},    {"gather", t.gather},
          {"bounce", t.bounce}, {"trace", t.trace}, {"views", t.views}};
}

static Json frameJson(const FrameReport& frame, const GridParameters& grid) {
  const uint64_t cells = uint64_t(grid.cellCount.x) * uint64_t(grid.cellCount.y) * uint64_t(grid.cellCount.z);
  return {{"frame", frame.frame},
          {"timeSeconds", frame.timeSeconds},
          {"references", referencesJson(frame)},
          {"cells", cellsJson(frame)},
          {"rays", raysJson(frame.rays)},
          {"timesMs", timesJson(frame.times)},
          {"update", {{"cellsRebuilt", frame.update.cellsRebuilt}, {"cellsTouched", frame.update.cellsTouched}, {"cells", cells}}}};
}

Json deviceJson(const Session& session) {
  return {{"version", kVersion},
          {"device", session.deviceName()},
          {"driver", session.deviceReport().driver},
          {"vulkanDevice", session.deviceReport().name}};
}

Json sceneJson(const Session& session) {
  const NumberedScene& numbered = session.pipeline().numbered();
  return {{"name", session.scene().name},
          {"triangles", numbered.triangleCount},
          {"instances", numbered.instanceCount()},
          {"staticInstances", numbered.staticInstanceCount},
          {"dynamicInstances", numbered.dynamicInstanceCount()},
          {"materials", session.scene().materials.size()}};
}

Json gridJson(const GridParameters& grid) {
  return {{"cells", vectorJson(grid.cellCount)},
          {"capacity", grid.capacity},
          {"stride", storageFacts(grid).wordsPerCell},
          {"stretch", std::string(1, storageFacts(grid).stretchedAxis)},
          {"cellEdge", grid.cellEdge},
          {"origin", vectorJson(grid.origin)},
          {"bytes", gridByteCount(grid)}};
}

Json reportJson(const Session& session, const RenderReport& report) {
  const GridParameters& grid = session.pipeline().parameters().grid;
  const FrameSettings& settings = session.pipeline().settings();
  Json json = deviceJson(session);
  json["size"] = {settings.width, settings.height};
  json["scene"] = sceneJson(session);
  json["grid"] = gridJson(grid);
  json["pictures"] = report.pictures;
  json["warnings"] = session.scene().warnings;
  if (report.exact) json["checkExact"] = {{"compared", report.exact->compared}, {"different", report.exact->differences.size()}};
  if (report.check) json["checkCpu"] = {{"equal", report.check->empty()}, {"first", *report.check}};
  if (report.frames.empty()) return json;

  // Of the last frame.
  const FrameReport& last = report.frames.back();
  json["scene"]["degenerate"] = last.triangles.degenerate;
  json["references"] = referencesJson(last);
  json["cells"] = cellsJson(last);
  json["rays"] = raysJson(last.rays);
  if (report.foreignHits) json["foreignHits"] = *report.foreignHits;
  if (last.counters) json["visits"] = summaryJson(last.counters->visits);
  if (last.counters) json["tests"] = summaryJson(last.counters->tests);
  json["timesMs"] = timesJson(last.times);
  json["timesMs"]["start"] = report.startMs;
  if (report.frames.size() > 1)
    for (const FrameReport& frame : report.frames) json["frames"].push_back(frameJson(frame, grid));
  return json;
}

void writeJson(const Options& options, const Json& results) {
  if (options.json.empty()) return;

  // Names come from files: what is no UTF-8 is replaced.
  const std::string text = results.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (options.json == "-") {
    std::cout << text << std::flush;
    if (!std::cout) throw Error("--json -: standard output can't be written");
    return;
  }
  const std::filesystem::path path = options.json;
  std::error_code ignored;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ignored);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!(file << text << std::flush)) throw Error("--json " + options.json + ": can't be written; check folder, permissions and space");
}

}  // namespace gridscope
