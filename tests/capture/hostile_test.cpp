// Damaged and lying captures: every truncation, every flipped bit, and each lie that a file can tell. What is read is right, or it is refused with
// one line that names the file, and the entry where one is known.
#include <cstring>
#include <functional>
#include <map>
#include <memory>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/capture/zip.h"
#include "tests/capture/small_capture.h"

namespace gridscope {
namespace {

using nlohmann::json;
using FileBytes = std::vector<std::byte>;

FileBytes bytesOf(std::string_view text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

// A capture taken apart, to be put together with a lie in it.
struct Parts {
  json manifest;
  std::map<std::string, FileBytes> entries;

  Parts() {
    const FileBytes file = formatCapture(makeSmallCapture());
    ZipReader zip(file);
    for (const ZipEntry& entry : zip.entries()) entries[entry.name] = zip.read(entry);
    const FileBytes& text = entries.at("manifest.json");
    manifest = json::parse(std::string_view(reinterpret_cast<const char*>(text.data()), text.size()));
    entries.erase("manifest.json");
  }

  FileBytes file() const {
    ZipWriter zip;
    zip.add("manifest.json", bytesOf(manifest.dump()));
    for (const auto& [name, bytes] : entries) zip.add(name, bytes);
    return zip.finish();
  }

  // The values of an array, to be changed.
  template <class Value>
  Value* values(const std::string& name) {
    return reinterpret_cast<Value*>(entries.at(name).data() + parseNpyHeader(entries.at(name)).dataOffset);
  }

  template <class Value>
  void replace(const std::string& name, const std::vector<uint64_t>& shape, const std::vector<Value>& values) {
    entries[name] = formatNpy<Value>(shape, values);
    manifest["entries"][name] = {{"dtype", npyTypeName(npyTypeOf<Value>())}, {"shape", shape}};
  }
};

// In an allocation of exactly their size, so that the address sanitizer sees a read beyond them.
std::string faultOf(std::span<const std::byte> bytes, const ReadOptions& options = {}) {
  const std::unique_ptr<std::byte[]> exact(new std::byte[bytes.size()]);
  if (!bytes.empty()) std::memcpy(exact.get(), bytes.data(), bytes.size());
  try {
    readCaptureMemory({exact.get(), bytes.size()}, "a.gridcap", options);
  } catch (const Error& error) {
    const std::string fault = error.what();
    EXPECT_EQ(error.exitCode(), kExitBadInput);
    EXPECT_TRUE(fault.starts_with("a.gridcap: ")) << fault;
    EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
    return fault;
  }
  return "";
}

// The fault of a capture after `lie` changed it must hold `part`.
void expectRefused(const std::string& part, const std::function<void(Parts&)>& lie, const ReadOptions& options = {}) {
  Parts parts;
  lie(parts);
  const std::string fault = faultOf(parts.file(), options);
  EXPECT_NE(fault.find(part), std::string::npos) << "wanted: " << part << "\nfault: " << fault;
}

TEST(CaptureHostile, TheUndamagedFileIsRead) { EXPECT_EQ(faultOf(Parts().file()), ""); }

TEST(CaptureHostile, EveryTruncationIsRefused) {
  const FileBytes file = formatCapture(makeSmallCapture());
  for (size_t length = 0; length < file.size(); ++length) ASSERT_NE(faultOf(std::span(file).first(length)), "") << "cut to " << length;
}

// Names and bytes of all entries.
std::map<std::string, FileBytes> contentOf(std::span<const std::byte> file) {
  ZipReader zip(file);
  std::map<std::string, FileBytes> content;
  for (const ZipEntry& entry : zip.entries()) content[entry.name] = zip.read(entry);
  return content;
}

// The address sanitizer is some twenty times slower: it sees a sample, the release build sees all.
#ifdef __SANITIZE_ADDRESS__
constexpr size_t kBitStep = 23;
constexpr int kBombFrames = 15000;
#else
constexpr size_t kBitStep = 1;
constexpr int kBombFrames = 60000;
#endif

TEST(CaptureHostile, EveryFlippedBitIsRefusedOrChangesNothing) {
  FileBytes file = formatCapture(makeSmallCapture());
  const std::map<std::string, FileBytes> content = contentOf(file);
  size_t refused = 0;
  for (size_t bit = 0; bit < 8 * file.size(); bit += kBitStep) {
    file[bit / 8] ^= std::byte(1u << (bit % 8));
    if (!faultOf(file).empty())
      ++refused;
    else
      ASSERT_EQ(contentOf(file), content) << "bit " << bit % 8 << " of byte " << bit / 8;
    file[bit / 8] ^= std::byte(1u << (bit % 8));
  }
  EXPECT_GT(refused, 8 * file.size() / kBitStep * 9 / 10);
  RecordProperty("bits", int(8 * file.size()));
  RecordProperty("refused", int(refused));
}

TEST(CaptureHostile, BytesAroundTheFileAreRefused) {
  FileBytes file = formatCapture(makeSmallCapture());
  FileBytes behind = file;
  behind.push_back(std::byte(0));
  EXPECT_NE(faultOf(behind), "");
  file.insert(file.begin(), std::byte(0));
  EXPECT_NE(faultOf(file), "");
}

TEST(CaptureHostile, TheManifestMustBeOurs) {
  expectRefused("manifest.json: version is missing", [](Parts& p) { p.manifest.erase("version"); });
  expectRefused("manifest.json: is of version 2; this program reads versions up to 1", [](Parts& p) { p.manifest["version"] = 2; });
  expectRefused("version is 0", [](Parts& p) { p.manifest["version"] = 0; });
  expectRefused("version is not a whole number", [](Parts& p) { p.manifest["version"] = "1"; });
  expectRefused("its format is not", [](Parts& p) { p.manifest["format"] = "other"; });
  expectRefused("its format is not", [](Parts& p) { p.manifest = json::array(); });
  expectRefused("grid is missing", [](Parts& p) { p.manifest.erase("grid"); });
  expectRefused("grid.cellEdge is missing", [](Parts& p) { p.manifest["grid"].erase("cellEdge"); });
  expectRefused("grid.origin is not a list of 3 numbers", [](Parts& p) { p.manifest["grid"]["origin"] = {1, 2}; });
  expectRefused("grid.cellEdge: its value and its bits disagree", [](Parts& p) { p.manifest["grid"]["cellEdge"]["value"] = 7.5; });
  expectRefused("frames is not a list", [](Parts& p) { p.manifest["frames"] = json::array(); });
  expectRefused("settings.grid.stretch is none of x, y, z, auto", [](Parts& p) { p.manifest["settings"]["grid"]["stretch"] = "w"; });
  expectRefused("entries is missing", [](Parts& p) { p.manifest.erase("entries"); });
}

TEST(CaptureHostile, TextThatIsNoManifestIsRefused) {
  const auto refused = [](const std::string& text) {
    ZipWriter zip;
    zip.add("manifest.json", bytesOf(text));
    return faultOf(zip.finish());
  };
  EXPECT_NE(refused("{").find("manifest.json: is not JSON"), std::string::npos);
  EXPECT_NE(refused("\xFF").find("is not JSON"), std::string::npos);
  EXPECT_NE(refused(std::string(100000, '[')).find("nested"), std::string::npos);
  EXPECT_NE(refused("{\"format\": \"gridscope capture\", \"version\": 1, \"version\": 1}").find("twice"), std::string::npos);
  ZipWriter empty;
  empty.add("grid.npy", bytesOf("x"));
  EXPECT_NE(faultOf(empty.finish()).find("holds no manifest.json"), std::string::npos);
}

TEST(CaptureHostile, ArraysMustAgreeWithTheManifest) {
  expectRefused("hits_t.npy: is missing; the manifest lists it", [](Parts& p) { p.entries.erase("hits_t.npy"); });
  expectRefused("other.npy: is missing; the manifest lists it",
                [](Parts& p) { p.manifest["entries"]["other.npy"] = p.manifest["entries"]["hits_t.npy"]; });
  expectRefused("hits_t.npy: is not listed in the manifest", [](Parts& p) { p.manifest["entries"].erase("hits_t.npy"); });
  expectRefused("hits_t.npy: is missing; the other arrays of the hits need it",
                [](Parts& p) { p.entries.erase("hits_t.npy"), p.manifest["entries"].erase("hits_t.npy"); });
  expectRefused("hits_t.npy: is said to hold <u4", [](Parts& p) { p.manifest["entries"]["hits_t.npy"]["dtype"] = "<u4"; });
  expectRefused("hits_t.npy: holds <u4; it must hold <f4", [](Parts& p) {
    p.replace<uint32_t>("hits_t.npy", {2, 2, 3}, std::vector<uint32_t>(12));
    p.manifest["entries"]["hits_t.npy"]["dtype"] = "<f4";
  });
  expectRefused("hits_t.npy: has the shape (3, 2) a frame; the manifest says 2 rows of 3 pixels", [](Parts& p) {
    p.replace<float>("hits_t.npy", {2, 3, 2}, std::vector<float>(12));
  });
  expectRefused("hits_t.npy: has the shape (12,); it must be ([frames, ]height, width)",
                [](Parts& p) { p.replace<float>("hits_t.npy", {12}, std::vector<float>(12)); });
  expectRefused("hits_t.npy: has the shape (3, 2, 3); it must be", [](Parts& p) {
    p.replace<float>("hits_t.npy", {3, 2, 3}, std::vector<float>(18));
  });
  expectRefused("hits_t.npy: has the shape (1, 12) where the manifest says (2, 2, 3)", [](Parts& p) {
    p.replace<float>("hits_t.npy", {1, 12}, std::vector<float>(12));
    p.manifest["entries"]["hits_t.npy"]["shape"] = {2, 2, 3};
  });
  expectRefused("grid.npy: has the shape", [](Parts& p) { p.manifest["grid"]["capacity"] = 2, p.manifest["grid"]["stride"] = 4; });
  expectRefused("rays_origin.npy", [](Parts& p) { p.manifest["entries"]["rays_origin.npy"]["shape"] = {1ull << 62, 1ull << 62, 3}; });
  expectRefused("triangles.npy: has 236 bytes, which do not hold the shape", [](Parts& p) {
    p.manifest["entries"]["triangles.npy"]["shape"] = {4000000000ull, 3, 3};
  });
  expectRefused("corners_uv.npy", [](Parts& p) { p.replace<float>("corners_uv.npy", {2, 3, 2}, std::vector<float>(12)); });
  expectRefused("alpha.npy: has the shape (7,); it must be (a multiple of 4)",
                [](Parts& p) { p.replace<uint8_t>("alpha.npy", {7}, std::vector<uint8_t>(7)); });
  expectRefused("triangles.npy: is missing",
                [](Parts& p) { p.entries.erase("triangles.npy"), p.manifest["entries"].erase("triangles.npy"); });
}

TEST(CaptureHostile, WhatLeadsNowhereIsRefused) {
  expectRefused("grid.npy: cell (0, 0, 0), slot 0 names instance 7, triangle 3",
                [](Parts& p) { p.values<uint32_t>("grid.npy")[0] = makeReference(7, 3); });
  expectRefused("hits_reference.npy: pixel (0, 0) hits nothing", [](Parts& p) { p.values<uint32_t>("hits_reference.npy")[0] = 0; });
  expectRefused("hits_kind.npy: pixel (1, 0) has kind 9", [](Parts& p) { p.values<uint8_t>("hits_kind.npy")[1] = 9; });
  expectRefused("hits_t.npy: pixel (2, 1) is not finite", [](Parts& p) { p.values<float>("hits_t.npy")[5] = NAN; });
  expectRefused("gather_reference.npy: pixel (1, 0) names instance 0, triangle 2",
                [](Parts& p) { p.values<uint32_t>("gather_reference.npy")[1] = makeReference(0, 2); });
  expectRefused("gather_material.npy: pixel (1, 0) has material 1 of 1",
                [](Parts& p) { p.values<uint32_t>("gather_material.npy")[1] = 1; });
  expectRefused("instances.npy: instance 0 leads beyond", [](Parts& p) { p.values<uint32_t>("instances.npy")[0] = 2; });
  expectRefused("instances.npy: instance 1 has 0 triangles", [](Parts& p) { p.values<uint32_t>("instances.npy")[6] = 0; });
  expectRefused("instances.npy: instance 0 has mesh 9 of 2", [](Parts& p) { p.values<uint32_t>("instances.npy")[2] = 9; });
  expectRefused("instances.npy: instance 0 is of scene instance 9 of 2", [](Parts& p) { p.values<uint32_t>("instances.npy")[3] = 9; });
  expectRefused("instances.npy: instance 0 has material 1 of 1", [](Parts& p) { p.values<uint32_t>("instances.npy")[4] = 1; });
  expectRefused("materials_keying.npy: material 0 has an alpha map that leads beyond",
                [](Parts& p) { p.values<uint32_t>("materials_keying.npy")[5] = 60000; });
  expectRefused("materials_keying.npy: material 0 has an alpha threshold",
                [](Parts& p) { p.values<uint32_t>("materials_keying.npy")[7] = 257; });
  expectRefused("materials_keying.npy: material 0 has an unknown wrap mode",
                [](Parts& p) { p.values<uint32_t>("materials_keying.npy")[3] = 3; });
}

TEST(CaptureHostile, WhatIsNotFiniteIsRefused) {
  expectRefused("instances_transform.npy: instance 1 of frame 1 has a transform that is not finite",
                [](Parts& p) { p.values<float>("instances_transform.npy")[24 + 12] = NAN; });
  expectRefused("instances_transform.npy: a static instance moves in frame 1",
                [](Parts& p) { p.values<float>("instances_transform.npy")[24 + 3] = 0.5f; });
  expectRefused("lies beyond the coordinates", [](Parts& p) { p.values<float>("instances_transform.npy")[24 + 12] = 1e30f; });
  expectRefused("triangles.npy: triangle 0 is not finite", [](Parts& p) { p.values<float>("triangles.npy")[4] = INFINITY; });
  expectRefused("corners_uv.npy: corner 2 is not finite", [](Parts& p) { p.values<float>("corners_uv.npy")[4] = NAN; });
  expectRefused("rays_origin.npy: pixel (1, 0) starts beyond", [](Parts& p) { p.values<float>("rays_origin.npy")[3] = NAN; });
  expectRefused("rays_direction.npy: pixel (1, 0) has a direction that is not of length 1",
                [](Parts& p) { p.values<float>("rays_direction.npy")[3] = 3.0f; });
  expectRefused("rays_launch_normal.npy: pixel (1, 0)", [](Parts& p) { p.values<float>("rays_launch_normal.npy")[3] = INFINITY; });
  expectRefused("rays_valid.npy: pixel (2, 0): neither 0 nor 1", [](Parts& p) { p.values<uint8_t>("rays_valid.npy")[2] = 2; });
  expectRefused("materials_shading.npy: material 0 is not finite", [](Parts& p) { p.values<float>("materials_shading.npy")[5] = NAN; });

  // What an invalid ray holds is nobody's business.
  Parts parts;
  parts.values<float>("rays_origin.npy")[0] = NAN;
  EXPECT_EQ(faultOf(parts.file()), "");
}

TEST(CaptureHostile, ParametersThatNoGridHasAreRefused) {
  const auto lie = [](const char* group, const char* key, const json& value) { return [=](Parts& p) { p.manifest[group][key] = value; }; };
  expectRefused("grid.stride is not capacity + reserved", lie("grid", "stride", 7));
  expectRefused("grid.reserved is not 0, 1 or 2", lie("grid", "reserved", 3));
  expectRefused("grid.capacity is not from 1 to 16384", lie("grid", "capacity", 0));
  expectRefused("grid.cellCount is not from 1 to 65535", lie("grid", "cellCount", {65536, 1, 1}));
  expectRefused("grid.cellEdge is not above 0", lie("grid", "cellEdge", 0));
  expectRefused("grid.inverseCellEdge is not 1 / cellEdge", lie("grid", "inverseCellEdge", 0.001));
  expectRefused("grid.origin and cellEdge lead beyond", lie("grid", "origin", {1e30, 0, 0}));
  expectRefused("grid.cellEdge is beyond a 32-bit float", lie("grid", "cellEdge", 1e300));
  expectRefused("grid.cellsPerInvocation is not from 1", lie("grid", "cellsPerInvocation", 0));
  expectRefused("grid.staticInstanceCount is 9 of 2", lie("grid", "staticInstanceCount", 9));
  expectRefused("instance and triangle counts are not those", lie("grid", "triangleCount", 4));
  expectRefused("trace.segmentsPerPass is not from 1", lie("trace", "segmentsPerPass", 0));
  expectRefused("trace.traversal is none of", lie("trace", "traversal", "fast"));
  expectRefused("settings.width and height are not from 1 to 65535", [](Parts& p) { p.manifest["settings"]["width"] = 0; });
}

TEST(CaptureHostile, ABombIsRefusedBeforeItUnpacks) {
  // 64 MiB of zeros in 64 KiB: more than the limit, then more than its shape.
  const std::vector<uint8_t> zeros(64 << 20);
  expectRefused("MiB in memory; at most 16 MiB are read", [&](Parts& p) { p.replace<uint8_t>("alpha.npy", {zeros.size()}, zeros); },
                {.memoryLimit = 16 << 20});
  expectRefused("alpha.npy: has 67108992 bytes, which do not hold the shape (8,)", [&](Parts& p) {
    p.replace<uint8_t>("alpha.npy", {zeros.size()}, zeros);
    p.manifest["entries"]["alpha.npy"]["shape"] = {8};
  });

  // Frames that multiply what is stored once.
  expectRefused("MiB in memory; at most 1 MiB are read",
                [](Parts& p) {
                  for (const auto& entry : {"instances_transform.npy", "grid.npy", "rays_origin.npy", "rays_direction.npy", "hits_kind.npy",
                                            "hits_t.npy", "hits_reference.npy", "hits_barycentrics.npy", "counters_visits.npy",
                                            "counters_tests.npy", "exact_t.npy", "exact_reference.npy"}) {
                    json& shape = p.manifest["entries"][entry]["shape"];
                    const bool framed = shape[0] == 2 && shape.size() > 2;
                    if (framed) p.entries.erase(entry), p.manifest["entries"].erase(entry);
                  }
                  for (const auto* part : {"rays_", "hits_", "counters_", "exact_"})
                    for (auto it = p.entries.begin(); it != p.entries.end();)
                      if (it->first.starts_with(part))
                        p.manifest["entries"].erase(it->first), it = p.entries.erase(it);
                      else
                        ++it;
                  const json frame = json::object();
                  p.manifest["frames"] = json::array();
                  for (int i = 0; i < kBombFrames; ++i) p.manifest["frames"].push_back(frame);
                },
                {.memoryLimit = 1 << 20});
}

// Overwrites bytes of a file at the n-th occurrence of a text.
FileBytes patched(FileBytes file, const std::string& old, const std::string& now, int occurrence = -1) {
  std::string text(reinterpret_cast<const char*>(file.data()), file.size());
  size_t found = 0;
  for (size_t place = text.find(old); place != std::string::npos; place = text.find(old, place + 1), ++found)
    if (occurrence < 0 || int(found) == occurrence) text.replace(place, now.size(), now);
  EXPECT_GT(found, 0u);
  return bytesOf(text);
}

TEST(CaptureHostile, NamesThatLeaveTheFolderAreRefused) {
  ZipWriter zip;
  zip.add("manifest.json", bytesOf("{}"));
  zip.add("aa/bb.txt", bytesOf("x"));
  const FileBytes file = zip.finish();
  EXPECT_NE(faultOf(patched(file, "aa/bb", "../bb")).find("has an entry called '../bb.txt'"), std::string::npos);
  EXPECT_NE(faultOf(patched(file, "aa/bb", "/a/bb")).find("has an entry called"), std::string::npos);
  EXPECT_NE(faultOf(patched(file, "aa/bb", "a\\bbb")).find("has an entry called"), std::string::npos);
  EXPECT_NE(faultOf(patched(file, "aa/bb", "c:/bb")).find("has an entry called"), std::string::npos);
  EXPECT_NE(faultOf(patched(file, "aa/bb.txt", "aa/bb.tx\n")).find("has an entry called"), std::string::npos);
}

TEST(CaptureHostile, DirectoriesThatLieAreRefused) {
  ZipWriter zip;
  zip.add("manifest.json", bytesOf("{}"));
  zip.add("aaaa", bytesOf("x"));
  zip.add("bbbb", bytesOf("x"));
  const FileBytes file = zip.finish();
  EXPECT_NE(faultOf(patched(file, "bbbb", "aaaa")).find("aaaa: is there twice"), std::string::npos);
  EXPECT_NE(faultOf(patched(file, "bbbb", "cccc", 0)).find("bbbb: its header and the ZIP directory disagree"), std::string::npos);
  EXPECT_NE(faultOf(patched(file, std::string("PK\x05\x06", 4), std::string("PK\x05\x06\x01", 5))).find("several parts"),
            std::string::npos);
}

TEST(CaptureHostile, SalvageOpensWhatIsSound) {
  // A flipped byte in a product's stored data.
  FileBytes file = formatCapture(makeSmallCapture());
  const std::string text(reinterpret_cast<const char*>(file.data()), file.size());
  const size_t place = text.find("hits_t.npy") + 10;
  file[place + 20] ^= std::byte(1);
  EXPECT_NE(faultOf(file).find("a.gridcap: hits_t.npy: is damaged"), std::string::npos) << faultOf(file);
  Capture read = readCaptureMemory(file, "a.gridcap", {.salvage = true});
  ASSERT_EQ(read.faults.size(), 1u);
  EXPECT_NE(read.faults[0].find("hits_t.npy: is damaged"), std::string::npos);
  EXPECT_NE(read.faults[0].find("left out: hits"), std::string::npos);
  EXPECT_TRUE(read.frames[0].hits.empty());
  EXPECT_FALSE(read.frames[0].rays.empty());
  EXPECT_NO_THROW(formatCapture(read));

  // A product whose values lead nowhere, a part with a default, an unknown entry that is gone.
  Parts parts;
  parts.values<uint32_t>("grid.npy")[0] = makeReference(7, 3);
  parts.entries["corners_uv.npy"].pop_back();
  parts.manifest["entries"]["other.npy"] = parts.manifest["entries"]["hits_t.npy"];
  read = readCaptureMemory(parts.file(), "a.gridcap", {.salvage = true});
  EXPECT_EQ(read.faults.size(), 3u);
  EXPECT_TRUE(read.frames[1].grid.empty());
  EXPECT_EQ(read.scene.corners.size(), 9u);

  // Without geometry there is nothing to save.
  expectRefused("triangles.npy: triangle 0 is not finite", [](Parts& p) { p.values<float>("triangles.npy")[4] = INFINITY; },
                {.salvage = true});
}

}  // namespace
}  // namespace gridscope
