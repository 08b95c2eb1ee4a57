// Reading and writing .npy arrays, on good and on hostile bytes.
#include "core/base/npy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>

namespace gridscope {
namespace {

std::vector<std::byte> bytesOf(std::string_view text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

// A file of version 1.0 with this header and data bytes.
std::vector<std::byte> fileWith(const std::string& header, size_t dataBytes) {
  std::string text("\x93NUMPY\x01\x00", 8);
  text += {char(header.size() & 255), char(header.size() >> 8)};
  text += header + std::string(dataBytes, '\0');
  return bytesOf(text);
}

std::string faultOf(const std::vector<std::byte>& file) {
  try {
    parseNpy(file);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), kExitBadInput);
    return error.what();
  }
  return "";
}

template <class Value>
void expectRoundTrip(const std::vector<Value>& values, const std::vector<uint64_t>& shape) {
  const std::vector<std::byte> file = formatNpy<Value>(shape, values);
  const NpyArray array = parseNpy(file);
  EXPECT_EQ(array.type, npyTypeOf<Value>());
  EXPECT_EQ(array.shape, shape);
  ASSERT_EQ(array.elementCount(), values.size());
  EXPECT_EQ(std::memcmp(array.bytes.data(), values.data(), array.bytes.size()), 0);
  EXPECT_EQ((file.size() - array.bytes.size()) % 64, 0u);
}

TEST(Npy, EveryTypeComesBackAsItWasWritten) {
  expectRoundTrip<uint8_t>({0, 255, 7}, {3});
  expectRoundTrip<uint16_t>({0, 65535}, {1, 2});
  expectRoundTrip<uint32_t>({0, 0xFFFFFFFFu}, {2, 1});
  expectRoundTrip<uint64_t>({~uint64_t(0)}, {1, 1, 1});
  expectRoundTrip<int32_t>({-1, 5, 6, 7, 8, 9}, {2, 3});
  expectRoundTrip<int64_t>({INT64_MIN}, {});
  expectRoundTrip<float>({1.5f, -0.0f, INFINITY}, {3});
  expectRoundTrip<double>({1e-300, 3.0}, {2});
}

TEST(Npy, AnEmptyArrayHasAShape) {
  const NpyArray array = parseNpy(formatNpy<float>(std::vector<uint64_t>{0, 6}, {}));
  EXPECT_EQ(array.shape, (std::vector<uint64_t>{0, 6}));
  EXPECT_EQ(array.elementCount(), 0u);
}

TEST(Npy, HeadersOfVersionTwoAndOtherSpellingsAreRead) {
  const std::string header = "{\"shape\":(2,),'fortran_order':False,'descr':'<u1'}\n";
  std::string text("\x93NUMPY\x02\x00", 8);
  text += {char(header.size()), 0, 0, 0};
  text += header + "ab";
  const NpyArray array = parseNpy(bytesOf(text));
  EXPECT_EQ(array.type, NpyType::u1);
  EXPECT_EQ(array.values<uint8_t>()[1], 'b');
}

TEST(Npy, EveryTruncationIsRefused) {
  const std::vector<float> values = {1, 2, 3, 4, 5, 6};
  const std::vector<std::byte> file = formatNpy<float>(std::vector<uint64_t>{2, 3}, values);
  for (size_t length = 0; length < file.size(); ++length) {
    // A fresh allocation of just this size, so that the address sanitizer sees a read beyond it.
    std::unique_ptr<std::byte[]> part(new std::byte[length]);
    std::memcpy(part.get(), file.data(), length);
    EXPECT_THROW(parseNpy({part.get(), length}), Error) << length << " bytes";
  }
}

TEST(Npy, EveryFlippedHeaderBitIsRefusedOrKeepsTheArraysSize) {
  const std::vector<float> values = {1, 2, 3, 4, 5, 6};
  const std::vector<std::byte> file = formatNpy<float>(std::vector<uint64_t>{2, 3}, values);
  for (size_t bit = 0; bit < (file.size() - 24) * 8; ++bit) {
    std::vector<std::byte> flipped = file;
    flipped[bit / 8] ^= std::byte(1 << (bit % 8));
    try {
      EXPECT_EQ(parseNpy(flipped).bytes.size(), 24u) << "bit " << bit;
    } catch (const Error&) {
    }
  }
}

TEST(Npy, FaultsAreNamed) {
  const std::string good = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }\n";
  EXPECT_EQ(faultOf(fileWith(good, 24)), "");
  EXPECT_EQ(faultOf(fileWith(good, 12)), "ends 12 bytes early");
  EXPECT_EQ(faultOf(fileWith(good, 25)), "has 1 bytes more than its shape (2, 3) says");
  EXPECT_EQ(faultOf(bytesOf("PK\x03\x04 something else")), "is not a .npy file");
  EXPECT_NE(faultOf(fileWith("{'descr': '>f4', 'fortran_order': False, 'shape': (2,), }", 8)).find("little-endian"), std::string::npos);
  EXPECT_NE(faultOf(fileWith("{'descr': '<f4', 'fortran_order': True, 'shape': (2,), }", 8)).find("Fortran"), std::string::npos);
  EXPECT_NE(faultOf(fileWith("{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (2,), }", 8)).find("structured"),
            std::string::npos);
  EXPECT_NE(faultOf(fileWith("{'descr': '|O', 'fortran_order': False, 'shape': (2,), }", 8)).find("not supported"), std::string::npos);
  EXPECT_NE(faultOf(fileWith("{'descr': '<f4', 'shape': (2,), }", 8)).find("lacks"), std::string::npos);
  EXPECT_NE(faultOf(fileWith("{'descr': '<f4', 'descr': '<f4', 'fortran_order': False, 'shape': (2,), }", 8)).find("twice"),
            std::string::npos);
  EXPECT_NE(faultOf(fileWith(good + "x", 24)).find("behind its end"), std::string::npos);
}

TEST(Npy, AShapeWhoseProductOverflowsIsRefusedWithoutAllocating) {
  for (const char* shape : {"(4294967296, 4294967296)", "(18446744073709551615,)", "(4611686018427387904, 1)", "(2305843009213693952, 8)"})
    EXPECT_NE(faultOf(fileWith(std::string("{'descr': '<f4', 'fortran_order': False, 'shape': ") + shape + ", }", 24)), "") << shape;
  EXPECT_NE(faultOf(fileWith("{'descr': '<f4', 'fortran_order': False, 'shape': (18446744073709551616,), }", 0)), "");
  EXPECT_NE(faultOf(fileWith("{'descr': '<f4', 'fortran_order': False, 'shape': (-1,), }", 0)), "");
}

TEST(Npy, AFileIsReadUpToALimit) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "npy_test_limit.npy";
  const std::vector<uint32_t> values = {1, 2, 3};
  const std::vector<std::byte> bytes = formatNpy<uint32_t>(std::vector<uint64_t>{3}, values);
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  EXPECT_EQ(readNpy(path, 1000).values<uint32_t>()[2], 3u);
  EXPECT_THROW(readNpy(path, 100), Error);
  std::filesystem::remove(path);
  EXPECT_THROW(readNpy(path, 1000), Error);
  EXPECT_THROW(readNpy(path.parent_path(), 1000), Error);
}

}  // namespace
}  // namespace gridscope
