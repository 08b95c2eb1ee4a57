// The program as a child process in a folder of the test's own.
#pragma once

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace gridscope {

inline std::string fileText(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

class ProgramTest : public testing::Test {
 protected:
  struct Ended {
    int exitCode;  // -1: by a signal
    std::string out;
    std::string err;
  };

  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("gridscope_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Ended run(std::vector<std::string> arguments, const std::string& program = GRIDSCOPE_PROGRAM) {
    const std::filesystem::path out = folder_ / "stdout.txt", err = folder_ / "stderr.txt";
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      const int outFile = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600),
                errFile = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      if (chdir(folder_.c_str()) != 0 || dup2(outFile, 1) < 0 || dup2(errFile, 2) < 0) _exit(127);
      execvp(argv[0], argv.data());
      _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, fileText(out), fileText(err)};
  }

  std::filesystem::path folder_;
};

}  // namespace gridscope
