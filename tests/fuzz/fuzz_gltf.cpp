// Fuzzes the loader of glTF, the whole chain: our guard, tinygltf, our conversion, and the numbering behind it.
//
// Build and run (clang):
//   tests/fuzz/build && /tmp/fuzz/seeds /tmp/fuzz/corpus
//   /tmp/fuzz/fuzz_gltf -max_len=65536 -timeout=20 -rss_limit_mb=4096 -max_total_time=3600 /tmp/fuzz/corpus/gltf
//
// The input is a .gltf or .glb file; no file beside it is read. tinygltf itself comes from the system and is compiled in core/gltf/gltf.cpp.
#include <cstdint>

#include "core/base/error.h"
#include "core/gltf/gltf.h"
#include "core/scene/numbering.h"

using namespace gridscope;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const Scene scene = loadGltfMemory(std::as_bytes(std::span(data, size)), "fuzz", {});
    sceneBounds(scene);
    numberScene(scene, NumberBy::area);
  } catch (const Error&) {
  }
  return 0;
}
