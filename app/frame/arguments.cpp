// See arguments.h.
#include "app/frame/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <CLI/CLI.hpp>

#include "app/base/text.h"
#include "app/session/capture_files.h"
#include "core/base/error.h"

namespace gridscope {

namespace {

// The shortest text that reads back as the same number.
std::string numberText(float number) {
  char digits[32];
  return std::string(digits, std::to_chars(digits, digits + sizeof(digits), number).ptr);
}

// Collects options.
class Arguments {
 public:
  explicit Arguments(std::vector<std::string> first) : words_(std::move(first)) {}

  void say(const char* name, std::string value) { words_.push_back(name), words_.push_back(std::move(value)); }
  void say(const char* name, float value) { say(name, numberText(value)); }
  void say(const char* name, uint32_t value) { say(name, std::to_string(value)); }
  template <typename Value>
  void differing(const char* name, const Value& value, const Value& usual) {
    if (value != usual) say(name, value);
  }
  template <typename Value>
  void choice(const char* name, const Value& value, const Value& usual, const char* word) {
    if (value != usual) say(name, std::string(word));
  }
  std::vector<std::string> take() { return std::move(words_); }

 private:
  std::vector<std::string> words_;
};

std::string numbers(std::initializer_list<float> list) {
  std::vector<std::string> words;
  for (const float number : list) words.push_back(numberText(number));
  return joined(words, ",");
}

// What a built-in scene may bring is said in any case.
void sayGrid(Arguments& arguments, const GridSettings& grid) {
  const GridSettings usual;
  if (grid.cellEdge > 0.0f)
    arguments.say("--cell-edge", grid.cellEdge);
  else
    arguments.say("--cells", grid.cells);
  arguments.say("--capacity", grid.capacity);
  if (grid.bounds) {
    const auto& [low, high] = *grid.bounds;
    arguments.say("--bounds", numbers({low.x, low.y, low.z, high.x, high.y, high.z}));
  }
  static constexpr const char* kAxes[] = {"x", "y", "z", "auto"};
  arguments.choice("--stretch", grid.stretch, usual.stretch, kAxes[size_t(grid.stretch)]);
  arguments.choice("--builder", grid.builder, usual.builder, builderWord(grid.builder));
  arguments.choice("--insertion", grid.insertion, usual.insertion, insertionWord(grid.insertion));
  arguments.choice("--number-by", grid.numberBy, usual.numberBy, numberingWord(grid.numberBy));
  arguments.choice("--overlap", grid.overlap, usual.overlap, overlapWord(grid.overlap));
  arguments.differing("--enlargement", grid.enlargement, usual.enlargement);
  arguments.choice("--update", grid.update, usual.update, updateWord(grid.update));
}

void sayTrace(Arguments& arguments, const TraceSettings& trace) {
  const TraceSettings usual;
  arguments.choice("--traversal", trace.traversal, usual.traversal, traversalWord(trace.traversal));
  arguments.differing("--back", trace.back, usual.back);
  arguments.say("--ahead", trace.ahead);
  arguments.differing("--tmin", trace.tMin, usual.tMin);
  arguments.choice("--gap-fill", trace.gapFill, usual.gapFill, trace.gapFill ? "on" : "off");
  arguments.differing("--gate", trace.gate, usual.gate);
  arguments.differing("--max-segments", trace.maxSegments, usual.maxSegments);
}

}  // namespace

std::vector<std::string> frameArguments(const FrameRequest& request) {
  if (isCapturePath(request.source.scene) || !request.settings) return {request.source.scene};
  const FrameSettings &settings = *request.settings, usual;
  const CameraPose& camera = settings.camera;
  Arguments arguments({request.source.scene});
  arguments.differing("--teapots", request.source.teapots, 0u);
  if (request.source.moving) arguments.say("--moving", *request.source.moving);
  arguments.say("--camera", numbers({camera.eye.x, camera.eye.y, camera.eye.z, camera.target.x, camera.target.y, camera.target.z,
                                     camera.verticalFovDegrees}));
  if (request.timeSeconds != 0.0) arguments.say("--time", printed("%.17g", request.timeSeconds));
  if (request.source.rays.empty())
    arguments.say("--size", printed("%ux%u", settings.width, settings.height));
  else
    arguments.say("--rays", request.source.rays);
  arguments.differing("--texture-size", settings.textureSize, usual.textureSize);
  sayGrid(arguments, settings.grid);
  sayTrace(arguments, settings.trace);
  arguments.differing("--seed", settings.bounce.seed, usual.bounce.seed);
  arguments.differing("--roughness", settings.bounce.roughness, usual.bounce.roughness);
  return arguments.take();
}

std::vector<std::string> reportArguments(const FrameRequest& request, double timeStep) {
  FrameRequest first = request;
  first.timeSeconds -= double(request.frame) * timeStep;
  if (std::abs(first.timeSeconds) < 1e-9) first.timeSeconds = 0.0;
  std::vector<std::string> arguments = frameArguments(first);
  if (request.frame == 0) return arguments;
  arguments.insert(arguments.end(), {"--frame", std::to_string(request.frame)});
  if (!isCapturePath(request.source.scene)) arguments.insert(arguments.end(), {"--frame-step", printed("%.17g", timeStep)});
  return arguments;
}

Options optionsFrom(const std::vector<std::string>& arguments) {
  Options options;
  CLI::App app;
  addFrameOptions(app, options);
  addFrameNumberOption(app, options);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    throw Error(error.what());
  }
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0) options.given.push_back(option->get_name());
  options.arguments = arguments;
  return options;
}

}  // namespace gridscope
