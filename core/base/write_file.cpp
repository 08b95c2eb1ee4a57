// See write_file.h.
#include "core/base/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/base/error.h"

namespace gridscope {
namespace {

// A file beside the one to be, gone when it is not renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) : target_(target), name_(target.string() + ".XXXXXX") {
    descriptor_ = ::mkostemp(name_.data(), O_CLOEXEC);
    if (descriptor_ < 0) throw fault();
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(descriptor_, 0666 & ~mask) != 0) throw dropped();
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) drop();
  }
  TemporaryFile(const TemporaryFile&) = delete;

  void write(std::span<const std::byte> bytes) {
    for (size_t done = 0; done < bytes.size();) {
      const ssize_t written = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
      if (written < 0 && errno != EINTR) throw fault();
      if (written > 0) done += static_cast<size_t>(written);
    }
  }

  // From here on the file is there, whole, even when the power fails.
  void rename() {
    if (::fsync(descriptor_) != 0 || ::rename(name_.c_str(), target_.c_str()) != 0) throw fault();
    ::close(descriptor_);
    descriptor_ = -1;
    const std::filesystem::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
    const int folderDescriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folderDescriptor < 0) return;
    ::fsync(folderDescriptor);
    ::close(folderDescriptor);
  }

 private:
  Error fault() const {
    const std::string reason = std::strerror(errno);
    return Error("can't be saved: " + reason +
                 (std::filesystem::exists(target_) ? "; the file that was there is unchanged" : "; nothing was written"));
  }
  Error dropped() {
    const Error error = fault();
    drop();
    return error;
  }
  void drop() {
    ::close(descriptor_);
    ::unlink(name_.c_str());
    descriptor_ = -1;
  }

  std::filesystem::path target_;
  std::string name_;
  int descriptor_ = -1;
};

}  // namespace

void writeWholeFile(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  std::error_code problem;
  TemporaryFile temporary(std::filesystem::is_symlink(file, problem) ? std::filesystem::weakly_canonical(file) : file);
  temporary.write(bytes);
  temporary.rename();
}

}  // namespace gridscope
