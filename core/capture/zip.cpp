// See zip.h.
#include "core/capture/zip.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>

#include "core/base/error.h"
#include "core/base/gltf_files.h"

namespace gridscope {

namespace {

// Record signatures and sizes without their names.
constexpr uint32_t kLocalSignature = 0x04034b50, kCentralSignature = 0x02014b50, kEndSignature = 0x06054b50;
constexpr uint64_t kLocalBytes = 30, kCentralBytes = 46, kEndBytes = 22;

constexpr uint64_t kMostFileBytes = 0xFFFFFFFFull;  // beyond it begins ZIP64
constexpr uint64_t kMostEntries = 4096;
constexpr uint64_t kMostNameBytes = 255;

// Deflate turns at most 1032 bytes into one (258 for two bits; Adler, zlib's technical notes), but for a few bytes of a block's head.
constexpr uint64_t kMostRatio = 1032;

// Flags that say nothing about the bytes: how hard deflate tried, and that the name is UTF-8.
constexpr uint32_t kHarmlessFlags = 0x0002 | 0x0004 | 0x0800;

// Measured on Sponza (138 MB of arrays, one core): level 4 2.6 s and 19.1 MB, 6 5.5 s and 18.8 MB, 1 20.5 MB and no quicker.
constexpr uint32_t kDeflateLevel = 4;
constexpr uint16_t kFixedDate = 0x21;  // 1980-01-01, the first that a ZIP can hold

uint32_t number(std::span<const std::byte> bytes, size_t offset, size_t count) {
  uint32_t value = 0;
  for (size_t i = 0; i < count; ++i) value |= std::to_integer<uint32_t>(bytes[offset + i]) << (8 * i);
  return value;
}

// A file's or a span's bytes, read where asked.
class FileBytes {
 public:
  explicit FileBytes(std::span<const std::byte> bytes) : bytes_(bytes), size_(bytes.size()) {}
  explicit FileBytes(const std::filesystem::path& file) {
    descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor_ < 0)
      throw Error(errno == ENOENT ? "no such file; give a .gridcap file" : std::string("can't be opened: ") + std::strerror(errno));
    struct stat facts;
    if (::fstat(descriptor_, &facts) == 0 && S_ISREG(facts.st_mode)) {
      size_ = static_cast<uint64_t>(facts.st_size);
      return;
    }
    ::close(descriptor_);
    throw Error("is not a plain file; give a .gridcap file");
  }
  ~FileBytes() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FileBytes(const FileBytes&) = delete;

  uint64_t size() const { return size_; }
  int descriptor() const { return descriptor_; }
  std::span<const std::byte> span() const { return bytes_; }

  std::vector<std::byte> at(uint64_t offset, uint64_t count) const {
    if (offset > size_ || count > size_ - offset) throw Error("ends early");
    std::vector<std::byte> result(count);
    if (descriptor_ < 0) {
      if (count > 0) std::memcpy(result.data(), bytes_.data() + offset, count);
      return result;
    }
    for (uint64_t done = 0; done < count;) {
      const ssize_t got = ::pread(descriptor_, result.data() + done, count - done, static_cast<off_t>(offset + done));
      if (got <= 0) throw Error(got < 0 ? std::string("can't be read: ") + std::strerror(errno) : "ends early");
      done += static_cast<uint64_t>(got);
    }
    return result;
  }

