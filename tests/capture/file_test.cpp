// Captures written, read and written again: nothing is lost, the same content makes the same bytes, a failing save leaves the old file.
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/capture/zip.h"
#include "tests/capture/small_capture.h"
#include "tests/grid_words.h"

namespace gridscope {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path temporary(const std::string& name) {
  return fs::temp_directory_path() / ("gridscope_capture_" + std::to_string(getpid()) + "_" + name);
}
fs::path sourceFolder() { return fs::path(__FILE__).parent_path().parent_path().parent_path(); }

std::vector<std::byte> bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

// A file's entries, changed by `change`, in a file again.
template <class Change>
std::vector<std::byte> rezipped(std::span<const std::byte> file, const Change& change) {
  ZipReader reader(file);
  std::vector<CaptureEntryBytes> entries;
  for (const ZipEntry& entry : reader.entries()) entries.push_back({entry.name, reader.read(entry)});
  change(entries);
  ZipWriter writer;
  for (const CaptureEntryBytes& entry : entries) writer.add(entry.name, entry.bytes);
  return writer.finish();
}

template <class Change>
std::vector<std::byte> withManifest(std::span<const std::byte> file, const Change& change) {
  return rezipped(file, [&](std::vector<CaptureEntryBytes>& entries) {
    json manifest = json::parse(reinterpret_cast<const char*>(entries[0].bytes.data()),
                                reinterpret_cast<const char*>(entries[0].bytes.data()) + entries[0].bytes.size());
    change(manifest);
    const std::string text = manifest.dump();
    entries[0].bytes.assign(reinterpret_cast<const std::byte*>(text.data()), reinterpret_cast<const std::byte*>(text.data()) + text.size());
  });
}

template <class Value>
bool sameBits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

template <class Value>
bool sameBits(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof(Value)) == 0;
}

TEST(CaptureFile, EverythingComesBackBitForBit) {
  const Capture capture = makeSmallCapture();
  const Capture read = readCaptureMemory(formatCapture(capture), "small");
  EXPECT_TRUE(sameBits(read.grid, capture.grid));
  EXPECT_TRUE(sameBits(read.trace, capture.trace));
  EXPECT_TRUE(sameBits(read.bounds, capture.bounds));
  EXPECT_TRUE(sameBits(read.scene.objectTriangles, capture.scene.objectTriangles));
  EXPECT_TRUE(sameBits(read.scene.corners, capture.scene.corners));
  EXPECT_TRUE(sameBits(read.scene.meshTriangles, capture.scene.meshTriangles));
  EXPECT_TRUE(sameBits(read.scene.instances, capture.scene.instances));
  EXPECT_TRUE(sameBits(read.scene.sources, capture.scene.sources));
  EXPECT_TRUE(sameBits(read.scene.materials, capture.scene.materials));
  EXPECT_TRUE(sameBits(read.scene.alphaBytes, capture.scene.alphaBytes));
  EXPECT_EQ(read.scene.staticInstanceCount, 1u);
  EXPECT_EQ(read.scene.staticTriangleCount, 2u);
  EXPECT_EQ(read.scene.triangleCount, 3u);
  EXPECT_EQ(read.names.meshes, capture.names.meshes);
  EXPECT_EQ(read.note, capture.note);
  EXPECT_TRUE(sameBits(read.preview, capture.preview));
  EXPECT_TRUE(sameBits(read.settings.camera.eye, capture.settings.camera.eye));
  ASSERT_EQ(read.frames.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const CaptureFrame &a = read.frames[i], &b = capture.frames[i];
    EXPECT_TRUE(sameBits(frameParameters(read, i), frameParameters(capture, i)));
    EXPECT_TRUE(sameBits(a.timeSeconds, b.timeSeconds));
    EXPECT_TRUE(sameBits(a.rows, b.rows));
    EXPECT_TRUE(sameBits(a.grid, b.grid));
    EXPECT_TRUE(sameBits(a.gather, b.gather));
    EXPECT_TRUE(sameBits(a.rays, b.rays));
    EXPECT_TRUE(sameBits(a.hits, b.hits));
    EXPECT_TRUE(sameBits(a.counters, b.counters));
    EXPECT_TRUE(sameBits(a.exact, b.exact));
    EXPECT_EQ(a.exact.size(), 6u);
  }
  EXPECT_EQ(movedInstances(read, 1), std::vector<uint32_t>{1});
  EXPECT_TRUE(read.unknownKeys.empty()) << read.unknownKeys;
  EXPECT_TRUE(read.faults.empty());
}

