// See shader_code.h.
#include "core/gpu/shader_code.h"

#include <list>
#include <mutex>

#include "core/base/error.h"

namespace gridscope {

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

}  // namespace gridscope
