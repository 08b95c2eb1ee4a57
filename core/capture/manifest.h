// The manifest of a capture: everything that is not an array, and which arrays there are.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/capture/capture.h"
#include "core/capture/fields.h"

namespace gridscope {

inline constexpr const char* kManifestEntry = "manifest.json";
inline constexpr uint64_t kMostManifestBytes = uint64_t{8} << 20;

// An array as the manifest lists it.
struct ListedEntry {
  std::string name;  // "grid.npy"
  NpyType type;
  std::vector<uint64_t> shape;
};

// The text as JSON. Throws Error for other texts, nesting beyond 64 levels, a key that is there twice, another format and a newer version.
Json parseManifest(std::string_view text);
uint32_t manifestVersion(const Json& manifest);

std::vector<ListedEntry> listedEntries(const Json& manifest);

// Number of frames that it describes.
size_t manifestFrameCount(const Json& manifest);

// Fills everything of a capture that is not an array; `size` where the manifest has none.
struct PixelSize {
  uint32_t width;
  uint32_t height;
};
void readManifest(const Json& manifest, PixelSize size, Capture& capture);

// The manifest without `entries`. Everything that readManifest() knows is in it.
Json makeManifest(const Capture& capture);

// Keys of `object` that `known` has not, at every depth; null: none.
Json unknownKeys(const Json& object, const Json& known);

// Puts keys that `object` has not into it, at every depth.
void addKeys(Json& object, const Json& more);

}  // namespace gridscope