TEST(CaptureFile, WrittenAgainItHasTheSameBytes) {
  for (size_t frames : {1, 2, 3}) {
    const std::vector<std::byte> first = formatCapture(makeSmallCapture(frames));
    EXPECT_EQ(first, formatCapture(makeSmallCapture(frames)));
    EXPECT_EQ(first, formatCapture(readCaptureMemory(first, "first")));
  }
}

TEST(CaptureFile, ASequenceHasAFrameAxisWhereFramesDiffer) {
  const auto shapes = [](size_t frames) {
    const std::vector<std::byte> bytes = formatCapture(makeSmallCapture(frames));
    std::map<std::string, std::vector<uint64_t>> result;
    for (const CaptureEntry& entry : listCaptureMemory(bytes, "small").entries) result[entry.name] = entry.shape;
    return result;
  };
  EXPECT_EQ(shapes(1)["instances_transform.npy"], (std::vector<uint64_t>{2, 3, 4}));
  EXPECT_EQ(shapes(1)["grid.npy"].size(), 3u);
  EXPECT_EQ(shapes(2)["instances_transform.npy"], (std::vector<uint64_t>{2, 2, 3, 4}));
  EXPECT_EQ(shapes(2)["grid.npy"].size(), 4u);
  EXPECT_EQ(shapes(2)["rays_origin.npy"], (std::vector<uint64_t>{2, 3, 3}));
  EXPECT_EQ(shapes(2)["triangles.npy"], (std::vector<uint64_t>{3, 3, 3}));
}

TEST(CaptureFile, ACaptureWithoutExactHitsIsReadAsBefore) {
  Capture capture = makeSmallCapture();
  for (CaptureFrame& frame : capture.frames) frame.exact.clear();
  const std::vector<std::byte> bytes = formatCapture(capture);
  const Capture read = readCaptureMemory(bytes, "small");
  EXPECT_TRUE(read.frames[0].exact.empty());
  EXPECT_EQ(formatCapture(read), bytes);
}

TEST(CaptureFile, OnlyTheWantedProductsAreRead) {
  const std::vector<std::byte> bytes = formatCapture(makeSmallCapture());
  const Capture read =
      readCaptureMemory(bytes, "small", {.products = {.grid = false, .gather = false, .counters = false, .preview = false}});
  EXPECT_TRUE(read.frames[0].grid.empty());
  EXPECT_TRUE(read.frames[0].gather.empty());
  EXPECT_TRUE(read.frames[0].counters.empty());
  EXPECT_TRUE(read.frames[0].exact.empty());
  EXPECT_TRUE(read.preview.empty());
  EXPECT_EQ(read.frames[1].rays.size(), 6u);
  EXPECT_EQ(read.frames[1].hits.size(), 6u);
}

TEST(CaptureFile, UnknownEntriesAndKeysAreKept) {
  const std::vector<std::byte> array = formatNpy<float>(std::vector<uint64_t>{2}, std::vector<float>{1, 2});
  std::vector<std::byte> bytes = rezipped(formatCapture(makeSmallCapture()), [&](auto& entries) {
    entries.push_back({"mine/notes.txt", {std::byte('h'), std::byte('i')}});
    entries.push_back({"heat.npy", array});
  });
  bytes = withManifest(bytes, [](json& manifest) {
    manifest["engine"] = {{"build", 77}};
    manifest["settings"]["grid"]["later"] = true;
    manifest["frames"][1]["label"] = "second";
  });
  const Capture read = readCaptureMemory(bytes, "small");
  ASSERT_EQ(read.unknownEntries.size(), 2u);

  const std::vector<std::byte> again = formatCapture(read);
  const Capture second = readCaptureMemory(again, "again");
  EXPECT_EQ(second.unknownEntries[0].name, "heat.npy");
  EXPECT_EQ(second.unknownEntries[0].bytes, array);
  EXPECT_EQ(second.unknownEntries[1].name, "mine/notes.txt");
  EXPECT_EQ(second.unknownEntries[1].bytes.size(), 2u);
  EXPECT_EQ(second.unknownKeys, read.unknownKeys);
  const json manifest = json::parse(listCaptureMemory(again, "again").manifest);
  EXPECT_EQ(manifest["engine"]["build"], 77);
  EXPECT_EQ(manifest["settings"]["grid"]["later"], true);
  EXPECT_EQ(manifest["frames"][1]["label"], "second");
  EXPECT_EQ(manifest["entries"]["heat.npy"]["dtype"], "<f4");
  EXPECT_EQ(again, formatCapture(second));
}

