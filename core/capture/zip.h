// The container of a capture: a ZIP of deflated or stored entries and nothing else. Every field that says what an entry is called or holds is
// stored twice and compared, or covered by a checksum; what could hide bytes (gaps, comments, extra fields) is refused. So a damaged file is
// refused, or its entries' names and bytes are what they were.
// Sources: PKWARE, .ZIP File Format Specification (APPNOTE), 6.3.10, 2022; libzip decompresses and checks the CRC-32.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gridscope {

struct ZipEntry {
  std::string name;
  uint64_t bytes = 0;
  uint64_t compressedBytes = 0;
  uint32_t crc = 0;  // of the bytes
};

class ZipReader {
 public:
  // Reads the directory and every local header, no entry. Throws Error without the file's name.
  explicit ZipReader(const std::filesystem::path& file);
  explicit ZipReader(std::span<const std::byte> bytes);  // must outlive the reader
  ~ZipReader();
  ZipReader(ZipReader&&) noexcept;

  uint64_t fileBytes() const;
  const std::vector<ZipEntry>& entries() const;  // in the directory's order
  const ZipEntry* find(const std::string& name) const;

  // The entry's bytes. Throws Error, without the entry's name, when they do not decompress to as many with their CRC-32. Allocates what the
  // directory says: check it first. Not for several threads at once.
  std::vector<std::byte> read(const ZipEntry& entry);

 private:
  struct Archive;
  std::unique_ptr<Archive> archive_;
};

class ZipWriter {
 public:
  ZipWriter();
  ~ZipWriter();
  ZipWriter(const ZipWriter&) = delete;

  // Deflated, with a fixed date: the same entries in the same order make the same file.
  void add(const std::string& name, std::vector<std::byte> bytes);
  std::vector<std::byte> finish();

 private:
  struct Archive;
  std::unique_ptr<Archive> archive_;
};

// Can an entry be called so: a relative path of plain parts, at most 255 bytes of UTF-8 without control characters.
bool isEntryName(const std::string& name);

}  // namespace gridscope
