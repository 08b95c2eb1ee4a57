// gridscope inspect: what captures hold. Manifest and entries come from the directory alone; the statistics need the products.
#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/report.h"
#include "app/session/capture_files.h"
#include "core/base/error.h"
#include "core/base/npy.h"
#include "core/capture/capture.h"

namespace gridscope {

namespace {

using Json = nlohmann::ordered_json;

// Of the last frame, where it holds the products.
struct CaptureStatistics {
  size_t frames = 0;
  uint32_t instances = 0, staticInstances = 0, triangles = 0;
  std::optional<GridTotals> grid;
  std::optional<RayTotals> rays;
  std::optional<CounterTotals> counters;
  std::vector<std::string> faults;
};

CaptureStatistics statisticsOf(const Capture& capture) {
  CaptureStatistics s{.frames = capture.frames.size(),
                      .instances = capture.scene.instanceCount(),
                      .staticInstances = capture.scene.staticInstanceCount,
                      .triangles = capture.scene.triangleCount,
                      .faults = capture.faults};
  const CaptureFrame& last = capture.frames.back();
  if (!last.grid.empty()) s.grid = countGrid(frameGrid(capture, capture.frames.size() - 1));
  if (!last.hits.empty()) s.rays = countRays(last.hits);
  if (!last.hits.empty() && !last.counters.empty()) s.counters = summariseCounters(last.counters, last.hits);
  return s;
}

void printEntries(std::FILE* out, const CaptureDirectory& directory) {
  Table table("lllrr");
  table.add({"  entry", "type", "shape", "bytes", "in the file"});
  for (const CaptureEntry& entry : directory.entries)
    table.add({"  " + entry.name, entry.type, entry.type.empty() ? "" : npyShapeText(entry.shape), grouped(entry.bytes),
               grouped(entry.compressedBytes)});
  table.print(out);
}

void printStatistics(std::FILE* out, const Capture& capture, const CaptureStatistics& s) {
  Table table("ll");
  table.add({"  frames", printed("%zu of %u x %u pixels", s.frames, capture.settings.width, capture.settings.height)});
  table.add({"  scene", printed("%s: %s triangles, %u instances (%u static)", capture.names.scene.c_str(), grouped(s.triangles).c_str(),
                                s.instances, s.staticInstances)});
  table.add({"  grid", gridText(capture.grid) + ", " + storageText(capture.grid) + ", " + refusalText(capture.grid)});
  if (s.grid)
    table.add({"  references", printed("%s stored, %s refused; %s cells occupied, %s saturated", grouped(s.grid->stored()).c_str(),
                                       grouped(s.grid->refused()).c_str(), grouped(s.grid->statistics.occupied).c_str(),
                                       grouped(s.grid->statistics.saturated).c_str())});
  if (s.rays)
    table.add(
        {"  rays", printed("%s: %s triangle hits, %s voxel hits, %s misses", grouped(s.rays->count).c_str(),
                           grouped(s.rays->triangleHits).c_str(), grouped(s.rays->voxelHits).c_str(), grouped(s.rays->misses).c_str())});
  if (s.counters) table.add({"  visits, tests", printed("mean %.2f and %.2f a ray", s.counters->visits.mean, s.counters->tests.mean)});
  for (const std::string& fault : s.faults) table.add({"  left out", fault});
  table.print(out);
}

Json directoryJson(const std::filesystem::path& file, const CaptureDirectory& directory, const CaptureStatistics& s) {
  Json entries = Json::array();
  for (const CaptureEntry& entry : directory.entries)
    entries.push_back({{"name", entry.name},
                       {"type", entry.type},
                       {"shape", entry.shape},
                       {"bytes", entry.bytes},
                       {"compressedBytes", entry.compressedBytes}});
  Json json = {{"file", file.string()},        {"formatVersion", directory.version},
               {"bytes", directory.fileBytes}, {"manifest", Json::parse(directory.manifest)},
               {"entries", entries},           {"frames", s.frames},
               {"triangles", s.triangles},     {"instances", s.instances}};
  if (s.grid)
    json["references"] = {{"stored", s.grid->stored()},
                          {"refused", s.grid->refused()},
                          {"occupied", s.grid->statistics.occupied},
                          {"saturated", s.grid->statistics.saturated}};
  if (s.rays)
    json["rays"] = {
        {"count", s.rays->count}, {"triangleHits", s.rays->triangleHits}, {"voxelHits", s.rays->voxelHits}, {"misses", s.rays->misses}};
  if (!s.faults.empty()) json["leftOut"] = s.faults;
  return json;
}

Json inspect(const std::filesystem::path& file, const Options& options) {
  const CaptureDirectory directory = listCapture(file);
  const Capture capture = readCapture(
      file, {.salvage = options.captures.salvage, .products = {.gather = false, .rays = false, .preview = false}, .unknownEntries = false});
  const CaptureStatistics statistics = statisticsOf(capture);
  std::FILE* out = textStream(options);
  std::fprintf(out, "%s: %s, format %u, written by %s on %s, %s\n", file.string().c_str(), byteText(directory.fileBytes).c_str(),
               directory.version, capture.writer.c_str(), capture.device.c_str(), capture.driver.c_str());
  if (!capture.note.empty()) std::fprintf(out, "  %s\n", capture.note.c_str());
  printStatistics(out, capture, statistics);
  printEntries(out, directory);
  return directoryJson(file, directory, statistics);
}

}  // namespace

void addInspectOptions(CLI::App& command, Options& options) {
  addFilesOption(command, options, "Captures, or folders of them");
  addJsonOption(command, options);
}

int runInspect(const Options& options) {
  Json captures = Json::array();
  for (const std::filesystem::path& file : captureFiles(options.captures.files)) captures.push_back(inspect(file, options));
  writeJson(options, {{"captures", captures}});
  return kExitDone;
}

}  // namespace gridscope
