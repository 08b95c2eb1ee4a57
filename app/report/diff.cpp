// See diff.h.
#include "app/report/diff.h"

#include "app/base/text.h"

namespace gridscope {

static std::string cellsText(const CellDifferences& cells) {
  return printed("%s of %s cells: %s in A alone, %s in B alone, %s with other references, %s with other refusals; the first: ",
                 grouped(cells.different()).c_str(), grouped(cells.total).c_str(), grouped(cells.onlyA).c_str(),
                 grouped(cells.onlyB).c_str(), grouped(cells.otherReferences).c_str(), grouped(cells.otherRefused).c_str()) +
         cells.first;
}

static std::string hitsText(const HitDifferences& hits) {
  return printed("%s of %s hits: %s of another kind, %s on another triangle, %s at another distance; the first: ",
                 grouped(hits.different()).c_str(), grouped(hits.total).c_str(), grouped(hits.otherKind).c_str(),
                 grouped(hits.otherTriangle).c_str(), grouped(hits.otherDistance).c_str()) +
         hits.first;
}

std::vector<std::string> differenceLines(const CaptureDifferences& differences) {
  std::vector<std::string> lines;
  for (const SettingDifference& setting : differences.settings) lines.push_back(setting.name + ": A " + setting.a + ", B " + setting.b);
  for (const std::string& line : differences.notCompared)
    if (!line.ends_with("in neither")) lines.push_back(line);
  for (const FrameDifferences& frame : differences.frames) {
    const std::string which = differences.frames.size() > 1 ? printed("frame %zu, ", frame.frame) : "";
    if (frame.cells.different() > 0) lines.push_back(which + cellsText(frame.cells));
    if (!frame.rays.equal()) lines.push_back(which + "rays: " + frame.rays.text());
    if (frame.hits.different() > 0) lines.push_back(which + hitsText(frame.hits));
    if (!frame.counters.equal()) lines.push_back(which + "counters: " + frame.counters.text());
    if (!frame.exact.equal()) lines.push_back(which + "exact: " + frame.exact.text());
  }
  return lines;
}

static nlohmann::ordered_json cellsJson(const CellDifferences& cells) {
  return {{"onlyA", cells.onlyA}, {"onlyB", cells.onlyB}, {"otherReferences", cells.otherReferences}, {"otherRefused", cells.otherRefused},
          {"total", cells.total}, {"first", cells.first}};
}

static nlohmann::ordered_json hitsJson(const HitDifferences& hits) {
  return {{"otherKind", hits.otherKind},
          {"otherTriangle", hits.otherTriangle},
          {"otherDistance", hits.otherDistance},
          {"total", hits.total},
          {"first", hits.first}};
}

nlohmann::ordered_json differencesJson(const CaptureDifferences& differences) {
  using Json = nlohmann::ordered_json;
  Json json = {
      {"equal", differences.equal()}, {"settings", Json::array()}, {"notCompared", differences.notCompared}, {"frames", Json::array()}};
  for (const SettingDifference& setting : differences.settings)
    json["settings"].push_back({{"name", setting.name}, {"a", setting.a}, {"b", setting.b}});
  for (const FrameDifferences& frame : differences.frames)
    json["frames"].push_back(
        {{"cells", cellsJson(frame.cells)},
         {"hits", hitsJson(frame.hits)},
         {"rays", {{"different", frame.rays.different}, {"total", frame.rays.total}}},
         {"counters", {{"different", frame.counters.different}, {"total", frame.counters.total}, {"first", frame.counters.first}}},
         {"exact", {{"different", frame.exact.different}, {"total", frame.exact.total}, {"first", frame.exact.first}}}});
  return json;
}

}  // namespace gridscope
