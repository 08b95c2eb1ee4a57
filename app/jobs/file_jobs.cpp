// See file_jobs.h.
#include "app/jobs/file_jobs.h"

#include <chrono>

namespace gridscope {

namespace fs = std::filesystem;

fs::path freePath(const fs::path& wanted, const std::function<bool(const fs::path&)>& taken) {
  fs::path path = wanted;
  for (uint32_t number = 2; taken(path); ++number)
    path = wanted.parent_path() / (wanted.stem().string() + "_" + std::to_string(number) + wanted.extension().string());
  return path;
}

static bool isThere(const fs::path& path) {
  std::error_code fault;
  return fs::exists(fs::symlink_status(path, fault));
}

fs::path freePath(const fs::path& wanted) { return freePath(wanted, isThere); }

fs::path FileJobs::wouldClaim(const fs::path& wanted) const {
  return freePath(wanted, [this](const fs::path& path) { return claimed_.contains(path) || isThere(path); });
}

fs::path FileJobs::claim(const fs::path& wanted) { return *claimed_.insert(wouldClaim(wanted)).first; }

void FileJobs::start(std::function<std::string()> write) {
  jobs_.push_back(std::async(std::launch::async, [write = std::move(write)]() -> News {
    try {
      return {false, write()};
    } catch (const std::exception& error) {
      return {true, error.what()};
    }
  }));
}

std::vector<FileJobs::News> FileJobs::takeNews() {
  std::vector<News> news;
  std::erase_if(jobs_, [&](std::future<News>& job) {
    if (job.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    news.push_back(job.get());
    return true;
  });
  return news;
}

void FileJobs::finish() {
  for (std::future<News>& job : jobs_) job.wait();
}

}  // namespace gridscope
