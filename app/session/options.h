// What a person can say on the command line: one structure for all commands, the functions that offer its options, and what becomes
// of them. Values are checked as they are read; what depends on scene or device is checked where that is known.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/session/budget.h"
#include "core/capture/capture.h"
#include "core/checks/replay.h"
#include "core/pipeline/pipeline.h"
#include "core/scene/built_in_scenes.h"
#include "core/trace/settings.h"
#include "core/tune/tune.h"
#include "views/picture.h"
#include "views/view.h"

namespace CLI {
class App;
}

namespace gridscope {

struct FrameSize {
  uint32_t width;
  uint32_t height;
};

// What capture, replay and their kin are told.
struct CaptureOptions {
  std::vector<std::filesystem::path> files;  // captures and folders of them
  std::filesystem::path output;              // of `capture`
  std::string note;
  CaptureProducts products{};
  uint32_t sequence = 1;  // frames in the file
  ReplayFrom from = ReplayFrom::automatic;
  std::filesystem::path junit;        // file; empty: none
  std::filesystem::path differences;  // folder of difference pictures; empty: none
  uint32_t repeat = 1;
  uint32_t jobs = 1;   // processes
  uint32_t shard = 1;  // of `shards`: every shards-th file
  uint32_t shards = 1;
  bool salvage = false;
  uint32_t pixelX = 0;  // of `ray`
  uint32_t pixelY = 0;
  uint32_t randomPixels = 0;  // of `ray`: compares as many recorded rays with the frame instead of telling one
};

// What a sweep is told.
struct TuneOptions {
  TuneAxes axes;
  uint32_t runs = 3;           // timed ones of build and trace
  std::filesystem::path csv;   // file; empty: none
  std::filesystem::path plot;  // .svg or .png; empty: none
};

struct Options {
  // Scene.
  std::string scene = "hall";      // path of a .gltf or .glb, or a built-in scene's name
  uint32_t teapots = 0;            // added to the scene
  std::optional<uint32_t> moving;  // of the added teapots; all when not given
  std::string camera;              // name or numbers; empty: the scene's first
  double time = 0.0;               // seconds, of the first frame
  uint32_t frames = 1;
  uint32_t frame = 0;             // which one, where a command looks at one: of a capture's sequence, or so many steps after `time`
  double frameStep = 1.0 / 60.0;  // seconds

  // Settings; those that a built-in scene may bring are apart, because what is given here goes first.
  FrameSettings settings;
  std::optional<FrameSize> size;
  std::optional<FrameSize> sizeByDefault;  // a command's own, in place of the settings'
  std::optional<uint32_t> cells;
  std::optional<float> cellEdge;
  std::optional<uint32_t> capacity;
  std::optional<float> ahead;
  std::filesystem::path rays;  // .npy; empty: the bounce makes them

  // Device.
  std::string device;  // name, index or "cpu"; empty: the first that can be used
  bool validation = false;

  // Pictures and results.
  std::vector<const View*> views;  // in the order of the list of all views
  std::filesystem::path out = "out";
  SliceSettings slice;
  std::optional<ValueRange> range;
  bool legend = true;
  bool checkCpu = false;
  uint32_t checkExact = 0;      // rays to compare with the nearest hit among all triangles; 0: none
  std::vector<Budget> budgets;  // of --fail-if
  uint32_t stability = 0;       // first-come builds to compare; 0: none
  std::string json;             // file; "-": standard output; empty: none
  uint32_t runs = 20;           // of each stage (bench)

  CaptureOptions captures;
  TuneOptions tune;
  std::filesystem::path page;          // of `report`
  bool verify = false;                 // prove causes (explain)
  uint32_t worst = 10;                 // rays that explain lists
  std::vector<std::string> arguments;  // the command line as it came, the command first
  std::vector<std::string> given;      // names of the options on the command line

  bool onCpu() const { return device == "cpu"; }
};

// Offers SCENE and everything that a frame depends on.
void addFrameOptions(CLI::App& command, Options& options);

// Offers what is made of a frame: views and pictures, number of frames, the check.
void addPictureOptions(CLI::App& command, Options& options);

// Offers --json.
void addJsonOption(CLI::App& command, Options& options);

// Offers --validation.
void addValidationOption(CLI::App& command, Options& options);

// Offers --runs.
void addRunsOption(CLI::App& command, Options& options);

// Offers --device.
void addDeviceOption(CLI::App& command, Options& options);

// Offers FILE or DIR, one or more (`count` of them when it is not 0), and --salvage.
void addFilesOption(CLI::App& command, Options& options, const std::string& what, size_t count = 0);

// Offers -o, --note, --products and --sequence.
void addCaptureFileOptions(CLI::App& command, Options& options);

// Offers --out, for pictures of differences.
void addDifferenceFolderOption(CLI::App& command, Options& options);

// Offers --from, --repeat, --jobs, --shard, --junit and --out.
void addReplayChoices(CLI::App& command, Options& options);

// Offers --frames, --stability and --salvage (check).
void addCheckChoices(CLI::App& command, Options& options);

// Offers --frame: which of several a command looks at.
void addFrameNumberOption(CLI::App& command, Options& options);

// Offers --pixel.
void addPixelOption(CLI::App& command, Options& options);

// Offers the axes of a sweep, --runs, --csv and --plot.
void addTuneChoices(CLI::App& command, Options& options);

// Offers -o, the page that is written.
void addPageOption(CLI::App& command, Options& options);

// Offers --random.
void addRandomPixelsOption(CLI::App& command, Options& options);

// Offers --verify and --worst.
void addTruthOptions(CLI::App& command, Options& options);

// Where a command's text goes: standard output, unless JSON goes there.
std::FILE* textStream(const Options& options);

// Options that do not go together; throws Error.
void checkOptions(const Options& options);

// The settings of a frame without its camera: defaults, then the built-in scene's (nullptr: none), then the options.
FrameSettings settingsOf(const Options& options, const BuiltInScene* builtIn);

}  // namespace gridscope
