// gridscope diff: two captures by meaning.
#include <cstring>

#include "app/commands/commands.h"
#include "app/report/capture_pictures.h"
#include "app/report/diff.h"
#include "app/report/report.h"
#include "app/session/capture_files.h"
#include "core/base/error.h"

namespace gridscope {

// The first frame whose grids or hits differ and have one shape; nothing when there is none.
static std::optional<TwoSides> firstDifferent(const Capture& a, const Capture& b, const CaptureDifferences& differences) {
  for (const FrameDifferences& frame : differences.frames) {
    const bool grids = frame.cells.different() > 0 && storedAlike(a.grid, b.grid);
    if (frame.hits.different() == 0 && !grids) continue;
    TwoSides sides{.hitsA = {}, .hitsB = {}, .gridA = {a.grid, a.frames[frame.frame].grid}, .gridB = {b.grid, b.frames[frame.frame].grid}};
    sides.width = a.settings.width, sides.height = a.settings.height;
    if (frame.hits.different() > 0) sides.hitsA = a.frames[frame.frame].hits, sides.hitsB = b.frames[frame.frame].hits;
    return sides;
  }
  return std::nullopt;
}

void addDiffOptions(CLI::App& command, Options& options) {
  addFilesOption(command, options, "A and B", 2);
  addDifferenceFolderOption(command, options);
  addJsonOption(command, options);
}

int runDiff(const Options& options) {
  const auto read = [&](size_t i) {
    return readCapture(options.captures.files.at(i), {.salvage = options.captures.salvage, .unknownEntries = false});
  };
  const Capture a = read(0), b = read(1);
  const CaptureDifferences differences = diffCaptures(a, b);

  std::vector<std::string> pictures;
  if (!options.captures.differences.empty())
    if (const std::optional<TwoSides> sides = firstDifferent(a, b, differences))
      pictures = writeDifference(options.captures.differences, pictureName(options.captures.files[1]), *sides);

  std::FILE* out = textStream(options);
  for (const std::string& line : differenceLines(differences)) std::fprintf(out, "%s\n", line.c_str());
  for (const std::string& file : pictures) std::fprintf(out, "%s\n", file.c_str());
  if (differences.equal()) std::fprintf(out, "equal\n");
  nlohmann::ordered_json json = differencesJson(differences);
  json["pictures"] = pictures;
  writeJson(options, json);
  return differences.equal() ? kExitDone : kExitDifferent;
}

}  // namespace gridscope