TEST(CaptureFile, ListingReadsDirectoryAndManifestAlone) {
  std::vector<std::byte> bytes = formatCapture(makeSmallCapture());
  ZipReader zip(bytes);
  const CaptureDirectory directory = listCaptureMemory(bytes, "small");
  EXPECT_EQ(directory.version, kCaptureVersion);
  EXPECT_EQ(directory.fileBytes, bytes.size());
  EXPECT_EQ(directory.entries.size(), zip.entries().size());
  EXPECT_EQ(directory.entries[0].name, "manifest.json");
}

TEST(CaptureFile, AFileIsWrittenAndReadBack) {
  const fs::path file = temporary("written.gridcap");
  writeCapture(file, makeSmallCapture());
  EXPECT_EQ(bytesOf(file), formatCapture(makeSmallCapture()));
  EXPECT_EQ(readCapture(file).frames.size(), 2u);
  EXPECT_FALSE(listCapture(file).entries.empty());
  fs::remove(file);
}

TEST(CaptureFile, AFailingSaveLeavesTheOldFile) {
  const fs::path folder = temporary("full");
  fs::create_directory(folder);
  const fs::path file = folder / "a.gridcap";
  writeCapture(file, makeSmallCapture(1));
  const std::vector<std::byte> before = bytesOf(file);

  // A file may have 4096 bytes now: as a full disk, for root too.
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const rlimit small{4096, old.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string fault;
  try {
    writeCapture(file, makeSmallCapture(3));
  } catch (const Error& error) {
    fault = error.what();
    EXPECT_EQ(error.exitCode(), kExitBadInput);
  }
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);

  EXPECT_NE(fault.find("a.gridcap: can't be saved: "), std::string::npos) << fault;
  EXPECT_NE(fault.find("is unchanged"), std::string::npos) << fault;
  EXPECT_EQ(bytesOf(file), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  fs::remove_all(folder);
}

TEST(CaptureFile, WhatCanNotBeReadIsNotWritten) {
  Capture capture = makeSmallCapture();
  capture.frames[1].hits[2].reference = makeReference(5, 0);
  capture.frames[1].hits[2].kind = kHitTriangle;
  EXPECT_THROW(formatCapture(capture), Error);
  capture = makeSmallCapture();
  capture.frames[1].rays.clear();
  EXPECT_THROW(formatCapture(capture), Error);
}

TEST(CaptureFile, AMissingFolderIsNamed) {
  try {
    writeCapture("/nowhere/at/all.gridcap", makeSmallCapture());
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all.gridcap: can't be saved: No such file or directory; nothing was written"),
              std::string::npos)
        << error.what();
  }
}

// The system's Python first: that is where Debian's numpy lies.
std::string python() {
  for (const char* name : {"/usr/bin/python3", "python3"})
    if (std::system((std::string(name) + " -c 'import numpy' 2>/dev/null").c_str()) == 0) return name;
  return "";
}

bool runPython(const std::string& arguments) { return std::system((python() + " " + arguments).c_str()) == 0; }

TEST(CaptureFile, ThePythonExampleOpensForEveryNumberOfReservedTexels) {
  if (python().empty()) GTEST_SKIP() << "no numpy";
  for (int reserved : {0, 1, 2}) {
    const fs::path file = temporary("foreign.gridcap");
    ASSERT_TRUE(runPython((sourceFolder() / "captures/write_foreign.py").string() + " " + file.string() + " --reserved " +
                          std::to_string(reserved)));
    const Capture capture = readCapture(file);
    EXPECT_EQ(capture.grid.reserved, reserved);
    EXPECT_EQ(capture.scene.staticInstanceCount, 1u);
    EXPECT_FALSE(capture.frames[0].grid.empty());
    EXPECT_FALSE(capture.frames[0].rays.empty());
    EXPECT_TRUE(capture.frames[0].hits.empty());
    EXPECT_EQ(capture.trace.gapFill, 1u);

    // It traces: most of its rays meet the triangles.
    std::vector<Triangle> world(capture.scene.triangleCount);
    transformTriangles(capture.scene, {0, capture.scene.instanceCount()}, world);
    const Grid grid = frameGrid(capture, 0);
    std::vector<Hit> hits(capture.frames[0].rays.size());
    traceRays({grid, capture.scene, world, capture.trace}, capture.frames[0].rays, hits, {});
    EXPECT_GT(std::ranges::count_if(hits, [](const Hit& hit) { return hit.kind == kHitTriangle; }), std::ptrdiff_t(hits.size() / 4));

    // Written by us it is the same capture.
    const std::vector<std::byte> again = formatCapture(capture);
    EXPECT_EQ(again, formatCapture(readCaptureMemory(again, "again")));
    fs::remove(file);
  }
}

