// Reads captures: the directory and the manifest first, then, once everything they say agrees and fits into memory, the arrays.
#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <string_view>

#include "core/base/gltf_files.h"
#include "core/capture/capture.h"
#include "core/capture/check.h"
#include "core/capture/columns.h"
#include "core/capture/manifest.h"
#include "core/capture/zip.h"
#include "shaders/shared/trace/ray.h"

namespace gridscope {

namespace {

constexpr const char* kPreviewEntry = "preview.png";
constexpr std::string_view kPngSignature{"\x89PNG\r\n\x1a\n", 8};
constexpr uint64_t kMostNpyHeader = 65536 + 12;  // npy.cpp reads no longer one
constexpr uint64_t kMostUnnamed = 65536;         // meshes, instances and materials that get a name from their number

// An array that is there and can be read.
struct FoundColumn {
  const ColumnRow* column;
  const ZipEntry* entry;
  const ListedEntry* listed;
  bool framed;     // has a leading frame axis
  uint64_t count;  // elements of its part, a frame
};

size_t leadRank(Lead lead) { return lead == Lead::count ? 1 : lead == Lead::grid ? 3 : 2; }

class CaptureReader {
 public:
  CaptureReader(ZipReader& zip, const ReadOptions& options) : zip_(zip), options_(options) {}

  Capture read() {
    // What is there, by the directory and by the manifest.
    manifest_ = parseManifestOf(zip_);
    atManifest([&] { findColumns(); });

    // Everything that is not an array; the arrays' shapes must follow from it.
    arrays_.capture.frames.resize(frameCount_);
    atManifest([&] { readManifest(manifest_, pixelSize(), arrays_.capture); });
    for (const ColumnRow& column : captureColumns()) atColumn(column, [&] { findShape(column); });
    completeParts();
    checkMemory();

    // The arrays, what is left out, and the whole.
    for (FoundColumn& found : found_)
      if (wanted(found.column->part)) atColumn(*found.column, [&] { readColumn(found); });
    for (Part part : {Part::corners, Part::materials, Part::gather, Part::rays, Part::hits, Part::counters, Part::exact, Part::grid,
                      Part::alpha, Part::numbers})
      if (dropped(part)) clearPart(part);
    finishScene();
    readOthers();
    checkCaptureInputs(capture());
    for (Part part : {Part::grid, Part::gather, Part::rays, Part::hits, Part::counters, Part::exact}) checkProduct(part);
    keepUnknownKeys();
    return std::move(capture_);
  }

