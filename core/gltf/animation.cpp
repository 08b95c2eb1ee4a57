// The animations of a checked glTF model, see animation.h.
#include "core/gltf/animation.h"

#include <cmath>
#include <optional>

#include <tiny_gltf.h>

#include "core/base/error.h"
#include "core/base/gltf_files.h"
#include "core/gltf/accessor.h"

namespace gridscope {

namespace {

// Many channels can name the same keys, so the file's size is no limit.
constexpr uint64_t kKeyLimit = 4'000'000;

std::optional<ChannelPath> channelPath(const std::string& path) {
  if (path == "translation") return ChannelPath::translation;
  if (path == "rotation") return ChannelPath::rotation;
  if (path == "scale") return ChannelPath::scale;
  return std::nullopt;
}

Interpolation interpolationOf(const std::string& name) {
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubicSpline;
  if (name == "LINEAR" || name.empty()) return Interpolation::linear;
  throw Error("interpolation '" + plainName(name) + "' is unknown; export the file again");
}

std::vector<float> readTimes(const AccessorView& view) {
  if (view.componentCount() != 1 || !view.isFloat()) throw Error("its key times are not floats; export the file again");
  std::vector<float> times;
  times.reserve(view.count());
  for (size_t i = 0; i < view.count(); ++i) {
    const float time = view.at(i).x;
    if (!std::isfinite(time) || time < 0.0f || (!times.empty() && time < times.back()))
      throw Error("its key times do not rise from 0; export the file again");
    times.push_back(time);
  }
  return times;
}

vec4 unitRotation(const vec4& rotation) {
  const float length = glm::length(rotation);
  return length > 1e-12f ? rotation / length : vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

void readValues(Channel& channel, const AccessorView& view) {
  const bool cubic = channel.interpolation == Interpolation::cubicSpline;
  const bool isRotation = channel.path == ChannelPath::rotation;
  const size_t wanted = channel.times.size() * (cubic ? 3 : 1);
  if (view.componentCount() != (isRotation ? 4 : 3)) throw Error("its values have the wrong number of components; export the file again");
  if (view.count() != wanted)
    throw Error("it has " + std::to_string(view.count()) + " values instead of " + std::to_string(wanted) + "; export the file again");
  channel.values.reserve(wanted);
  for (size_t i = 0; i < wanted; ++i) {
    const vec4 value = view.at(i);
    for (int c = 0; c < 4; ++c) {
      if (!std::isfinite(value[c])) throw Error("value " + std::to_string(i) + " is not finite; export the file again");
    }
    channel.values.push_back(isRotation && !cubic ? unitRotation(value) : value);
  }
}

// Empty when the channel moves nothing that the scene has.
std::optional<Channel> loadChannel(const tinygltf::Model& model, const tinygltf::Animation& animation,
                                   const tinygltf::AnimationChannel& source, std::span<const int32_t> sceneNodes, GltfWarnings& warnings) {
  if (static_cast<size_t>(source.sampler) >= animation.samplers.size()) throw Error("its sampler is out of range; export the file again");
  const auto path = channelPath(source.target_path);
  if (!path) warnings.add("animated properties other than translation, rotation and scale are left out", plainName(source.target_path));
  if (!path || source.target_node < 0 || sceneNodes[static_cast<size_t>(source.target_node)] < 0) return std::nullopt;
  if (!model.nodes[static_cast<size_t>(source.target_node)].matrix.empty()) {
    warnings.add("animations of nodes with a matrix are left out", "node " + std::to_string(source.target_node));
    return std::nullopt;
  }
  const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<size_t>(source.sampler)];
  Channel channel;
  channel.node = static_cast<uint32_t>(sceneNodes[static_cast<size_t>(source.target_node)]);
  channel.path = *path;
  channel.interpolation = interpolationOf(sampler.interpolation);
  channel.times = readTimes(AccessorView(model, sampler.input));
  readValues(channel, AccessorView(model, sampler.output));
  return channel;
}

}  // namespace

void loadAnimations(const tinygltf::Model& model, std::span<const int32_t> sceneNodes, Scene& scene, GltfWarnings& warnings) {
  uint64_t keyCount = 0;
  for (size_t i = 0; i < model.animations.size(); ++i) {
    const tinygltf::Animation& source = model.animations[i];
    Animation animation;
    animation.name = source.name.empty() ? "animation " + std::to_string(i) : plainName(source.name);
    try {
      for (const tinygltf::AnimationChannel& channelSource : source.channels) {
        // Counted before the keys are read.
        if (static_cast<size_t>(channelSource.sampler) < source.samplers.size())
          keyCount += model.accessors[static_cast<size_t>(source.samplers[static_cast<size_t>(channelSource.sampler)].input)].count;
        if (keyCount > kKeyLimit) throw Error("the animations have more than 4 million keys; remove some");
        auto channel = loadChannel(model, source, channelSource, sceneNodes, warnings);
        if (!channel) continue;
        animation.duration = std::max(animation.duration, channel->times.back());
        animation.channels.push_back(std::move(*channel));
      }
    } catch (const Error& error) {
      throw error.within("animation '" + animation.name + "'");
    }
    if (!animation.channels.empty()) scene.animations.push_back(std::move(animation));
  }
}

}  // namespace gridscope
