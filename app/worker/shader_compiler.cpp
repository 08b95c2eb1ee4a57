// See shader_compiler.h. The same compiler, target and definitions as the build's (CMakeLists.txt, add_shader).
#include "app/worker/shader_compiler.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/gpu/shader_code.h"
#include "core/gpu/shader_facts.h"

namespace gridscope {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> readText(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Looks beside the file that includes, then in shaders/ and in the source folder.
class Includer : public glslang::TShader::Includer {
 public:
  explicit Includer(fs::path folder) : folder_(std::move(folder)) {}

  IncludeResult* includeLocal(const char* name, const char* includer, size_t) override {
    return find({fs::path(includer).parent_path() / name, folder_ / "shaders" / name, folder_ / name});
  }
  IncludeResult* includeSystem(const char* name, const char*, size_t) override {
    return find({folder_ / "shaders" / name, folder_ / name});
  }
  void releaseInclude(IncludeResult* result) override {
    if (!result) return;
    delete static_cast<std::string*>(result->userData);
    delete result;
  }

 private:
  IncludeResult* find(std::initializer_list<fs::path> places) {
    for (const fs::path& place : places)
      if (std::optional<std::string> text = readText(place)) {
        auto* kept = new std::string(std::move(*text));
        return new IncludeResult(place.string(), kept->data(), kept->size(), kept);
      }
    return nullptr;
  }

  fs::path folder_;
};

EShLanguage stageOf(const fs::path& source) {
  const std::string ending = source.extension().string();
  if (ending == ".vert") return EShLangVertex;
  if (ending == ".frag") return EShLangFragment;
  if (ending == ".geom") return EShLangGeometry;
  return EShLangCompute;
}

// "-DCOUNTING -DOPERATION=1" as lines of a preamble.
std::string preambleOf(std::string_view definitions) {
  std::istringstream words{std::string(definitions)};
  std::string word, preamble = "#extension GL_GOOGLE_include_directive : enable\n";
  while (words >> word) {
    word = word.substr(2);
    std::ranges::replace(word, '=', ' ');
    preamble += "#define " + word + "\n";
  }
  return preamble;
}

// Empty words: `fault` says why.
std::vector<uint32_t> compileOne(const ShaderCode& shader, const fs::path& folder, std::string& fault) {
  const fs::path source = fs::path(shader.source).is_absolute() ? fs::path(shader.source) : folder / shader.source;
  const std::optional<std::string> text = readText(source);
  if (!text) {
    fault = source.string() + ": can't be read";
    return {};
  }
  const EShLanguage stage = stageOf(source);
  const std::string name = source.string(), preamble = preambleOf(shader.definitions);
  const char *strings = text->c_str(), *names = name.c_str();
  glslang::TShader unit(stage);
  unit.setStringsWithLengthsAndNames(&strings, nullptr, &names, 1);
  unit.setPreamble(preamble.c_str());
  unit.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
  unit.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
  unit.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
  Includer includer(folder);
  const auto messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
  if (!unit.parse(GetDefaultResources(), 460, false, messages, includer)) {
    fault = std::string(shader.stem) + ": " + unit.getInfoLog();
    return {};
  }
  glslang::TProgram program;
  program.addShader(&unit);
  if (!program.link(messages)) {
    fault = std::string(shader.stem) + ": " + program.getInfoLog();
    return {};
  }
  std::vector<uint32_t> words;
  glslang::GlslangToSpv(*program.getIntermediate(stage), words);

  // The program pushes what it was built to push.
  if (readFacts(words).pushConstantBytes != readFacts(shader.words).pushConstantBytes) {
    fault = std::string(shader.stem) + ": its push constants changed; that needs a new build";
    return {};
  }
  return words;
}

}  // namespace

CompiledShaders compileShaders(const std::string& folder, const std::function<bool(float)>& goesOn) {
  const fs::path root = folder.empty() ? fs::path(GRIDSCOPE_SOURCE) : fs::path(folder);
  CompiledShaders compiled;
  if (!fs::exists(root / "shaders")) {
    compiled.fault = root.string() + ": the source folder is not there any more";
    return compiled;
  }
  glslang::InitializeProcess();
  size_t done = 0;
  for (const ShaderCode& shader : allShaders()) {
    const bool goes = !goesOn || goesOn(float(done++) / float(allShaders().size()));
    std::vector<uint32_t> words;
    if (goes)
      words = compileOne(shader, root, compiled.fault);
    else
      compiled.fault = "cancelled: the passes are as they were";
    if (words.empty()) {
      compiled.words.clear();
      break;
    }
    compiled.words[std::string(shader.stem)] = std::move(words);
  }
  glslang::FinalizeProcess();
  return compiled;
}

}  // namespace gridscope
