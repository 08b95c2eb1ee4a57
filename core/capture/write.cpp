// Writes captures, whole or not at all.
#include "core/base/write_file.h"
#include "core/capture/capture.h"
#include "core/capture/check.h"
#include "core/capture/columns.h"
#include "core/capture/manifest.h"
#include "core/capture/zip.h"

namespace gridscope {

namespace {

// The first dimensions of a part's columns.
std::vector<uint64_t> leadShape(const Capture& capture, const ColumnRow& column, const PartRow& part, uint64_t count) {
  switch (part.lead) {
    case Lead::count: return {count};
    case Lead::triangleCorners: return {count / 3, 3};
    case Lead::grid: return gridArrayOf(capture.grid, column.entry).shape;
    case Lead::pixels: break;
  }
  return {capture.settings.height, capture.settings.width};
}

class CaptureFormatter {
 public:
  // Nothing of the capture is changed: the arrays are only looked at.
  explicit CaptureFormatter(const Capture& capture) : capture_(capture), arrays_{const_cast<Capture&>(capture), {}} {
    for (size_t i = 0; i < capture.scene.instances.size(); ++i) {
      const Instance& instance = capture.scene.instances[i];
      const InstanceSource& source = capture.scene.sources[i];
      arrays_.instances.push_back({instance.firstTriangle, instance.triangleCount, source.mesh, source.sceneInstance, instance.material});
    }
  }

  std::vector<std::byte> format() {
    Json manifest = makeManifest(capture_);
    if (!capture_.unknownKeys.empty()) addKeys(manifest, Json::parse(capture_.unknownKeys));
    manifest["entries"] = Json::object();

    // Arrays in the table's order; the manifest, which lists them, comes first in the file.
    std::vector<CaptureEntryBytes> entries;
    for (const ColumnRow& column : captureColumns()) {
      if (partBytes(arrays_, column.part, 0).empty()) continue;
      const std::vector<uint64_t> shape = shapeOf(column);
      manifest["entries"][column.entry] = {{"dtype", npyTypeName(column.type)}, {"shape", shape}};
      entries.push_back({column.entry, packed(column, shape)});
    }
    for (const CaptureEntryBytes& unknown : capture_.unknownEntries) listUnknown(unknown, manifest["entries"]);

    ZipWriter zip;
    const std::string text = manifest.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    if (text.size() > kMostManifestBytes)
      throw Error("manifest.json: would have " + std::to_string(text.size()) + " bytes, more than is read again; capture fewer frames");
    zip.add(kManifestEntry, {first, first + text.size()});
    for (CaptureEntryBytes& entry : entries) zip.add(entry.name, std::move(entry.bytes));
    if (!capture_.preview.empty()) zip.add("preview.png", capture_.preview);
    for (const CaptureEntryBytes& unknown : capture_.unknownEntries) zip.add(unknown.name, unknown.bytes);
    return zip.finish();
  }

 private:
  // Is a part the same in every frame? Then it is stored once.
  bool changes(Part part) {
    const std::span<const std::byte> first = partBytes(arrays_, part, 0);
    for (size_t frame = 1; frame < capture_.frames.size() && partRow(part).perFrame; ++frame)
      if (std::memcmp(first.data(), partBytes(arrays_, part, frame).data(), first.size()) != 0) return true;
    return false;
  }

  std::vector<uint64_t> shapeOf(const ColumnRow& column) {
    const PartRow& part = partRow(column.part);
    const uint64_t count = partBytes(arrays_, column.part, 0).size() / part.elementBytes;
    if (column.part == Part::alpha) return {4 * count};
    std::vector<uint64_t> shape = leadShape(capture_, column, part, count);
    shape.insert(shape.end(), column.tail.begin(), column.tail.end());
    if (changes(column.part)) shape.insert(shape.begin(), capture_.frames.size());
    return shape;
  }

  std::vector<std::byte> packed(const ColumnRow& column, const std::vector<uint64_t>& shape) {
    std::vector<std::byte> file = formatNpyHeader(column.type, shape);
    const size_t header = file.size(), bytes = npyByteCount(column.type, shape);
    file.resize(header + bytes);
    const size_t frames = changes(column.part) ? capture_.frames.size() : 1;
    for (size_t frame = 0; frame < frames; ++frame)
      packColumn(column, partBytes(arrays_, column.part, frame), file.data() + header + frame * (bytes / frames));
    return file;
  }

  static void listUnknown(const CaptureEntryBytes& unknown, Json& entries) {
    if (findColumn(unknown.name) != nullptr || unknown.name == kManifestEntry || !isEntryName(unknown.name))
      throw Error(unknown.name + ": can't be an unknown entry's name");
    if (!unknown.name.ends_with(".npy")) return;
    try {
      const NpyHeader header = parseNpyHeader(unknown.bytes);
      entries[unknown.name] = {{"dtype", npyTypeName(header.type)}, {"shape", header.shape}};
    } catch (const Error&) {  // an array of a kind that we can't list is kept all the same
    }
  }

  const Capture& capture_;
  CaptureArrays arrays_;
};

}  // namespace

std::vector<std::byte> formatCapture(const Capture& capture) {
  checkCapture(capture);
  return CaptureFormatter(capture).format();
}

void writeCapture(const std::filesystem::path& file, const Capture& capture) {
  try {
    const std::vector<std::byte> bytes = formatCapture(capture);
    writeWholeFile(file, bytes);
  } catch (const Error& error) {
    throw error.within(file.string());
  } catch (const std::bad_alloc&) {
    throw Error(file.string() + ": can't be saved: not enough memory; the file that was there is unchanged");
  }
}

}  // namespace gridscope