 private:
  std::span<const std::byte> bytes_;
  uint64_t size_ = 0;
  int descriptor_ = -1;
};

// An entry as the central directory has it.
struct CentralEntry {
  ZipEntry entry;
  uint32_t flags;
  uint32_t method;  // 0 stored, 8 deflated
  uint32_t time;    // DOS date and time
  uint64_t offset;  // of its local header
};

struct Directory {
  uint64_t offset;
  uint64_t size;
  uint64_t count;
};

Directory readEnd(const FileBytes& file) {
  if (file.size() < kEndBytes) throw Error("is not a capture: too short for a ZIP file");
  if (file.size() > kMostFileBytes) throw Error("has more than 4 GiB; captures end there: capture fewer frames or products");
  const auto end = file.at(file.size() - kEndBytes, kEndBytes);
  if (number(end, 0, 4) != kEndSignature)
    throw Error("is not a capture, or has been cut short: no ZIP directory at its end (a ZIP comment is not supported)");
  const Directory directory{number(end, 16, 4), number(end, 12, 4), number(end, 10, 2)};
  if (number(end, 4, 4) != 0 || number(end, 8, 2) != directory.count) throw Error("is a ZIP file of several parts; join them");
  if (number(end, 20, 2) != 0) throw Error("its ZIP directory is damaged: a comment that is not there");
  if (directory.offset + directory.size != file.size() - kEndBytes)
    throw Error("its ZIP directory is damaged, or bytes were added or lost in front of it");
  if (directory.count > kMostEntries)
    throw Error("has " + std::to_string(directory.count) + " entries; at most " + std::to_string(kMostEntries) + " are read");
  return directory;
}

CentralEntry readCentral(std::span<const std::byte> bytes) {
  if (bytes.size() < kCentralBytes || number(bytes, 0, 4) != kCentralSignature) throw Error("its ZIP directory is damaged");
  const uint64_t nameBytes = number(bytes, 28, 2);
  if (nameBytes > bytes.size() - kCentralBytes) throw Error("its ZIP directory is damaged: a name leads beyond it");
  CentralEntry central{.entry = {.name = std::string(reinterpret_cast<const char*>(bytes.data()) + kCentralBytes, nameBytes),
                                 .bytes = number(bytes, 24, 4),
                                 .compressedBytes = number(bytes, 20, 4),
                                 .crc = number(bytes, 16, 4)},
                       .flags = number(bytes, 8, 2),
                       .method = number(bytes, 10, 2),
                       .time = number(bytes, 12, 4),
                       .offset = number(bytes, 42, 4)};
  if (!isEntryName(central.entry.name))
    throw Error("has an entry called '" + plainName(central.entry.name) + "': names are relative paths without '..'");
  if (number(bytes, 30, 2) != 0 || number(bytes, 32, 2) != 0)
    throw Error(central.entry.name + ": has extra fields or a comment in the ZIP directory; write it without (zip -X)");
  if (number(bytes, 34, 2) != 0) throw Error(central.entry.name + ": is said to lie on another disk");
  return central;
}

void checkMethod(const CentralEntry& central) {
  const ZipEntry& entry = central.entry;
  if ((central.flags & 1u) != 0) throw Error("is encrypted");
  if ((central.flags & 8u) != 0) throw Error("its sizes lie behind it (a data descriptor): write to a file that can seek");
  if ((central.flags & ~kHarmlessFlags) != 0) throw Error("has ZIP flags that are not supported");
  if (central.method != 0 && central.method != 8) throw Error("is compressed in a way that is not supported; store or deflate it");
  if (central.method == 0 && entry.bytes != entry.compressedBytes) throw Error("is stored with two different sizes");
  if (entry.bytes > kMostRatio * (entry.compressedBytes + 16))
    throw Error("is said to unpack to " + std::to_string(entry.bytes) + " bytes, more than its " + std::to_string(entry.compressedBytes) +
                " can hold");
}

// numpy.savez writes an entry's sizes a second time, in a ZIP64 field of the local header: the one extra field that is taken.
bool isZip64Copy(const ZipEntry& entry, std::span<const std::byte> extra) {
  if (extra.size() != 20 || number(extra, 0, 2) != 1 || number(extra, 2, 2) != 16) return false;
  return number(extra, 4, 4) == entry.bytes && number(extra, 8, 4) == 0 && number(extra, 12, 4) == entry.compressedBytes &&
         number(extra, 16, 4) == 0;
}

// Compares the local header with the directory; returns where the entry ends.
uint64_t checkLocal(const FileBytes& file, const CentralEntry& central, uint64_t directoryOffset) {
  checkMethod(central);
  const ZipEntry& entry = central.entry;
  const auto local = file.at(central.offset, kLocalBytes);
  const uint64_t nameBytes = number(local, 26, 2), extraBytes = number(local, 28, 2);
  const auto tail = file.at(central.offset + kLocalBytes, nameBytes + extraBytes);
  const auto name = std::span(tail).first(nameBytes), extra = std::span(tail).subspan(nameBytes);
  const bool zip64 = isZip64Copy(entry, extra);
  const bool elsewhere = zip64 && number(local, 18, 4) == 0xFFFFFFFFu && number(local, 22, 4) == 0xFFFFFFFFu;
  const bool sizesAgree = elsewhere || (number(local, 18, 4) == entry.compressedBytes && number(local, 22, 4) == entry.bytes);
  if (number(local, 0, 4) != kLocalSignature || number(local, 6, 2) != central.flags || number(local, 8, 2) != central.method ||
      number(local, 10, 4) != central.time || number(local, 14, 4) != entry.crc || !sizesAgree || nameBytes != entry.name.size() ||
      std::memcmp(name.data(), entry.name.data(), nameBytes) != 0)
    throw Error("its header and the ZIP directory disagree");
  if (extraBytes != 0 && !zip64) throw Error("has extra fields in its ZIP header; write it without (zip -X)");
  const uint64_t end = central.offset + kLocalBytes + nameBytes + extraBytes + entry.compressedBytes;
  if (end > directoryOffset) throw Error("leads into the ZIP directory");
  return end;
}

std::vector<CentralEntry> readDirectory(const FileBytes& file) {
  // The central directory: as many records as it says, end to end.
  const Directory directory = readEnd(file);
  const auto bytes = file.at(directory.offset, directory.size);
  std::vector<CentralEntry> entries;
  std::set<std::string> names;
  size_t place = 0;
  for (uint64_t i = 0; i < directory.count; ++i) {
    entries.push_back(readCentral(std::span(bytes).subspan(place)));
    place += kCentralBytes + entries.back().entry.name.size();
    if (!names.insert(entries.back().entry.name).second) throw Error(entries.back().entry.name + ": is there twice");
  }
  if (place != bytes.size()) throw Error("its ZIP directory is damaged: it is longer than its entries");

  // The entries cover everything in front of it, without gap or overlap.
  std::vector<const CentralEntry*> byOffset;
  for (const CentralEntry& entry : entries) byOffset.push_back(&entry);
  std::ranges::sort(byOffset, {}, [](const CentralEntry* entry) { return entry->offset; });
  uint64_t expected = 0;
  for (const CentralEntry* entry : byOffset) {
    if (entry->offset != expected) throw Error(entry->entry.name + ": does not begin where the entry before it ends");
    try {
      expected = checkLocal(file, *entry, directory.offset);
    } catch (const Error& error) {
      throw error.within(entry->entry.name);
    }
  }
  if (expected != directory.offset) throw Error("has bytes that belong to no entry");
  return entries;
}

std::string zipFault(zip_error_t* error) {
  const std::string text = zip_error_strerror(error);
  zip_error_fini(error);
  return text;
}

}  // namespace

