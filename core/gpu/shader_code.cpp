// See shader_code.h. Numbers of the SPIR-V specification, version 1.6.
#include "core/gpu/shader_code.h"

#include <algorithm>
#include <list>
#include <mutex>
#include <set>
#include <unordered_map>

#include "core/base/error.h"

namespace gridscope {
namespace {

constexpr size_t kHeaderWords = 5;

enum Op : uint32_t {
  kOpMemoryModel = 14,
  kOpEntryPoint = 15,
  kOpExecutionMode = 16,
  kOpCapability = 17,
  kOpTypeInt = 21,
  kOpTypeFloat = 22,
  kOpTypeVector = 23,
  kOpTypeArray = 28,
  kOpTypeStruct = 30,
  kOpTypePointer = 32,
  kOpConstant = 43,
  kOpDecorate = 71,
  kOpMemberDecorate = 72,
  kOpFunction = 54,
};
constexpr uint32_t kDecorationOffset = 35;
constexpr uint32_t kDecorationNoContraction = 42;
constexpr uint32_t kModeLocalSize = 17;
constexpr uint32_t kModeSignedZeroInfNanPreserve = 4461;
constexpr uint32_t kModeRoundingRte = 4462;
constexpr uint32_t kCapabilitySignedZeroInfNanPreserve = 4466;
constexpr uint32_t kCapabilityRoundingRte = 4467;
constexpr uint32_t kStoragePushConstant = 9;

// OpFNegate, OpFAdd, OpFSub, OpFMul, OpFDiv, OpFRem, OpFMod, OpVectorTimesScalar .. OpDot: what NoContraction may stand on.
bool isFloatArithmetic(uint32_t op) {
  return op == 127 || op == 129 || op == 131 || op == 133 || op == 136 || op == 140 || op == 141 || (op >= 142 && op <= 148);
}

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

void append(std::vector<uint32_t>& words, uint32_t op, std::initializer_list<uint32_t> operands) {
  words.push_back(uint32_t(operands.size() + 1) << 16 | op);
  words.insert(words.end(), operands);
}

// Sizes of the types that a push constant block can be made of.
struct TypeSizes {
  std::unordered_map<uint32_t, uint32_t> bytes;
  std::unordered_map<uint32_t, uint32_t> constants;
  std::unordered_map<uint32_t, std::vector<uint32_t>> members;  // of structures
  std::unordered_map<uint32_t, std::unordered_map<uint32_t, uint32_t>> offsets;

  uint32_t structureBytes(uint32_t type) {
    uint32_t end = 0;
    for (uint32_t member = 0; member < members[type].size(); ++member)
      end = std::max(end, offsets[type][member] + bytes[members[type][member]]);
    return end;
  }
};

}  // namespace

// What replaces the embedded passes. Earlier replacements stay: another thread may be making a pass from one.
struct ReplacedShaders {
  std::mutex mutex;
  std::list<ShaderWords> generations{1};
};

static ReplacedShaders& replacedShaders() {
  static ReplacedShaders replaced;
  return replaced;
}

ShaderWords replaceShaders(ShaderWords wordsByStem) {
  ReplacedShaders& replaced = replacedShaders();
  const std::lock_guard lock(replaced.mutex);
  const ShaderWords before = replaced.generations.back();
  replaced.generations.push_back(std::move(wordsByStem));
  return before;
}

std::span<const uint32_t> shaderCode(std::string_view stem) {
  {
    ReplacedShaders& replaced = replacedShaders();
    const std::lock_guard lock(replaced.mutex);
    const ShaderWords& now = replaced.generations.back();
    if (const auto found = now.find(std::string(stem)); found != now.end()) return found->second;
  }
  for (const ShaderCode& shader : allShaders())
    if (shader.stem == stem) return shader.words;
  CHECK_EQ(stem, "a shader that was built");
  return {};
}

std::vector<uint32_t> makeExact(std::span<const uint32_t> words, bool roundingControl) {
  std::vector<uint32_t> floats;  // result ids of float operations
  std::set<uint32_t> already;    // ids with the decoration
  uint32_t entryPoint = 0;
  forInstructions(words, [&](uint32_t op, std::span<const uint32_t> instruction) {
    if (isFloatArithmetic(op)) floats.push_back(instruction[2]);
    if (op == kOpDecorate && instruction[2] == kDecorationNoContraction) already.insert(instruction[1]);
    if (op == kOpEntryPoint) entryPoint = instruction[2];
  });

  // Decorations stand before the first type; capabilities first of all; execution modes behind the entry points.
  std::vector<uint32_t> exact(words.begin(), words.begin() + kHeaderWords);
  bool decorated = false, modes = false;
  if (roundingControl) {
    append(exact, kOpCapability, {kCapabilitySignedZeroInfNanPreserve});
    append(exact, kOpCapability, {kCapabilityRoundingRte});
  }
  forInstructions(words, [&](uint32_t op, std::span<const uint32_t> instruction) {
    if (!decorated && ((op >= 19 && op <= 39) || op == kOpDecorate || op == kOpMemberDecorate)) {
      decorated = true;
      for (uint32_t id : floats)
        if (!already.count(id)) append(exact, kOpDecorate, {id, kDecorationNoContraction});
    }
    exact.insert(exact.end(), instruction.begin(), instruction.end());
    if (op == kOpEntryPoint && roundingControl && !modes) {
      modes = true;
      append(exact, kOpExecutionMode, {entryPoint, kModeSignedZeroInfNanPreserve, 32});
      append(exact, kOpExecutionMode, {entryPoint, kModeRoundingRte, 32});
    }
  });
  return exact;
}

ShaderFacts readFacts(std::span<const uint32_t> words) {
  ShaderFacts facts;
  TypeSizes types;
  forInstructions(words, [&](uint32_t op, std::span<const uint32_t> i) {
    if (op == kOpExecutionMode && i[2] == kModeLocalSize) std::copy(i.begin() + 3, i.begin() + 6, facts.localSize);
    if (op == kOpMemberDecorate && i[3] == kDecorationOffset) types.offsets[i[1]][i[2]] = i[4];
    if (op == kOpTypeInt || op == kOpTypeFloat) types.bytes[i[1]] = i[2] / 8;
    if (op == kOpTypeVector) types.bytes[i[1]] = types.bytes[i[2]] * i[3];
    if (op == kOpConstant && i.size() == 4) types.constants[i[2]] = i[3];
    if (op == kOpTypeArray) types.bytes[i[1]] = types.bytes[i[2]] * types.constants[i[3]];
    if (op == kOpTypeStruct) {
      types.members[i[1]].assign(i.begin() + 2, i.end());
      types.bytes[i[1]] = types.structureBytes(i[1]);
    }
    if (op == kOpTypePointer && i[2] == kStoragePushConstant)
      facts.pushConstantBytes = std::max(facts.pushConstantBytes, types.bytes[i[3]]);
  });
  return facts;
}

}  // namespace gridscope
