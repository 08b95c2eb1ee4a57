// The three kinds of fault: our own mistake (CHECK), the world's fault (Error with an exit code), a Vulkan call that failed
// (core/gpu/context.h turns it into an Error with kDeviceFailed).
#pragma once

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace gridscope {

// Exit codes of every command.
enum ExitCode {
  kExitDone = 0,       // done, or equal
  kExitDifferent = 1,  // a comparison found a difference, or a check failed
  kExitBadInput = 2,   // a file, a setting or an argument can't be used
  kExitDevice = 3,     // the device can't do what was asked, or was lost
};

// The world's fault. The message is one line for a person: what is wrong with which file or option, and what to do.
class Error : public std::runtime_error {
 public:
  explicit Error(std::string message, ExitCode exitCode = kExitBadInput) : std::runtime_error(std::move(message)), exitCode_(exitCode) {}
  ExitCode exitCode() const { return exitCode_; }

  // The same error with "context: " in front, as it travels up to somebody who knows the file's name.
  Error within(const std::string& context) const { return Error(context + ": " + what(), exitCode_); }

 private:
  ExitCode exitCode_;
};

}  // namespace gridscope

// Our own mistake: prints the expression with both values and aborts.
#define GRIDSCOPE_CHECK_OP(a, op, b)                                                                                  \
  do {                                                                                                                \
    const auto& checkA = (a);                                                                                         \
    const auto& checkB = (b);                                                                                         \
    if (!(checkA op checkB)) {                                                                                        \
      std::ostringstream text;                                                                                        \
      text << __FILE__ << ':' << __LINE__ << ": CHECK " #a " " #op " " #b " failed: " << checkA << " and " << checkB; \
      std::fprintf(stderr, "%s\n", text.str().c_str());                                                               \
      std::abort();                                                                                                   \
    }                                                                                                                 \
  } while (false)
#define CHECK(condition) GRIDSCOPE_CHECK_OP(static_cast<bool>(condition), ==, true)
#define CHECK_EQ(a, b) GRIDSCOPE_CHECK_OP(a, ==, b)
#define CHECK_LE(a, b) GRIDSCOPE_CHECK_OP(a, <=, b)
#define CHECK_LT(a, b) GRIDSCOPE_CHECK_OP(a, <, b)