bool isEntryName(const std::string& name) {
  if (name.empty() || name.size() > kMostNameBytes || name.front() == '/' || name.back() == '/') return false;
  for (char c : name)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F || c == '\\' || c == ':') return false;
  for (const auto& part : std::filesystem::path(name))
    if (part == "." || part == ".." || part.empty()) return false;
  return true;
}

struct ZipReader::Archive {
  template <class Source>
  explicit Archive(const Source& source) : file(source), directory(readDirectory(file)) {
    for (const CentralEntry& central : directory) entries.push_back(central.entry);

    // libzip checks once more, with what it knows.
    zip_error_t error;
    zip_error_init(&error);
    int code = 0;
    if (file.descriptor() >= 0) {
      const int copy = ::dup(file.descriptor());
      zip = zip_fdopen(copy, ZIP_CHECKCONS, &code);
      if (zip == nullptr) ::close(copy), zip_error_init_with_code(&error, code);
    } else {
      zip_source_t* bytes = zip_source_buffer_create(file.span().data(), file.span().size(), 0, &error);
      if (bytes != nullptr) zip = zip_open_from_source(bytes, ZIP_CHECKCONS | ZIP_RDONLY, &error);
      if (bytes != nullptr && zip == nullptr) zip_source_free(bytes);
    }
    if (zip == nullptr) throw Error("is a damaged ZIP file: " + zipFault(&error));
    zip_error_fini(&error);
  }
  ~Archive() {
    if (zip != nullptr) zip_discard(zip);
  }
  Archive(const Archive&) = delete;

  FileBytes file;
  std::vector<CentralEntry> directory;
  std::vector<ZipEntry> entries;
  zip_t* zip = nullptr;
};

ZipReader::ZipReader(const std::filesystem::path& file) : archive_(std::make_unique<Archive>(file)) {}
ZipReader::ZipReader(std::span<const std::byte> bytes) : archive_(std::make_unique<Archive>(bytes)) {}
ZipReader::~ZipReader() = default;
ZipReader::ZipReader(ZipReader&&) noexcept = default;

