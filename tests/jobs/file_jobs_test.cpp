// Files that the window writes: free names, and what becomes of a job.
#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

#include "app/jobs/file_jobs.h"

namespace gridscope {

namespace {

class FileJobsTest : public testing::Test {
 protected:
  FileJobsTest() { std::filesystem::create_directories(folder_); }
  ~FileJobsTest() override { std::filesystem::remove_all(folder_); }
  void touch(const char* name) { std::ofstream(folder_ / name) << "old"; }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("gridscope_file_jobs_" + std::to_string(::getpid()));
};

TEST_F(FileJobsTest, AFileThatIsThereGivesTheNextNameItsNumber) {
  EXPECT_EQ(freePath(folder_ / "hall.gridcap"), folder_ / "hall.gridcap");
  touch("hall.gridcap");
  EXPECT_EQ(freePath(folder_ / "hall.gridcap"), folder_ / "hall_2.gridcap");
  touch("hall_2.gridcap");
  EXPECT_EQ(freePath(folder_ / "hall.gridcap"), folder_ / "hall_3.gridcap");
}

TEST_F(FileJobsTest, TwoJobsNeverGetOneNameEvenBeforeTheFirstHasWritten) {
  FileJobs jobs;
  const auto first = jobs.claim(folder_ / "hall_final.png"), second = jobs.claim(folder_ / "hall_final.png");
  EXPECT_EQ(first, folder_ / "hall_final.png");
  EXPECT_EQ(second, folder_ / "hall_final_2.png");
  EXPECT_EQ(jobs.wouldClaim(folder_ / "hall_final.png"), folder_ / "hall_final_3.png");
}

TEST_F(FileJobsTest, EachJobSaysOnceWhatBecameOfIt) {
  FileJobs jobs;
  jobs.start([] { return std::string("Wrote it"); });
  jobs.start([]() -> std::string { throw std::runtime_error("the disk is full"); });
  jobs.finish();
  const std::vector<FileJobs::News> news = jobs.takeNews();
  ASSERT_EQ(news.size(), 2u);
  EXPECT_FALSE(news[0].failed);
  EXPECT_EQ(news[0].text, "Wrote it");
  EXPECT_TRUE(news[1].failed);
  EXPECT_EQ(news[1].text, "the disk is full");
  EXPECT_TRUE(jobs.takeNews().empty());
  EXPECT_FALSE(jobs.running());
}

}  // namespace

}  // namespace gridscope
