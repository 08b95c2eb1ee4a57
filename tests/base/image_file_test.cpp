// PNG files: what is written can be read, what fails leaves the old file.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <stb/stb_image.h>

#include "core/base/error.h"
#include "core/base/image_file.h"

namespace gridscope {
namespace {

namespace fs = std::filesystem;

class ImageFile : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("gridscope_image_file_") + test->name() + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  size_t fileCount() const { return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }

  fs::path folder_;
};

TEST_F(ImageFile, WhatIsWrittenIsReadBackBitForBit) {
  Picture picture = makePicture(7, 5, 0x204060);
  for (size_t i = 0; i < picture.rgba.size(); ++i) picture.rgba[i] = static_cast<uint8_t>(i * 37);
  std::string path = folder_ / "picture.png";
  writePng(path, picture);

  int width = 0, height = 0, channels = 0;
  uint8_t* bytes = stbi_load(path.c_str(), &width, &height, &channels, 4);
  ASSERT_NE(bytes, nullptr);
  EXPECT_EQ(width, 7);
  EXPECT_EQ(height, 5);
  EXPECT_EQ(std::vector<uint8_t>(bytes, bytes + 4 * 7 * 5), picture.rgba);
  stbi_image_free(bytes);
  EXPECT_EQ(fileCount(), 1u) << "the temporary file is gone";
}

TEST_F(ImageFile, AnOldFileIsReplaced) {
  std::string path = folder_ / "picture.png";
  std::ofstream(path) << "old";
  writePng(path, makePicture(2, 2, 0xFFFFFF));
  EXPECT_NE(fs::file_size(path), 3u);
}

TEST_F(ImageFile, AMissingFolderIsNamed) {
  std::string path = folder_ / "missing" / "picture.png";
  try {
    writePng(path, makePicture(2, 2, 0));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
    EXPECT_EQ(error.exitCode(), kExitBadInput);
  }
}

TEST_F(ImageFile, WhatCannotBeReplacedStaysAndNothingIsLeftBehind) {
  // A folder that is not empty can't be replaced by a file, whoever runs this.
  fs::path target = folder_ / "picture.png";
  fs::create_directory(target);
  std::ofstream(target / "inside") << "old";
  EXPECT_THROW(writePng(target, makePicture(2, 2, 0)), Error);
  EXPECT_TRUE(fs::exists(target / "inside"));
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(ImageFile, AFullDiskLeavesTheOldFile) {
  // The temporary file's name leads to a device that is always full.
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  fs::path target = folder_ / "picture.png";
  std::ofstream(target) << "old";
  fs::create_symlink("/dev/full", target.string() + ".part-" + std::to_string(getpid()));
  EXPECT_THROW(writePng(target, makePicture(2, 2, 0)), Error);
  std::string content;
  std::ifstream(target) >> content;
  EXPECT_EQ(content, "old");
}

TEST_F(ImageFile, APictureWithoutPixelsIsRefused) {
  EXPECT_THROW(writePng(folder_ / "picture.png", Picture{}), Error);
  EXPECT_EQ(fileCount(), 0u);
}

}  // namespace
}  // namespace gridscope
