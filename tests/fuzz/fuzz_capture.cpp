// Fuzzes the reader of captures, the whole chain: ZIP directory, libzip, manifest, .npy headers, checks; what is read is written and read again.
//
// Build and run (clang):
//   tests/fuzz/build && /tmp/fuzz/seeds /tmp/fuzz/corpus
//   /tmp/fuzz/fuzz_capture -max_len=65536 -timeout=20 -rss_limit_mb=2048 -max_total_time=3600 /tmp/fuzz/corpus/capture
//
// The first byte chooses: even, the rest is the file itself; odd, the rest is a list of entries (1 byte: length of the name, the name, 3 bytes:
// length, the bytes) that is packed into a valid ZIP first, so that what lies behind the CRC-32 is reached.
#include <cstdint>
#include <cstdlib>
#include <set>

#include "core/capture/capture.h"
#include "core/capture/zip.h"

using namespace gridscope;

namespace {

constexpr uint64_t kMemory = uint64_t{64} << 20;

std::vector<std::byte> packed(std::span<const std::byte> list) {
  ZipWriter zip;
  std::set<std::string> names;
  while (list.size() >= 4) {
    const size_t nameBytes = std::min(std::to_integer<size_t>(list[0]), list.size() - 4);
    const std::string name(reinterpret_cast<const char*>(list.data()) + 1, nameBytes);
    list = list.subspan(1 + nameBytes);
    size_t bytes = 0;
    for (int i = 0; i < 3; ++i) bytes |= std::to_integer<size_t>(list[i]) << (8 * i);
    list = list.subspan(3);
    bytes = std::min(bytes, list.size());
    if (isEntryName(name) && names.insert(name).second) zip.add(name, {list.begin(), list.begin() + std::ptrdiff_t(bytes)});
    list = list.subspan(bytes);
  }
  return names.empty() ? std::vector<std::byte>{} : zip.finish();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::span<const std::byte> input = std::as_bytes(std::span(data, size)).subspan(1);
  std::vector<std::byte> file;
  try {
    file = (data[0] & 1) != 0 ? packed(input) : std::vector<std::byte>(input.begin(), input.end());
  } catch (const Error&) {  // libzip refuses names that are not UTF-8
    return 0;
  }
  try {
    readCaptureMemory(file, "fuzz", {.salvage = true, .memoryLimit = kMemory});
  } catch (const Error&) {
  }
  Capture capture;
  try {
    listCaptureMemory(file, "fuzz");
    capture = readCaptureMemory(file, "fuzz", {.memoryLimit = kMemory});
  } catch (const Error&) {
    return 0;
  }

  // What was read can be written, and is then the same for ever.
  const std::vector<std::byte> once = formatCapture(capture);
  const std::vector<std::byte> twice = formatCapture(readCaptureMemory(once, "once"));
  if (once != twice) std::abort();
  return 0;
}
