// Verdicts as a JUnit file, which CI services read: a test case a capture.
// Source: the format that Jenkins, GitLab and GitHub's actions take (testsuite, testcase, failure, error, skipped).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gridscope {

struct JUnitCase {
  enum class Outcome { passed, failure, error, skipped };
  std::string name;
  Outcome outcome = Outcome::passed;
  std::string message;  // one line; of anything but passed
  std::string details;  // lines below it
  double seconds = 0.0;
};

std::string junitText(const std::string& suite, const std::vector<JUnitCase>& cases);

// Throws Error.
void writeJUnit(const std::filesystem::path& file, const std::string& suite, const std::vector<JUnitCase>& cases);

}  // namespace gridscope
