// Walking a SPIR-V module's words. Numbers of the SPIR-V specification, version 1.6.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace gridscope::spirv {

inline constexpr size_t kHeaderWords = 5;

enum Op : uint32_t {
  kOpName = 5,
  kOpEntryPoint = 15,
  kOpExecutionMode = 16,
  kOpCapability = 17,
  kOpTypeInt = 21,
  kOpTypeFloat = 22,
  kOpTypeVector = 23,
  kOpTypeImage = 25,
  kOpTypeSampledImage = 27,
  kOpTypeArray = 28,
  kOpTypeStruct = 30,
  kOpTypePointer = 32,
  kOpConstant = 43,
  kOpFunction = 54,
  kOpFunctionCall = 57,
  kOpVariable = 59,
  kOpImageTexelPointer = 60,
  kOpLoad = 61,
  kOpStore = 62,
  kOpAccessChain = 65,
  kOpInBoundsAccessChain = 66,
  kOpArrayLength = 68,
  kOpDecorate = 71,
  kOpMemberDecorate = 72,
  kOpCopyObject = 83,
};

enum Decoration : uint32_t {
  kDecorationSpecId = 1,
  kDecorationBinding = 33,
  kDecorationDescriptorSet = 34,
  kDecorationOffset = 35,
  kDecorationNoContraction = 42,
};

enum Storage : uint32_t {
  kStorageUniformConstant = 0,
  kStorageUniform = 2,
  kStoragePushConstant = 9,
  kStorageStorageBuffer = 12,
};

// Calls visit(op, instruction words) for each instruction in order.
template <typename Visit>
void forInstructions(std::span<const uint32_t> words, const Visit& visit) {
  for (size_t at = kHeaderWords; at < words.size();) {
    uint32_t count = words[at] >> 16;
    CHECK(count > 0 && at + count <= words.size());
    visit(words[at] & 0xFFFFu, words.subspan(at, count));
    at += count;
  }
}

inline void append(std::vector<uint32_t>& words, uint32_t op, std::initializer_list<uint32_t> operands) {
  words.push_back(uint32_t(operands.size() + 1) << 16 | op);
  words.insert(words.end(), operands);
}

// A literal string, which ends with the word that holds a zero byte. `wordCount`, if given: its words.
inline std::string literalText(std::span<const uint32_t> words, size_t* wordCount = nullptr) {
  std::string text;
  size_t count = 0;
  for (bool ended = false; !ended && count < words.size(); ++count)
    for (int byte = 0; byte < 4 && !ended; ++byte) {
      char character = char(words[count] >> (8 * byte));
      ended = character == '\0';
      if (!ended) text += character;
    }
  if (wordCount) *wordCount = count;
  return text;
}

}  // namespace gridscope::spirv
