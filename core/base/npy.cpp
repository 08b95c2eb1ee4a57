// See npy.h.
#include "core/base/npy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>

namespace gridscope {

static_assert(std::endian::native == std::endian::little, "arrays are taken as they lie in the file");

namespace {

constexpr std::string_view kMagic{"\x93NUMPY", 6};
constexpr size_t kMostHeaderBytes = 65536;  // a header of ours has 118; numpy's own limit is 10,000
constexpr size_t kMostDimensions = 32;      // numpy's

struct TypeRow {
  NpyType type;
  const char* name;
  size_t size;
};
constexpr std::array<TypeRow, 8> kTypes = {{{NpyType::u1, "|u1", 1},
                                            {NpyType::u2, "<u2", 2},
                                            {NpyType::u4, "<u4", 4},
                                            {NpyType::u8, "<u8", 8},
                                            {NpyType::i4, "<i4", 4},
                                            {NpyType::i8, "<i8", 8},
                                            {NpyType::f4, "<f4", 4},
                                            {NpyType::f8, "<f8", 8}}};

const TypeRow& rowOf(NpyType type) { return kTypes[static_cast<size_t>(type)]; }

// Reads the header's Python dictionary: {'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }, keys in any order.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view text) : rest_(text) {}

  void read(NpyHeader& array) {
    expect('{');
    while (!take('}')) {
      const std::string_view key = readText();
      expect(':');
      if (key == "descr")
        once(hasType_), array.type = readType();
      else if (key == "fortran_order")
        once(hasOrder_), readOrder();
      else if (key == "shape")
        once(hasShape_), array.shape = readShape();
      else
        throw Error("the header has an unknown key");
      if (!take(',')) {
        expect('}');
        break;
      }
    }
    skipBlanks();
    if (!rest_.empty()) throw Error("the header goes on behind its end");
    if (!hasType_ || !hasOrder_ || !hasShape_) throw Error("the header lacks descr, fortran_order or shape");
  }

 private:
  void skipBlanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\n"), rest_.size())); }

  bool take(char c) {
    skipBlanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char c) {
    if (!take(c)) throw Error(std::string("the header is damaged: no ") + c + " where one belongs");
  }

  void once(bool& seen) {
    if (seen) throw Error("the header has a key twice");
    seen = true;
  }

  std::string_view readText() {
    const char quote = take('"') ? '"' : (expect('\''), '\'');
    const size_t end = rest_.find(quote);
    if (end == std::string_view::npos) throw Error("the header is damaged: a text without an end");
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return text;
  }

  NpyType readType() {
    skipBlanks();
    if (!rest_.empty() && rest_.front() == '[') throw Error("structured arrays are not supported; store plain columns");
    const std::string_view name = readText();
    for (const TypeRow& row : kTypes)
      if (name == row.name) return row.type;
    if (name == "<u1") return NpyType::u1;
    throw Error("this element type is not supported; store little-endian u1, u2, u4, u8, i4, i8, f4 or f8");
  }

  void readOrder() {
    skipBlanks();
    if (rest_.starts_with("True")) throw Error("the array is in Fortran order; store it with numpy.ascontiguousarray");
    if (!rest_.starts_with("False")) throw Error("the header is damaged: fortran_order is neither True nor False");
    rest_.remove_prefix(5);
  }

  std::vector<uint64_t> readShape() {
    std::vector<uint64_t> shape;
    expect('(');
    while (!take(')')) {
      skipBlanks();
      uint64_t side = 0;
      const auto [end, fault] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), side);
      if (fault != std::errc()) throw Error("the header is damaged: a shape of something else than whole numbers");
      rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
      shape.push_back(side);
      if (shape.size() > kMostDimensions) throw Error("the array has more than 32 dimensions");
      if (!take(',')) {
        expect(')');
        break;
      }
    }
    return shape;
  }

  std::string_view rest_;
  bool hasType_ = false;
  bool hasOrder_ = false;
  bool hasShape_ = false;
};

// Bytes of an array; nothing when they do not fit into 64 bits.
std::optional<uint64_t> byteCount(NpyType type, std::span<const uint64_t> shape) {
  uint64_t bytes = npyTypeSize(type);
  for (uint64_t side : shape)
    if (__builtin_mul_overflow(bytes, side, &bytes)) return std::nullopt;
  return bytes;
}

uint64_t readLittleEndian(std::span<const std::byte> bytes) {
  uint64_t value = 0;
  for (size_t i = 0; i < bytes.size(); ++i) value |= std::to_integer<uint64_t>(bytes[i]) << (8 * i);
  return value;
}

