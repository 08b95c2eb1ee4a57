// The statistics table; see report.h.
#include "app/report/report.h"

#include "app/base/text.h"

namespace gridscope {

namespace {

std::string sceneText(const Session& session, const FrameReport& frame) {
  const NumberedScene& numbered = session.pipeline().numbered();
  return printed("%s: %s triangles (%s without area), %u instances (%u static, %u dynamic), %zu materials", session.scene().name.c_str(),
                 grouped(numbered.triangleCount).c_str(), grouped(frame.triangles.degenerate).c_str(), numbered.instanceCount(),
                 numbered.staticInstanceCount, numbered.dynamicInstanceCount(), session.scene().materials.size());
}

std::string storedText(const char* kind, uint64_t stored, uint64_t refused) {
  return printed("%s: %s stored, %s refused (%s)", kind, grouped(stored).c_str(), grouped(refused).c_str(),
                 percentOf(refused, stored + refused).c_str());
}

void addReferences(Table& table, const FrameReport& frame, bool countsRefused) {
  const GridStatistics& s = frame.grid.statistics;
  const std::string outside = frame.triangles.outside == 0 ? "" : grouped(frame.triangles.outside) + " triangles reach beyond the grid";
  if (!countsRefused) return table.add({"references", grouped(frame.grid.stored()) + " stored; the grid does not count what it refuses"});
  table.add({"references", grouped(frame.tried) + " tried; " + storedText("in all", frame.grid.stored(), frame.grid.refused())});
  table.add({"", storedText("static", s.staticStored, s.staticRefused) + "; " + storedText("dynamic", s.dynamicStored, s.dynamicRefused)});
  if (!outside.empty()) table.add({"", outside});
}

void addCells(Table& table, const FrameReport& frame, const GridParameters& grid) {
  const GridStatistics& s = frame.grid.statistics;
  const uint64_t cells = uint64_t(grid.cellCount.x) * uint64_t(grid.cellCount.y) * uint64_t(grid.cellCount.z);
  table.add({"cells", printed("%s of %s occupied (%s), %s saturated (%s of those); the fullest wants %s references",
                              grouped(s.occupied).c_str(), grouped(cells).c_str(), percentOf(s.occupied, cells).c_str(),
                              grouped(s.saturated).c_str(), percentOf(s.saturated, s.occupied).c_str(), grouped(s.maxDemand).c_str())});
}

void addUpdate(Table& table, const Session& session, const FrameReport& frame) {
  if (session.pipeline().numbered().dynamicInstanceCount() == 0) return;
  const ivec3 count = session.pipeline().parameters().grid.cellCount;
  const uint64_t cells = uint64_t(count.x) * uint64_t(count.y) * uint64_t(count.z);
  const bool moved = session.pipeline().settings().grid.update == UpdateMode::moved;
  table.add({"update", printed("%s: %s cells rebuilt (%s), %s touched", moved ? "moved" : "all", grouped(frame.update.cellsRebuilt).c_str(),
                               percentOf(frame.update.cellsRebuilt, cells).c_str(), grouped(frame.update.cellsTouched).c_str())});
}

void addRays(Table& table, const FrameReport& frame) {
  const RayTotals& rays = frame.rays;
  table.add({"rays", printed("%s: %s triangle hits (%s), %s voxel hits (%s), %s misses (%s)", grouped(rays.count).c_str(),
                             grouped(rays.triangleHits).c_str(), percentOf(rays.triangleHits, rays.count).c_str(),
                             grouped(rays.voxelHits).c_str(), percentOf(rays.voxelHits, rays.count).c_str(), grouped(rays.misses).c_str(),
                             percentOf(rays.misses, rays.count).c_str())});
  if (!frame.counters) return;
  auto text = [](const Summary& s) {
    return printed("mean %.2f, 99 %% at most %s, max %s a ray", s.mean, grouped(s.p99).c_str(), grouped(s.max).c_str());
  };
  table.add({"visits", text(frame.counters->visits)});
  table.add({"tests", text(frame.counters->tests)});
}

std::string timesText(const StageTimes& t) {
  return printed("build %.2f, clear %.2f, add %.2f, gather %.2f, bounce %.2f, trace %.2f, views %.2f", t.build, t.clear, t.add, t.gather,
                 t.bounce, t.trace, t.views);
}

}  // namespace

FrameReport reportFrame(Session& session, uint32_t frame, bool counted) {
  Pipeline& pipeline = session.pipeline();
  const std::vector<Hit> hits = pipeline.hits();
  FrameReport report{.frame = frame, .timeSeconds = session.frameTime(frame)};
  report.grid = pipeline.gridTotals();
  report.tried = pipeline.referencesTried();
  report.triangles = countTriangles(pipeline.parameters().grid, pipeline.worldTriangles());
  report.rays = countRays(hits);
  if (counted) report.counters = summariseCounters(pipeline.counters(), hits);
  report.times = pipeline.times();
  report.update = pipeline.updateReport();
  return report;
}

Table reportTable(const Session& session, const RenderReport& report) {
  const FrameReport& frame = report.frames.back();
  const GridParameters& grid = session.pipeline().parameters().grid;
  Table table("ll");
  table.add({"scene", sceneText(session, frame)});
  table.add({"device", session.deviceName() + ", " + session.deviceReport().driver});
  table.add({"grid", gridText(grid) + ", " + storageText(grid) + ", " + byteText(gridByteCount(grid))});
  addReferences(table, frame, gridAbilities(grid).countsRefusals);
  if (session.canRebuild()) table.add({"", refusedFirst(session.pipeline().settings().grid)});
  addCells(table, frame, grid);
  addUpdate(table, session, frame);
  addRays(table, frame);
  table.add({"times (ms)", timesText(frame.times)});
  if (report.startMs > 0.0) table.add({"start (ms)", printed("%.0f", report.startMs)});
  if (report.frames.size() > 1) table.add({"frames", grouped(report.frames.size()) + ", the last of which is above"});
  return table;
}

void printReport(std::FILE* out, const Session& session, const RenderReport& report) { reportTable(session, report).print(out); }

void printExact(std::FILE* out, const ExactComparison& exact, uint32_t frameWidth) {
  std::fprintf(out, "%-12s%zu of %u rays differ from the nearest hit among all triangles\n", "exact", exact.differences.size(),
               exact.compared);
  constexpr size_t kMostLines = 20;
  for (size_t i = 0; i < std::min(kMostLines, exact.differences.size()); ++i) {
    const ExactDifference& difference = exact.differences[i];
    std::fprintf(out, "            pixel %u,%u: t %.7g, exact %.7g, reference 0x%08X, exact 0x%08X%s\n", difference.ray % frameWidth,
                 difference.ray / frameWidth, difference.traced.t, difference.exact.t, difference.traced.reference,
                 difference.exact.reference, difference.grazes ? ", grazes an edge" : "");
  }
}

}  // namespace gridscope