  static Json parseManifestOf(ZipReader& zip) {
    const ZipEntry* entry = zip.find(kManifestEntry);
    if (entry == nullptr) throw Error("holds no manifest.json: not a capture");
    try {
      if (entry->bytes > kMostManifestBytes)
        throw Error("has " + std::to_string(entry->bytes) + " bytes; at most " + std::to_string(kMostManifestBytes) + " are read");
      const auto bytes = zip.read(*entry);
      return parseManifest({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const Error& error) {
      throw error.within(kManifestEntry);
    }
  }

 private:
  Capture& capture() { return arrays_.capture; }

  static bool isCore(Part part) { return part == Part::triangles || part == Part::instances || part == Part::rows; }
  bool dropped(Part part) const { return dropped_[static_cast<size_t>(part)]; }
  bool present(Part part) const { return counts_.contains(part) && !dropped(part); }

  bool wanted(Part part) const {
    const CaptureProducts& p = options_.products;
    switch (part) {
      case Part::grid: return p.grid;
      case Part::gather: return p.gather;
      case Part::rays: return p.rays;
      case Part::hits: return p.hits;
      case Part::counters: return p.counters;
      case Part::exact: return p.exact;
      default: return true;
    }
  }

  template <class Work>
  void atManifest(const Work& work) {
    try {
      work();
    } catch (const Error& error) {
      throw error.within(kManifestEntry);
    }
  }

  // A fault of a column ends the reading, or, with --salvage, leaves its part out.
  template <class Work>
  void atColumn(const ColumnRow& column, const Work& work) {
    if (dropped(column.part)) return;
    try {
      work();
    } catch (const Error& error) {
      const Error named = error.within(column.entry);
      if (!options_.salvage || isCore(column.part)) throw named;
      leaveOut(column.part, named);
    }
  }

  void leaveOut(Part part, const Error& error) {
    capture().faults.push_back(std::string(error.what()) + "; left out: " + partRow(part).name);
    dropped_[static_cast<size_t>(part)] = true;
    if (part == Part::alpha) dropped_[static_cast<size_t>(Part::materials)] = true;  // materials lead into the alpha maps
    if (part == Part::materials) dropped_[static_cast<size_t>(Part::alpha)] = true;
  }

  void findColumns() {
    frameCount_ = manifestFrameCount(manifest_);
    for (ListedEntry& entry : listedEntries(manifest_)) {
      if (findColumn(entry.name) == nullptr && zip_.find(entry.name) == nullptr)
        loseUnknown(plainName(entry.name) + ": is missing; the manifest lists it");
      listed_.emplace(entry.name, std::move(entry));
    }
  }

  void loseUnknown(const std::string& fault) {
    if (!options_.salvage) throw Error(fault);
    capture().faults.push_back(fault);
  }

  const ListedEntry* listed(const ColumnRow& column) const {
    const auto entry = listed_.find(column.entry);
    return entry == listed_.end() ? nullptr : &entry->second;
  }

  // Width and height where the manifest has no settings: those of the first array that has pixels.
  PixelSize pixelSize() const {
    for (const ColumnRow& column : captureColumns()) {
      const ListedEntry* entry = listed(column);
      if (entry == nullptr || partRow(column.part).lead != Lead::pixels || entry->shape.size() < column.tail.size() + 2) continue;
      const size_t width = entry->shape.size() - column.tail.size() - 1;
      const auto side = [&](size_t i) { return static_cast<uint32_t>(std::min<uint64_t>(entry->shape[i], UINT32_MAX)); };
      return {side(width), side(width - 1)};
    }
    const FrameSettings defaults;
    return {defaults.width, defaults.height};
  }

  // Compares the array's directory entry, its line in the manifest, and what the other inputs say of its shape.
  void findShape(const ColumnRow& column) {
    const ZipEntry* entry = zip_.find(column.entry);
    const ListedEntry* listed = this->listed(column);
    if (entry == nullptr && listed == nullptr) return;
    if (entry == nullptr) throw Error("is missing; the manifest lists it");
    if (listed == nullptr) throw Error("is not listed in the manifest");
    if (listed->type != column.type)
      throw Error(std::string("is said to hold ") + npyTypeName(listed->type) + " in the manifest; it must hold " +
                  npyTypeName(column.type));

    // Dimensions: an axis of frames, the lead, the tail.
    FoundColumn found{&column, entry, listed, false, 0};
    const PartRow& part = partRow(column.part);
    std::vector<uint64_t> shape = listed->shape;
    if (column.part == Part::alpha && shape.size() == 1 && shape[0] % 4 == 0) shape = {shape[0] / 4, 4};
    const size_t rank = leadRank(part.lead) + column.tail.size();
    found.framed = part.perFrame && shape.size() == rank + 1;
    if (found.framed && shape[0] != frameCount_) throw badShape(column, listed->shape);
    if (found.framed) shape.erase(shape.begin());
    if (shape.size() != rank || !std::equal(column.tail.begin(), column.tail.end(), shape.end() - std::ptrdiff_t(column.tail.size())))
      throw badShape(column, listed->shape);
    found.count = countOf(column, shape);

    // Bytes: the header is all that may come on top.
    const uint64_t bytes = npyByteCount(column.type, listed->shape);
    if (bytes > entry->bytes || entry->bytes - bytes > kMostNpyHeader)
      throw Error("has " + std::to_string(entry->bytes) + " bytes, which do not hold the shape " + npyShapeText(listed->shape) +
                  " that the manifest says");
    const auto [known, first] = counts_.emplace(column.part, found.count);
    if (!first && known->second != found.count)
      throw Error("has the shape " + npyShapeText(listed->shape) + ", which does not fit the other arrays of the " + part.name);
    found_.push_back(found);
  }

  Error badShape(const ColumnRow& column, const std::vector<uint64_t>& shape) const {
    static const std::map<Lead, const char*> kLeads = {
        {Lead::count, "count"}, {Lead::triangleCorners, "triangles, 3"}, {Lead::grid, "z, y, x"}, {Lead::pixels, "height, width"}};
    std::string wanted = "(" + std::string(partRow(column.part).perFrame ? "[frames, ]" : "") + kLeads.at(partRow(column.part).lead);
    for (uint64_t side : column.tail)
      if (column.part != Part::alpha) wanted += ", " + std::to_string(side);
    if (column.part == Part::alpha) wanted = "(a multiple of 4";
    return Error("has the shape " + npyShapeText(shape) + "; it must be " + wanted + ")");
  }

  // Elements that a shape without its frame axis counts.
  uint64_t countOf(const ColumnRow& column, const std::vector<uint64_t>& shape) {
    const Lead lead = partRow(column.part).lead;
    if (lead == Lead::count && shape[0] <= UINT32_MAX) return shape[0];
    if (lead == Lead::triangleCorners && shape[0] <= UINT32_MAX && shape[1] == 3) return 3 * shape[0];
    if (lead == Lead::grid) {
      const std::vector<uint64_t> wanted = gridArrayOf(capture().grid, column.entry).shape;
      if (shape != wanted)
        throw Error("has the shape " + npyShapeText(shape) + " a frame; the manifest's grid has (z, y, x) " + npyShapeText(wanted));
      return gridArrayOf(capture().grid, column.entry).count;
    }
    const FrameSettings& settings = capture().settings;
    if (lead == Lead::pixels && shape[0] == settings.height && shape[1] == settings.width) return shape[0] * shape[1];
    if (lead == Lead::pixels)
      throw Error("has the shape " + npyShapeText(shape) + " a frame; the manifest says " + std::to_string(settings.height) + " rows of " +
                  std::to_string(settings.width) + " pixels");
    throw badShape(column, shape);
  }

  // A part needs all its columns; parts that nothing is said of get their defaults' counts.
  void completeParts() {
    for (const ColumnRow& column : captureColumns()) {
      if (!present(column.part) || column.optional ||
          std::ranges::any_of(found_, [&](const FoundColumn& found) { return found.column == &column; }))
        continue;
      atColumn(column, [&] { throw Error(std::string("is missing; the other arrays of the ") + partRow(column.part).name + " need it"); });
    }
    if (!present(Part::triangles)) throw Error("triangles.npy: is missing; a capture holds geometry");
    const uint64_t triangles = counts_[Part::triangles];
    if (triangles < 1 || triangles > kMostWorldTriangles)
      throw Error("triangles.npy: holds " + std::to_string(triangles) + " triangles, not 1 to " + std::to_string(kMostWorldTriangles));
    ownInstances_ = present(Part::instances);
    ownRows_ = present(Part::rows);
    if (!ownInstances_) counts_[Part::instances] = (triangles + kMostTrianglesPerInstance - 1) / kMostTrianglesPerInstance;
    if (!ownRows_) counts_[Part::rows] = counts_[Part::instances];
    if (counts_[Part::instances] < 1 || counts_[Part::instances] > kMostInstances)
      throw Error("instances.npy: holds " + std::to_string(counts_[Part::instances]) + " instances, not 1 to 65535");
    if (counts_[Part::rows] != counts_[Part::instances]) throw Error("instances_transform.npy: its count is not that of instances.npy");
    if (present(Part::corners) && counts_[Part::corners] != 3 * triangles)
      throw Error("corners_normal.npy: its count is not that of triangles.npy");
    if (present(Part::numbers) && counts_[Part::numbers] != triangles)
      throw Error("triangles_number.npy: its count is not that of triangles.npy");
  }

  // Nothing large is allocated before this.
  void checkMemory() const {
    uint64_t bytes = counts_.at(Part::triangles) * (3 * sizeof(Corner) + sizeof(uint32_t)) + kMostUnnamed * sizeof(TraceMaterial);
    for (const auto& [part, count] : counts_)
      if (wanted(part)) bytes += count * partRow(part).elementBytes * (partRow(part).perFrame ? frameCount_ : 1);
    for (const ZipEntry& entry : zip_.entries())
      if (isOther(entry)) bytes += entry.bytes;
    if (bytes > options_.memoryLimit)
      throw Error("takes " + std::to_string(bytes >> 20) + " MiB in memory; at most " + std::to_string(options_.memoryLimit >> 20) +
                  " MiB are read");
  }

  void readColumn(const FoundColumn& found) {
    const ColumnRow& column = *found.column;
    const std::vector<std::byte> bytes = zip_.read(*found.entry);
    const NpyHeader header = parseNpyHeader(bytes);
    if (header.type != column.type)
      throw Error(std::string("holds ") + npyTypeName(header.type) + "; it must hold " + npyTypeName(column.type));
    if (header.shape != found.listed->shape)
      throw Error("has the shape " + npyShapeText(header.shape) + " where the manifest says " + npyShapeText(found.listed->shape));
    const uint64_t wantedBytes = npyByteCount(header.type, header.shape);
    if (bytes.size() - header.dataOffset != wantedBytes)
      throw Error("has " + std::to_string(bytes.size() - header.dataOffset) + " bytes of data where its shape needs " +
                  std::to_string(wantedBytes));

    const size_t frames = partRow(column.part).perFrame ? frameCount_ : 1;
    const uint64_t frameBytes = found.framed ? wantedBytes / frames : 0;
    for (size_t frame = 0; frame < frames; ++frame) {
      resizePart(arrays_, column.part, frame, found.count);
      unpackColumn(column, bytes.data() + header.dataOffset + frame * frameBytes, partBytes(arrays_, column.part, frame));
    }
    if (std::string_view(column.entry) == "rays_valid.npy") validGiven_ = true;
  }

  void clearPart(Part part) {
    for (size_t frame = 0; frame < (partRow(part).perFrame ? frameCount_ : 1); ++frame) resizePart(arrays_, part, frame, 0);
  }

  // Numbers the scene, with defaults for what the capture does not hold.
  void finishScene() {
    NumberedScene& scene = capture().scene;
    const uint32_t triangles = static_cast<uint32_t>(scene.objectTriangles.size());
    if (!ownInstances_)
      for (uint32_t first = 0; first < triangles; first += kMostTrianglesPerInstance)
        arrays_.instances.push_back({first, std::min(kMostTrianglesPerInstance, triangles - first), 0, 0, 0});
    if (!ownRows_)
      for (CaptureFrame& frame : capture().frames) frame.rows.assign(arrays_.instances.size(), {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}});
    if (!present(Part::corners)) makeCorners();
    if (!present(Part::numbers))
      for (uint32_t i = 0; i < triangles; ++i) scene.meshTriangles.push_back(i);
    addInstances();
    nameUnnamed();
    if (!validGiven_)
      for (CaptureFrame& frame : capture().frames)
        for (Ray& ray : frame.rays) ray.valid = 1;
  }

  // Geometric normals, no texture, white.
  void makeCorners() {
    for (const Triangle& triangle : capture().scene.objectTriangles) {
      const glm::dvec3 normal =
          glm::cross(glm::dvec3(triangle.b) - glm::dvec3(triangle.a), glm::dvec3(triangle.c) - glm::dvec3(triangle.a));
      const double length = glm::length(normal);
      const vec3 unit = length > 0.0 && std::isfinite(length) ? vec3(normal / length) : vec3(0, 1, 0);
      for (int k = 0; k < 3; ++k) capture().scene.corners.push_back({unit, vec2(0), 0xFFFFFFFFu});
    }
  }

  void addInstances() {
    NumberedScene& scene = capture().scene;
    GridParameters& grid = capture().grid;
    const bool staticGiven = FieldReader(manifest_, "").object("grid").has("staticInstanceCount");
    const size_t count = arrays_.instances.size();
    if (!staticGiven) grid.staticInstanceCount = static_cast<uint32_t>(count);
    scene.staticInstanceCount = grid.staticInstanceCount;
    uint64_t total = 0;
    for (size_t i = 0; i < count; ++i) {
      const InstanceColumns& columns = arrays_.instances[i];
      const InstanceRows& rows = capture().frames[0].rows[i];
      scene.instances.push_back(
          {rows.row0, rows.row1, rows.row2, columns.firstTriangle, columns.triangleCount, static_cast<uint32_t>(total), columns.material});
      scene.sources.push_back({columns.sceneInstance, columns.mesh, columns.firstTriangle});
      total += columns.triangleCount;
      if (total > kMostWorldTriangles) throw Error("instances.npy: places more than " + std::to_string(kMostWorldTriangles) + " triangles");
      if (i < scene.staticInstanceCount) scene.staticTriangleCount = static_cast<uint32_t>(total);
    }
    scene.triangleCount = static_cast<uint32_t>(total);

    // Counts that the manifest leaves out; those it gives are checked later.
    const auto orElse = [this](const char* name, uint32_t& value, uint32_t fallback) {
      if (!FieldReader(manifest_, "").object("grid").has(name)) value = fallback;
    };
    orElse("instanceCount", grid.instanceCount, scene.instanceCount());
    orElse("triangleCount", grid.triangleCount, scene.triangleCount);
    orElse("staticTriangleCount", grid.staticTriangleCount, scene.staticTriangleCount);
  }

  // Names and materials for what has only a number.
  void nameUnnamed() {
    uint64_t meshes = 0, instances = 0, materials = 0;
    for (const InstanceColumns& columns : arrays_.instances) {
      meshes = std::max<uint64_t>(meshes, uint64_t(columns.mesh) + 1);
      instances = std::max<uint64_t>(instances, uint64_t(columns.sceneInstance) + 1);
      materials = std::max<uint64_t>(materials, uint64_t(columns.material) + 1);
    }
    NumberedScene& scene = capture().scene;
    if (!present(Part::materials)) {
      if (materials > kMostUnnamed) throw Error("instances.npy: a material is above 65535");
      const TraceMaterial plain{.baseColour = vec4(1.0f), .metallic = 0.0f, .roughness = 0.5f, .layer = kNoLayer};
      scene.materials.assign(std::max<uint64_t>(materials, capture().names.materials.size()), plain);
    }
    const auto fill = [](std::vector<std::string>& names, const char* word, uint64_t count) {
      if (!names.empty() || count > kMostUnnamed) return;
      for (uint64_t i = 0; i < count; ++i) names.push_back(std::string(word) + " " + std::to_string(i));
    };
    fill(capture().names.meshes, "mesh", meshes);
    fill(capture().names.instances, "instance", instances);
    fill(capture().names.materials, "material", scene.materials.size());
  }

  bool isOther(const ZipEntry& entry) const {
    if (entry.name == kManifestEntry || findColumn(entry.name) != nullptr) return false;
    return entry.name == kPreviewEntry ? options_.products.preview : options_.unknownEntries;
  }

  // The preview, and what this version does not know.
  void readOthers() {
    for (const ZipEntry& entry : zip_.entries()) {
      if (!isOther(entry)) continue;
      try {
        std::vector<std::byte> bytes = zip_.read(entry);
        if (entry.name != kPreviewEntry) {
          capture().unknownEntries.push_back({entry.name, std::move(bytes)});
          continue;
        }
        if (bytes.size() < kPngSignature.size() || std::memcmp(bytes.data(), kPngSignature.data(), kPngSignature.size()) != 0)
          throw Error("is not a PNG file");
        capture().preview = std::move(bytes);
      } catch (const Error& error) {
        loseUnknown(plainName(entry.name) + ": " + error.what());
      }
    }
    std::ranges::sort(capture().unknownEntries, {}, &CaptureEntryBytes::name);
  }

  void checkProduct(Part part) {
    try {
      checkCaptureProduct(capture(), part);
    } catch (const Error& error) {
      if (!options_.salvage) throw;
      leaveOut(part, error);
      clearPart(part);
    }
  }

  void keepUnknownKeys() {
    Json rest = unknownKeys(manifest_, makeManifest(capture()));
    if (rest.is_object()) rest.erase("entries");
    if (rest.is_object() && !rest.empty()) capture().unknownKeys = rest.dump();
  }

  ZipReader& zip_;
  const ReadOptions& options_;
  Json manifest_;
  size_t frameCount_ = 1;
  std::map<std::string, ListedEntry> listed_;
  std::vector<FoundColumn> found_;
  std::map<Part, uint64_t> counts_;
  std::array<bool, kPartCount> dropped_{};
  bool ownInstances_ = false;
  bool ownRows_ = false;
  bool validGiven_ = false;
  Capture capture_;
  CaptureArrays arrays_{capture_, {}};
};

CaptureDirectory listZip(ZipReader& zip) {
  const Json manifest = CaptureReader::parseManifestOf(zip);
  CaptureDirectory directory{.manifest = manifest.dump(2), .version = manifestVersion(manifest), .fileBytes = zip.fileBytes()};
  std::map<std::string, ListedEntry> listed;
  for (ListedEntry& entry : listedEntries(manifest)) listed.emplace(entry.name, std::move(entry));
  for (const ZipEntry& entry : zip.entries()) {
    CaptureEntry line{.name = entry.name, .bytes = entry.bytes, .compressedBytes = entry.compressedBytes};
    if (const auto found = listed.find(entry.name); found != listed.end()) {
      line.type = npyTypeName(found->second.type);
      line.shape = found->second.shape;
    }
    directory.entries.push_back(std::move(line));
  }
  return directory;
}

// Runs `work` with the file's name in front of every Error.
template <class Work>
auto named(const std::string& name, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw error.within(name);
  } catch (const std::bad_alloc&) {
    throw Error(name + ": does not fit into memory");
  }
}

}  // namespace

Capture readCapture(const std::filesystem::path& file, const ReadOptions& options) {
  return named(file.string(), [&] {
    ZipReader zip(file);
    return CaptureReader(zip, options).read();
  });
}

Capture readCaptureMemory(std::span<const std::byte> bytes, const std::string& name, const ReadOptions& options) {
  return named(name, [&] {
    ZipReader zip(bytes);
    return CaptureReader(zip, options).read();
  });
}

CaptureDirectory listCapture(const std::filesystem::path& file) {
  return named(file.string(), [&] {
    ZipReader zip(file);
    return listZip(zip);
  });
}

CaptureDirectory listCaptureMemory(std::span<const std::byte> bytes, const std::string& name) {
  return named(name, [&] {
    ZipReader zip(bytes);
    return listZip(zip);
  });
}

}  // namespace gridscope