void checkSize(const NpyHeader& array, uint64_t present) {
  const std::optional<uint64_t> wanted = byteCount(array.type, array.shape);
  if (!wanted) throw Error("the shape " + npyShapeText(array.shape) + " is too large for any file");
  if (*wanted > present) throw Error("ends " + std::to_string(*wanted - present) + " bytes early");
  if (*wanted < present)
    throw Error("has " + std::to_string(present - *wanted) + " bytes more than its shape " + npyShapeText(array.shape) + " says");
}

}  // namespace

size_t npyTypeSize(NpyType type) { return rowOf(type).size; }
const char* npyTypeName(NpyType type) { return rowOf(type).name; }

std::string npyShapeText(std::span<const uint64_t> shape) {
  std::string text = "(";
  for (size_t i = 0; i < shape.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(shape[i]);
  return text + (shape.size() == 1 ? ",)" : ")");
}

uint64_t npyByteCount(NpyType type, std::span<const uint64_t> shape) { return byteCount(type, shape).value_or(UINT64_MAX); }

NpyHeader parseNpyHeader(std::span<const std::byte> file) {
  // Magic, version, and where the header ends: 2 bytes of length in version 1, 4 in versions 2 and 3.
  if (file.size() < 8 || std::memcmp(file.data(), kMagic.data(), kMagic.size()) != 0) throw Error("is not a .npy file");
  const int version = std::to_integer<int>(file[6]);
  if (version < 1 || version > 3 || std::to_integer<int>(file[7]) != 0)
    throw Error("is of an unknown .npy version; versions 1.0, 2.0 and 3.0 are known");
  const size_t lengthBytes = version == 1 ? 2 : 4;
  if (file.size() < 8 + lengthBytes) throw Error("ends within its header");
  const uint64_t headerBytes = readLittleEndian(file.subspan(8, lengthBytes));
  const size_t headerBegin = 8 + lengthBytes;
  if (headerBytes > kMostHeaderBytes) throw Error("has a header of more than 65536 bytes");
  if (headerBytes > file.size() - headerBegin) throw Error("ends within its header");

  NpyHeader header;
  HeaderReader({reinterpret_cast<const char*>(file.data()) + headerBegin, headerBytes}).read(header);
  header.dataOffset = headerBegin + headerBytes;
  return header;
}

NpyArray parseNpy(std::span<const std::byte> file) {
  NpyHeader header = parseNpyHeader(file);
  const std::span<const std::byte> data = file.subspan(header.dataOffset);
  checkSize(header, data.size());
  return {.type = header.type, .shape = std::move(header.shape), .bytes = {data.begin(), data.end()}};
}

NpyArray readNpy(const std::filesystem::path& file, uint64_t maxBytes) {
  const std::string name = file.string();
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault)) throw Error(name + ": no such file; give a .npy file");
  const uint64_t size = std::filesystem::file_size(file, fault);
  if (fault) throw Error(name + ": can't be read: " + fault.message());
  if (size > maxBytes) throw Error(name + ": has " + std::to_string(size) + " bytes; at most " + std::to_string(maxBytes) + " are read");

  std::vector<std::byte> bytes(size);
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    throw Error(name + ": can't be read; check its permissions");
  try {
    return parseNpy(bytes);
  } catch (const Error& error) {
    throw error.within(name);
  }
}

std::vector<std::byte> formatNpyHeader(NpyType type, std::span<const uint64_t> shape) {
  // The data begins at a multiple of 64 bytes; the header ends with a line feed.
  std::string header =
      std::string("{'descr': '") + npyTypeName(type) + "', 'fortran_order': False, 'shape': " + npyShapeText(shape) + ", }";
  const size_t prefix = kMagic.size() + 4;
  header.append(63 - (prefix + header.size()) % 64, ' ');
  header += '\n';
  CHECK_LE(header.size(), kMostHeaderBytes - 1);

  std::string text(kMagic);
  text += {char(1), char(0), char(header.size() & 255), char(header.size() >> 8)};
  text += header;
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

std::vector<std::byte> formatNpy(NpyType type, std::span<const uint64_t> shape, std::span<const std::byte> data) {
  const std::optional<uint64_t> bytes = byteCount(type, shape);
  CHECK(bytes.has_value());
  CHECK_EQ(*bytes, data.size());
  std::vector<std::byte> file = formatNpyHeader(type, shape);
  file.insert(file.end(), data.begin(), data.end());
  return file;
}

}  // namespace gridscope
