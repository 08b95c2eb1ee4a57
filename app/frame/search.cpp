// See search.h.
#include "app/frame/search.h"

#include <cctype>
#include <charconv>
#include <vector>

#include "app/frame/table_rows.h"

namespace gridscope {

namespace {

std::string lowered(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

// "thorn 3,106" as its words; commas part numbers too.
std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char letter : text) {
    const bool gap = std::isspace(static_cast<unsigned char>(letter)) || letter == ',' || letter == '(' || letter == ')';
    if (!gap)
      words.back() += letter;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::optional<uint32_t> numberOf(const std::string& word, int base = 10) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number, base);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return number;
}

std::optional<SearchTarget> placeNamed(const FrameSnapshot& frame, const std::vector<uint32_t>& numbers) {
  if (numbers.size() == 3) {
    const ivec3 cell{int(numbers[0]), int(numbers[1]), int(numbers[2])};
    return gridContains(frame.gridShape(), cell) ? std::optional(SearchTarget{.cell = cell}) : std::nullopt;
  }
  const FrameSettings& settings = *frame.request.settings;
  if (numbers[0] >= settings.width || numbers[1] >= settings.height) return std::nullopt;
  return SearchTarget{.pixel = numbers[1] * settings.width + numbers[0]};
}

std::optional<SearchTarget> triangleNamed(const FrameSnapshot& frame, const std::string& mesh, uint32_t triangle) {
  const std::vector<InstanceSource>& sources = frame.scene->numbered.sources;
  for (uint32_t instance = 0; instance < sources.size() && instance < frame.instances->size(); ++instance) {
    const uint32_t index = sources[instance].mesh;
    if (index >= frame.scene->names.meshes.size() || lowered(frame.scene->names.meshes[index]) != mesh) continue;
    for (uint32_t piece = 0; piece < (*frame.instances)[instance].triangleCount; ++piece)
      if (nameTriangle(frame.scene->numbered, makeReference(instance, piece)).triangle == triangle)
        return SearchTarget{.reference = makeReference(instance, piece)};
  }
  return std::nullopt;
}

bool holds(const std::vector<std::string>& names, size_t index, const std::string& text) {
  return index < names.size() && lowered(names[index]).find(text) != std::string::npos;
}

std::optional<SearchTarget> instanceNamed(const FrameSnapshot& frame, const std::string& text) {
  const SceneFacts& scene = *frame.scene;
  for (uint32_t instance = 0; instance < scene.names.instances.size(); ++instance)
    if (holds(scene.names.instances, instance, text) || holds(scene.meshOfInstance, instance, text))
      return SearchTarget{.instance = instance};
  return std::nullopt;
}

std::string joinedFrom(const std::vector<std::string>& words, size_t first, size_t end) {
  std::string text;
  for (size_t at = first; at < end; ++at) text += (text.empty() ? "" : " ") + words[at];
  return text;
}

}  // namespace

std::optional<SearchTarget> findTarget(const FrameSnapshot& frame, const std::string& text) {
  std::vector<std::string> words = wordsOf(lowered(text));
  if (words.empty() || !frame.scene || !frame.request.settings) return std::nullopt;
  const bool noun = words.size() > 1 && (words[0] == "pixel" || words[0] == "cell" || words[0] == "triangle" || words[0] == "instance" ||
                                         words[0] == "mesh" || words[0] == "reference");
  const size_t first = noun ? 1 : 0;

  std::vector<uint32_t> numbers;
  for (size_t at = first; at < words.size(); ++at)
    if (const auto number = numberOf(words[at])) numbers.push_back(*number);
  const bool numbersAlone = numbers.size() == words.size() - first;
  if (numbersAlone && (numbers.size() == 2 || numbers.size() == 3)) return placeNamed(frame, numbers);

  if (words.back().starts_with("0x"))
    if (const auto reference = numberOf(words.back().substr(2), 16))
      return worldTriangle(frame, *reference) ? std::optional(SearchTarget{.reference = *reference}) : std::nullopt;

  if (frame.instances && words.size() - first >= 2)
    if (const auto triangle = numberOf(words.back()))
      if (const auto target = triangleNamed(frame, joinedFrom(words, first, words.size() - 1), *triangle)) return target;

  return instanceNamed(frame, joinedFrom(words, first, words.size()));
}

}  // namespace gridscope
