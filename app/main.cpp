// The program: one command, its options, its exit code.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "app/ui/shell/window.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "core/scene/built_in_scenes.h"

namespace gridscope {

namespace {

// Without arguments, and without a display: the main job on the built-in scene.
const std::vector<std::string> kMainJob = {"render", "--view", "all"};

// A scene or a capture as the first argument: the window is meant.
bool namesScene(const std::string& argument) {
  const auto ends = [&](const char* ending) { return argument.size() > std::strlen(ending) && argument.ends_with(ending); };
  if (ends(".glb") || ends(".gltf") || ends(".gridcap") || ends(".GLB") || ends(".GLTF")) return true;
  return std::ranges::any_of(builtInScenes(), [&](const BuiltInScene& scene) { return scene.name == argument; });
}

// What the arguments mean where no command is named.
std::vector<std::string> withCommand(std::vector<std::string> arguments) {
  if (arguments.empty()) {
    const std::string why = whyNoWindow();
    if (why.empty()) return {"window"};
    std::fprintf(stderr, "gridscope: %s: every view of the hall is rendered to out/ instead of opening the window\n", why.c_str());
    return kMainJob;
  }
  if (namesScene(arguments.front())) arguments.insert(arguments.begin(), "window");
  return arguments;
}

// A first argument that is neither an option nor a command; empty: there is none.
std::string unknownCommand(const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with("-")) return "";
  std::string known;
  for (const Command& command : kCommands) {
    if (arguments.front() == command.name) return "";
    known += (known.empty() ? "" : ", ") + std::string(command.name);
  }
  return arguments.front() + ": no such command; there are " + known;
}

// One line: what is wrong, with the option's name, and where to look.
std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  std::string what = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) what = what.substr(what.find(": ") + 2) + ": not known here";
  const std::vector<CLI::App*> given = app.get_subcommands();
  return what + "; see gridscope " + (given.empty() ? "" : given.front()->get_name() + " ") + "--help";
}

// Reads the command line; returns the command to run, or nullptr with the exit code when help or the version was all.
const Command* readCommandLine(CLI::App& app, Options& options, std::vector<std::string> arguments, int& exitCode) {
  app.set_version_flag("--version", std::string("gridscope ") + kVersion);
  app.require_subcommand(1);
  app.get_formatter()->column_width(36);
  for (const Command& command : kCommands) command.addOptions(*app.add_subcommand(command.name, command.about), options);
  app.footer(
      "Exit codes: 0 done or equal, 1 different or a check failed, 2 bad input or arguments,\n3 the device can't do it or was lost.");

  arguments = withCommand(std::move(arguments));
  if (const std::string fault = unknownCommand(arguments); !fault.empty()) throw Error(fault);
  options.arguments = arguments;
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  try {
    app.parse(arguments);
  } catch (const CLI::Success& help) {
    exitCode = app.exit(help);
    return nullptr;
  } catch (const CLI::ParseError& error) {
    throw Error(explain(app, error));
  }
  checkOptions(options);
  for (const CLI::Option* option : app.get_subcommands().front()->get_options())
    if (option->count() > 0) options.given.push_back(option->get_name());
  for (const Command& command : kCommands)
    if (app.got_subcommand(command.name)) return &command;
  throw Error("no command; see gridscope --help");
}

int run(const std::vector<std::string>& arguments) {
  CLI::App app(
      "Shows what a fixed-capacity triangle grid does to every ray.\nWithout arguments: the window on the built-in hall (without a "
      "display: its views, in out/).\nWith a scene or a capture alone: the window on it.",
      "gridscope");
  Options options;
  int exitCode = kExitDone;
  const Command* command = readCommandLine(app, options, arguments, exitCode);
  return command ? command->run(options) : exitCode;
}

int fail(const char* message, int exitCode) {
  std::fprintf(stderr, "gridscope: %s\n", message);
  return exitCode;
}

}  // namespace

}  // namespace gridscope

int main(int argc, char** argv) {
  using namespace gridscope;
  try {
    return run({argv + 1, argv + argc});
  } catch (const Error& error) {
    return fail(error.what(), error.exitCode());
  } catch (const std::bad_alloc&) {
    return fail("out of memory; take a smaller scene, grid or frame", kExitBadInput);
  } catch (const std::exception& error) {
    return fail(error.what(), kExitBadInput);
  }
}
