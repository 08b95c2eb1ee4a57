// See shader_facts.h.
#include "core/gpu/shader_facts.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "core/gpu/spirv.h"

namespace gridscope {
namespace {

using namespace spirv;

constexpr uint32_t kModeLocalSize = 17;
constexpr uint32_t kModeSignedZeroInfNanPreserve = 4461;
constexpr uint32_t kModeRoundingRte = 4462;
constexpr uint32_t kCapabilitySignedZeroInfNanPreserve = 4466;
constexpr uint32_t kCapabilityRoundingRte = 4467;

// OpFNegate, OpFAdd, OpFSub, OpFMul, OpFDiv, OpFRem, OpFMod, OpVectorTimesScalar .. OpDot: what NoContraction may stand on.
bool isFloatArithmetic(uint32_t op) {
  return op == 127 || op == 129 || op == 131 || op == 133 || op == 136 || op == 140 || op == 141 || (op >= 142 && op <= 148);
}

ShaderStage stageOf(uint32_t executionModel) {
  switch (executionModel) {
    case 0: return ShaderStage::vertex;
    case 3: return ShaderStage::geometry;
    case 4: return ShaderStage::fragment;
    default: CHECK_EQ(executionModel, 5u); return ShaderStage::compute;
  }
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

// The pointers that an instruction of a function's body looks at. glslang reaches a global variable by these instructions alone.
std::span<const uint32_t> pointersOf(uint32_t op, std::span<const uint32_t> instruction) {
  switch (op) {
    case kOpStore: return instruction.subspan(1, 1);
    case kOpLoad:
    case kOpAccessChain:
    case kOpInBoundsAccessChain:
    case kOpImageTexelPointer:
    case kOpArrayLength:
    case kOpCopyObject: return instruction.subspan(3, 1);
    case kOpFunctionCall: return instruction.subspan(4);
    default: return {};
  }
}

// A module's variables that a binding belongs to, and which of them its code touches.
struct ResourceVariables {
  std::map<uint32_t, uint32_t> bindings;  // by the variable's id
  std::set<uint32_t> touched;             // ids

  explicit ResourceVariables(std::span<const uint32_t> words) {
    bool inFunction = false;
    forInstructions(words, [&](uint32_t op, std::span<const uint32_t> i) {
      if (op == kOpDecorate && i[2] == kDecorationBinding) bindings[i[1]] = i[3];
      if (op == kOpDecorate && i[2] == kDecorationDescriptorSet) CHECK_EQ(i[3], 0u);
      inFunction = inFunction || op == kOpFunction;
      if (!inFunction) return;
      for (uint32_t id : pointersOf(op, i))
        if (bindings.count(id)) touched.insert(id);
    });
  }
  bool unused(uint32_t id) const { return bindings.count(id) && !touched.count(id); }
};

// Ids of the specialization constants that any instruction looks at.
std::vector<uint32_t> usedConstants(std::span<const uint32_t> words) {
  std::map<uint32_t, uint32_t> numbers;  // by the constant's id
  std::set<uint32_t> used;
  forInstructions(words, [&](uint32_t op, std::span<const uint32_t> i) {
    if (op == kOpDecorate && i[2] == kDecorationSpecId) numbers[i[1]] = i[3];
    if (op == kOpDecorate || op == kOpName) return;
    // Where it is made its id stands second. A literal that happens to equal an id costs a variant of the pass, no more.
    for (size_t word = 1; word < i.size(); ++word)
      if (auto found = numbers.find(i[word]); found != numbers.end() && !(op >= 48 && op <= 50 && word == 2)) used.insert(found->second);
  });
  return {used.begin(), used.end()};
}

}  // namespace

uint32_t ShaderFacts::count(ResourceKind kind) const {
  return uint32_t(std::ranges::count_if(resources, [&](const ShaderResource& resource) { return resource.kind == kind; }));
}

ShaderFacts readFacts(std::span<const uint32_t> words) {
  ShaderFacts facts;
  TypeSizes types;
  const ResourceVariables variables(words);
  std::unordered_map<uint32_t, std::string> names;
  std::unordered_map<uint32_t, uint32_t> pointees, typeOps;
  forInstructions(words, [&](uint32_t op, std::span<const uint32_t> i) {
    if (op == kOpEntryPoint) facts.stage = stageOf(i[1]);
    if (op == kOpName) names[i[1]] = literalText(i.subspan(2));
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
    if (op == kOpTypeImage || op == kOpTypeSampledImage) typeOps[i[1]] = op;
    if (op == kOpTypePointer) pointees[i[1]] = i[3];
    if (op == kOpTypePointer && i[2] == kStoragePushConstant)
      facts.pushConstantBytes = std::max(facts.pushConstantBytes, types.bytes[i[3]]);
    if (op == kOpVariable && variables.touched.count(i[2])) {
      const uint32_t type = pointees[i[1]];
      const bool isBuffer = i[3] == kStorageStorageBuffer;
      CHECK(isBuffer || (i[3] == kStorageUniformConstant && typeOps.count(type)));
      const ResourceKind kind = isBuffer                               ? ResourceKind::storageBuffer
                                : typeOps[type] == kOpTypeSampledImage ? ResourceKind::sampledImage
                                                                       : ResourceKind::storageImage;
      facts.resources.push_back({variables.bindings.at(i[2]), kind, names[isBuffer ? type : i[2]]});
    }
  });
  std::ranges::sort(facts.resources, {}, &ShaderResource::binding);
  facts.constants = usedConstants(words);
  return facts;
}

std::vector<uint32_t> withoutUnused(std::span<const uint32_t> words) {
  const ResourceVariables variables(words);
  std::vector<uint32_t> kept(words.begin(), words.begin() + kHeaderWords);
  forInstructions(words, [&](uint32_t op, std::span<const uint32_t> i) {
    if ((op == kOpName || op == kOpDecorate) && variables.unused(i[1])) return;
    if (op == kOpVariable && variables.unused(i[2])) return;
    if (op != kOpEntryPoint) {
      kept.insert(kept.end(), i.begin(), i.end());
      return;
    }
    // Execution model, function and name stay; behind them stand the variables.
    size_t nameWords = 0;
    literalText(i.subspan(3), &nameWords);
    const size_t first = kept.size();
    kept.insert(kept.end(), i.begin(), i.begin() + std::ptrdiff_t(3 + nameWords));
    for (uint32_t id : i.subspan(3 + nameWords))
      if (!variables.unused(id)) kept.push_back(id);
    kept[first] = uint32_t(kept.size() - first) << 16 | kOpEntryPoint;
  });
  return kept;
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

}  // namespace gridscope
