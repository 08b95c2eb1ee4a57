// Files that the window writes beside itself, each on a thread of its own so that no frame waits, and none over a file that is there already.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <set>
#include <string>
#include <vector>

namespace gridscope {

// "hall.csv", or where that is taken "hall_2.csv", "hall_3.csv", ...
std::filesystem::path freePath(const std::filesystem::path& wanted, const std::function<bool(const std::filesystem::path&)>& taken);
std::filesystem::path freePath(const std::filesystem::path& wanted);  // taken: there is such a file

class FileJobs {
 public:
  // What became of a job.
  struct News {
    bool failed = false;
    std::string text;
  };

  // A free name like `wanted` that no other job of this program gets.
  std::filesystem::path claim(const std::filesystem::path& wanted);
  std::filesystem::path wouldClaim(const std::filesystem::path& wanted) const;

  // `write` runs on a thread and returns what to say of it; what it throws is said too.
  void start(std::function<std::string()> write);

  // Of the jobs that ended since the last call.
  std::vector<News> takeNews();
  bool running() const { return !jobs_.empty(); }
  void finish();  // waits for all: for tests

 private:
  std::vector<std::future<News>> jobs_;
  std::set<std::filesystem::path> claimed_;
};

}  // namespace gridscope
