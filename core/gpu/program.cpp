// See program.h.
#include "core/gpu/program.h"

#include <algorithm>
#include <set>

#include "core/gpu/shader_code.h"

namespace gridscope {
namespace {

std::vector<uint32_t> constantsOf(const PassDescription& description) {
  std::set<uint32_t> ids;
  for (const std::string& shader : description.shaders) {
    const ShaderFacts facts = readFacts(shaderCode(shader));
    ids.insert(facts.constants.begin(), facts.constants.end());
  }
  return {ids.begin(), ids.end()};
}

}  // namespace

void GpuPrograms::specialize(const ShaderConstants& constants) {
  for (const auto& [id, value] : constants) constants_[id] = value;
}

GpuPrograms::Variant& GpuPrograms::variant(const PassDescription& description) {
  auto found = variants_.find(description.stem);
  if (found == variants_.end()) found = variants_.emplace(description.stem, Variants{constantsOf(description), {}}).first;
  Variants& variants = found->second;
  ShaderConstants values;
  for (uint32_t id : variants.constants)
    if (auto given = constants_.find(id); given != constants_.end()) values.insert(*given);
  return variants.byValue.try_emplace(values, gpu_, description, values).first->second;
}

bool GpuPrograms::warm(GpuCommands& commands, const std::string& stem) {
  Variant& found = variant(computePass(stem));
  if (found.warm) return false;
  found.warm = true;
  const std::vector<std::byte> zeros(found.pass.pushConstantBytes());
  GpuLabel label(gpu_, commands.handle(), stem);
  found.pass.begin(commands.handle(), bound_, zeros);
  vkCmdDispatch(commands.handle(), 1, 1, 1);
  commands.barrier();
  return true;
}

void GpuPrograms::dispatch(GpuCommands& commands, const std::string& stem, ivec3 invocations, std::span<const std::byte> arguments) {
  GpuPass& pass = variant(computePass(stem)).pass;
  if (invocations.x <= 0 || invocations.y <= 0 || invocations.z <= 0) return;
  GpuLabel label(gpu_, commands.handle(), stem);
  pass.begin(commands.handle(), bound_, arguments);
  auto groups = [&](int axis) { return (uint32_t(invocations[axis]) + pass.localSize()[axis] - 1) / pass.localSize()[axis]; };
  vkCmdDispatch(commands.handle(), groups(0), groups(1), groups(2));
}

void GpuPrograms::dispatchIndirect(GpuCommands& commands, const std::string& stem, int countsBinding, uint64_t offset,
                                   std::span<const std::byte> arguments) {
  GpuLabel label(gpu_, commands.handle(), stem);
  variant(computePass(stem)).pass.begin(commands.handle(), bound_, arguments);
  vkCmdDispatchIndirect(commands.handle(), bound_.buffer(countsBinding).handle(), offset);
}

void GpuPrograms::zero(GpuCommands& commands, int binding) {
  vkCmdFillBuffer(commands.handle(), bound_.buffer(binding).handle(), 0, VK_WHOLE_SIZE, 0);
}

void GpuPrograms::draw(GpuCommands& commands, const PassDescription& description, VkExtent2D extent, const std::function<void()>& draws) {
  GpuLabel label(gpu_, commands.handle(), description.stem);
  variant(description).pass.begin(commands.handle(), bound_, {});
  if (description.draws && description.draws->colour != VK_FORMAT_UNDEFINED) {
    VkViewport viewport{0.0f, 0.0f, float(extent.width), float(extent.height), 0.0f, 1.0f};
    VkRect2D scissor{{0, 0}, extent};
    vkCmdSetViewport(commands.handle(), 0, 1, &viewport);
    vkCmdSetScissor(commands.handle(), 0, 1, &scissor);
  }
  draws();
}

}  // namespace gridscope