// The blocks of Python in FORMAT.md, in a folder of their own: the first writes one.gridcap, the second changes old.gridcap.
std::vector<std::string> formatExamples() {
  std::ifstream stream(sourceFolder() / "captures/FORMAT.md");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string open = "```python\n", close = "```";
  std::vector<std::string> examples;
  for (size_t begin = text.find(open); begin != std::string::npos; begin = text.find(open, begin + 1))
    examples.push_back(text.substr(begin + open.size(), text.find(close, begin + open.size()) - begin - open.size()));
  return examples;
}

TEST(CaptureFile, TheExamplesOfTheFormatRun) {
  if (python().empty()) GTEST_SKIP() << "no numpy";
  const std::vector<std::string> examples = formatExamples();
  ASSERT_EQ(examples.size(), 2u);
  const fs::path folder = temporary("examples");
  fs::create_directory(folder);
  for (size_t i = 0; i < 2; ++i) std::ofstream(folder / ("example" + std::to_string(i) + ".py")) << examples[i];

  // The smallest capture: its ray hits its triangle.
  ASSERT_EQ(std::system(("cd " + folder.string() + " && " + python() + " example0.py").c_str()), 0);
  const Capture one = readCapture(folder / "one.gridcap");
  EXPECT_EQ(one.settings.width, 1u);
  const Grid grid = frameGrid(one, 0);
  std::vector<Hit> hits(1);
  traceRays({grid, one.scene, one.scene.objectTriangles, one.trace}, one.frames[0].rays, hits, {});
  EXPECT_EQ(hits[0].kind, kHitTriangle);
  EXPECT_NEAR(hits[0].t, 0.4f, 1e-6f);

  // The changed value, in a capture whose scene has such a triangle and whose grid such a texel.
  Capture capture = makeSmallCapture(1);
  std::string change = examples[1];
  change.replace(change.find("grid[3, 2, 40] = 5 << 16 | 17"), 29, "grid[1, 1, 3] = 1 << 16      ");
  std::ofstream(folder / "example1.py") << change;
  writeCapture(folder / "old.gridcap", capture);
  ASSERT_EQ(std::system(("cd " + folder.string() + " && " + python() + " example1.py").c_str()), 0);
  const Capture changed = readCapture(folder / "new.gridcap");
  Grid before = frameGrid(capture, 0);
  ASSERT_NE(before.words[wordOf(before.parameters, ivec3(3, 1, 1))], makeReference(1, 0));
  before.words[wordOf(before.parameters, ivec3(3, 1, 1))] = makeReference(1, 0);
  EXPECT_TRUE(sameBits(changed.frames[0].grid, before.words));
  fs::remove_all(folder);
}

TEST(CaptureFile, NumpyOpensOurFiles) {
  if (python().empty()) GTEST_SKIP() << "no numpy";
  const fs::path file = temporary("numpy.gridcap");
  const Capture capture = makeSmallCapture(1);
  writeCapture(file, capture);
  const ivec3 texels = gridTexelCount(capture.grid);
  const std::string shape = "(" + std::to_string(texels.z) + ", " + std::to_string(texels.y) + ", " + std::to_string(texels.x) + ")";
  EXPECT_TRUE(runPython("-c \"import numpy; assert numpy.load('" + file.string() + "')['grid'].shape == " + shape + "\""));
  fs::remove(file);
}

TEST(CaptureFile, NumpysOwnContainerIsRead) {
  if (python().empty()) GTEST_SKIP() << "no numpy";
  const fs::path ours = temporary("ours.gridcap"), theirs = temporary("theirs.npz");
  writeCapture(ours, makeSmallCapture());
  ASSERT_TRUE(runPython("-c \"import numpy, zipfile; a = numpy.load('" + ours.string() + "'); numpy.savez_compressed('" + theirs.string() +
                        "', **{n: a[n] for n in a.files if n != 'manifest.json' and n != 'preview.png'}); z = zipfile.ZipFile('" +
                        theirs.string() + "', 'a'); z.writestr('manifest.json', a['manifest.json']); z.close()\""));
  Capture capture = readCapture(theirs);
  capture.preview = readCapture(ours).preview;
  EXPECT_EQ(formatCapture(capture), bytesOf(ours));
  fs::remove(ours);
  fs::remove(theirs);
}

}  // namespace
}  // namespace gridscope
