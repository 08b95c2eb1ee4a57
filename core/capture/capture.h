// A frame, or a sequence of frames, in a file: its inputs and whichever products were kept. NAME.gridcap is a ZIP of .npy arrays and a
// manifest.json; captures/FORMAT.md specifies it. Reading takes every byte for hostile: what comes out passes checkCapture() or is an Error
// with kExitBadInput and one line: file, entry, fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/npy.h"
#include "core/grid/grid.h"
#include "core/scene/numbering.h"
#include "core/trace/settings.h"
#include "shaders/shared/trace/frame.h"

namespace gridscope {

inline constexpr uint32_t kCaptureVersion = 1;

// Arrays in memory that reading accepts, all frames together, entries kept unread included. Its peak is this and once more the largest
// entry, whatever the file says.
inline constexpr uint64_t kCaptureMemoryLimit = uint64_t{4} << 30;

// An instance's transform: Instance::row0 to row2.
struct InstanceRows {
  vec4 row0;
  vec4 row1;
  vec4 row2;
};

// The nearest hit among all triangles, without a grid.
struct ExactHit {
  float t;             // distance, world units; 0: nothing hit
  uint32_t reference;  // kNoReference: nothing hit
};

// What changes from frame to frame. Products are empty where the capture does not hold them; all frames hold the same ones.
struct CaptureFrame {
  float timeSeconds = 0.0f;
  CameraParameters camera{};
  BounceParameters bounce{};  // with the frame's number and the seed
  ViewParameters view{};
  std::vector<InstanceRows> rows;  // of all instances; static ones are the same in every frame

  std::vector<uint32_t> grid;       // Grid::words
  std::vector<GatherPixel> gather;  // width * height, first row at the top; likewise the next four
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<RayCounters> counters;
  std::vector<ExactHit> exact;
};

// What a person calls things; as many as the indices of InstanceSource and Instance::material need.
struct CaptureNames {
  std::string scene;
  std::vector<std::string> meshes;
  std::vector<std::string> instances;  // the scene's instances
  std::vector<std::string> materials;
};

// An entry that this version does not know: kept as it is and written again.
struct CaptureEntryBytes {
  std::string name;
  std::vector<std::byte> bytes;
};

struct Capture {
  std::string writer;  // program and version
  std::string device;  // that made the products
  std::string driver;
  std::string note;

  FrameSettings settings;  // camera: the first frame's
  GridParameters grid{};   // every frame's, bit for bit
  TraceParameters trace{};
  Bounds bounds;        // of the scene over its whole animation: what the grid was made for
  NumberedScene scene;  // transforms of the first frame. TraceMaterial::layer names an image of the scene file: not in the capture
  CaptureNames names;
  std::vector<CaptureFrame> frames;  // one or more
  std::vector<std::byte> preview;    // a PNG file; empty: none

  std::vector<CaptureEntryBytes> unknownEntries;  // by rising name
  std::string unknownKeys;                        // manifest keys that this version does not know, as a JSON object; empty: none
  std::vector<std::string> faults;                // salvage: a line for every entry that was left out; never written
};

// A frame's pieces as the stages take them.
FrameParameters frameParameters(const Capture& capture, size_t frame);
NumberedScene frameScene(const Capture& capture, size_t frame);              // with the frame's transforms
Grid frameGrid(const Capture& capture, size_t frame);                        // the frame must hold one
std::vector<uint32_t> movedInstances(const Capture& capture, size_t frame);  // since the frame before (rising); all dynamic ones in frame 0
std::vector<InstanceRows> rowsOf(std::span<const Instance> instances);

// Products to read, or to take from a pipeline. Inputs are always read.
struct CaptureProducts {
  bool grid = true;
  bool gather = true;
  bool rays = true;
  bool hits = true;
  bool counters = true;
  bool preview = true;
  bool exact = false;  // taking it costs a trace of every ray in C++
};

struct ReadOptions {
  bool salvage = false;  // leave damaged entries out, with what needs them, instead of refusing; Capture::faults says which
  CaptureProducts products{.exact = true};
  bool unknownEntries = true;  // keep them: needed to write the capture again
  uint64_t memoryLimit = kCaptureMemoryLimit;
};

Capture readCapture(const std::filesystem::path& file, const ReadOptions& options = {});

// The same from memory; `name` stands in messages.
Capture readCaptureMemory(std::span<const std::byte> bytes, const std::string& name, const ReadOptions& options = {});

// Writes beside the file, flushes, renames: when it throws Error (disk full, no permission, a capture that checkCapture() refuses) the old
// file is as it was. The same capture makes the same bytes.
void writeCapture(const std::filesystem::path& file, const Capture& capture);

// The bytes of such a file.
std::vector<std::byte> formatCapture(const Capture& capture);

// Throws Error naming the entry: sizes that do not agree, references, instances, triangles or materials out of range, numbers that are not
// finite, parameters that no grid can have.
void checkCapture(const Capture& capture);

// What a capture holds, from its directory and manifest alone.
struct CaptureEntry {
  std::string name;  // "grid.npy"
  uint64_t bytes = 0;
  uint64_t compressedBytes = 0;
  std::string type;  // "<u4"; empty: not an array that the manifest lists
  std::vector<uint64_t> shape;
};

struct CaptureDirectory {
  std::string manifest;  // its JSON text
  uint32_t version = 0;
  uint64_t fileBytes = 0;
  std::vector<CaptureEntry> entries;  // in the file's order, the manifest included
};

CaptureDirectory listCapture(const std::filesystem::path& file);
CaptureDirectory listCaptureMemory(std::span<const std::byte> bytes, const std::string& name);

}  // namespace gridscope