uint64_t ZipReader::fileBytes() const { return archive_->file.size(); }
const std::vector<ZipEntry>& ZipReader::entries() const { return archive_->entries; }

const ZipEntry* ZipReader::find(const std::string& name) const {
  for (const ZipEntry& entry : archive_->entries)
    if (entry.name == name) return &entry;
  return nullptr;
}

std::vector<std::byte> ZipReader::read(const ZipEntry& entry) {
  const auto index = static_cast<uint64_t>(&entry - archive_->entries.data());
  CHECK_LT(index, archive_->entries.size());
  zip_file_t* stream = zip_fopen_index(archive_->zip, index, 0);
  if (stream == nullptr) throw Error(std::string("can't be read: ") + zip_strerror(archive_->zip));

  // All bytes, and then the end, where libzip compares the CRC-32.
  std::vector<std::byte> bytes(entry.bytes);
  std::byte beyond;
  uint64_t done = 0;
  int64_t got = 0;
  while (done < bytes.size() && (got = zip_fread(stream, bytes.data() + done, bytes.size() - done)) > 0) done += static_cast<uint64_t>(got);
  if (got >= 0) got = zip_fread(stream, &beyond, 1);
  const std::string fault = got < 0 ? zip_file_strerror(stream) : "";
  zip_fclose(stream);
  if (got < 0) throw Error("is damaged: " + fault);
  if (got > 0) throw Error("is damaged: it unpacks to more than the " + std::to_string(entry.bytes) + " bytes it should have");
  if (done < bytes.size()) throw Error("is damaged: it ends " + std::to_string(bytes.size() - done) + " bytes early");
  return bytes;
}

struct ZipWriter::Archive {
  zip_source_t* output = nullptr;
  zip_t* zip = nullptr;
  std::vector<std::vector<std::byte>> kept;  // libzip reads them when it finishes
};

ZipWriter::ZipWriter() : archive_(std::make_unique<Archive>()) {
  zip_error_t error;
  zip_error_init(&error);
  archive_->output = zip_source_buffer_create(nullptr, 0, 0, &error);
  CHECK(archive_->output != nullptr);
  archive_->zip = zip_open_from_source(archive_->output, ZIP_CREATE | ZIP_TRUNCATE, &error);
  CHECK(archive_->zip != nullptr);
  zip_error_fini(&error);
  zip_source_keep(archive_->output);
}

ZipWriter::~ZipWriter() {
  if (archive_->zip != nullptr) zip_discard(archive_->zip);
  zip_source_free(archive_->output);
}

void ZipWriter::add(const std::string& name, std::vector<std::byte> bytes) {
  archive_->kept.push_back(std::move(bytes));
  const std::vector<std::byte>& kept = archive_->kept.back();
  if (kept.size() > kMostFileBytes) throw Error(name + ": has more than 4 GiB; capture fewer frames or products");
  zip_source_t* source = zip_source_buffer(archive_->zip, kept.data(), kept.size(), 0);
  const int64_t index = source == nullptr ? -1 : zip_file_add(archive_->zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    if (source != nullptr) zip_source_free(source);
    throw Error(name + ": can't be packed: " + zip_strerror(archive_->zip));
  }
  const auto place = static_cast<uint64_t>(index);
  CHECK_EQ(zip_set_file_compression(archive_->zip, place, ZIP_CM_DEFLATE, kDeflateLevel), 0);
  CHECK_EQ(zip_file_set_dostime(archive_->zip, place, 0, kFixedDate, 0), 0);
  CHECK_EQ(zip_file_set_external_attributes(archive_->zip, place, 0, ZIP_OPSYS_UNIX, 0100644u << 16), 0);
}

std::vector<std::byte> ZipWriter::finish() {
  if (zip_close(archive_->zip) != 0) throw Error(std::string("can't be packed: ") + zip_strerror(archive_->zip));
  archive_->zip = nullptr;
  archive_->kept.clear();

  zip_stat_t facts;
  CHECK_EQ(zip_source_stat(archive_->output, &facts), 0);
  if (facts.size > kMostFileBytes) throw Error("would have more than 4 GiB; capture fewer frames or products");
  std::vector<std::byte> bytes(facts.size);
  CHECK_EQ(zip_source_open(archive_->output), 0);
  CHECK_EQ(zip_source_read(archive_->output, bytes.data(), bytes.size()), static_cast<int64_t>(bytes.size()));
  zip_source_close(archive_->output);
  return bytes;
}

}  // namespace gridscope
