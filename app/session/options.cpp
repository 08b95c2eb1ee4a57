// See options.h. Defaults are those of the structures; nothing is typed twice.
#include "app/session/options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>

#include "app/base/text.h"
#include "app/session/option_values.h"
#include "core/base/error.h"

namespace gridscope {

namespace {

constexpr uint32_t kMostPixelsPerSide = 16384;
constexpr uint32_t kMostTexelsPerSide = 8192;  // of a diffuse map
constexpr uint32_t kMostTeapots = 1024;
constexpr uint32_t kMostFrames = 1000000;
constexpr double kMostSeconds = 1e6;

template <class Value>
struct Choice {
  const char* name;
  Value value;
};

std::string shownDefault(double value) { return printed("%g", value); }

// Offers options of one group of the help. Every value comes in as text, so that each message is one line of ours.
class OptionGroup {
 public:
  OptionGroup(CLI::App& command, std::string group) : command_(command), group_(std::move(group)) {}

  // An option whose text `take` understands. `shown`: the default, for the help.
  void text(const std::string& name, const char* type, const std::string& shown, const std::string& about,
            std::function<void(const std::string&)> take) {
    auto takeGiven = [name, type = std::string(type), take](const std::string& given) {
      if (given.empty()) throw Error(name + ": nothing given; give " + type);
      take(given);
    };
    CLI::Option* option = command_.add_option_function<std::string>(name, takeGiven, about);
    option->type_name(type)->group(group_)->default_str(shown);
  }

  template <class Target>
  void whole(const std::string& name, Target& target, WholeRange range, const std::string& shown, const std::string& about) {
    text(name, "N", shown, about, [&target, name, range](const std::string& given) { target = parseWhole(name, given, range); });
  }

  template <class Target>
  void number(const std::string& name, const char* type, Target& target, NumberRange range, const std::string& shown,
              const std::string& about) {
    text(name, type, shown, about, [&target, name, range](const std::string& given) {
      target = static_cast<decltype(valueOf(target))>(parseNumber(name, given, range));
    });
  }

  template <class Value>
  void choice(const std::string& name, Value& target, std::vector<Choice<Value>> choices, const std::string& about) {
    std::string names, shown;
    for (const auto& [choiceName, value] : choices) {
      names += (names.empty() ? "" : "|") + std::string(choiceName);
      if (value == target) shown = choiceName;
    }
    text(name, names.c_str(), shown, about, [&target, name, names, choices](const std::string& given) {
      const auto found = std::ranges::find_if(choices, [&](const auto& one) { return given == one.name; });
      if (found == choices.end()) throw Error(name + " " + given + ": give " + names);
      target = found->value;
    });
  }

  // Lists with a comma between the values.
  void wholes(const std::string& name, std::vector<uint32_t>& target, WholeRange range, const std::string& about) {
    std::vector<std::string> shown;
    for (uint32_t value : target) shown.push_back(std::to_string(value));
    list(name, "N", target, shown, about, [name, range](const std::string& one) { return parseWhole(name, one, range); });
  }

  void numbers(const std::string& name, std::vector<float>& target, NumberRange range, const std::string& about) {
    std::vector<std::string> shown;
    for (float value : target) shown.push_back(shownDefault(value));
    list(name, "EDGES", target, shown, about,
         [name, range](const std::string& one) { return static_cast<float>(parseNumber(name, one, range)); });
  }

  template <class Value>
  void choices(const std::string& name, std::vector<Value>& target, std::vector<Choice<Value>> known, const std::string& about) {
    std::vector<std::string> names;
    for (const auto& one : known) names.emplace_back(one.name);
    list(name, joined(names, "|").c_str(), target, names, about, [name, names, known](const std::string& given) {
      const auto found = std::ranges::find_if(known, [&](const auto& one) { return given == one.name; });
      if (found == known.end()) throw Error(name + " " + given + ": give some of " + joined(names, ","));
      return found->value;
    });
  }

  void flag(const std::string& name, bool& target, bool value, const std::string& about) {
    command_
        .add_flag_function(
            name, [&target, value](int64_t) { target = value; }, about)
        ->group(group_);
  }

 private:
  template <class Value, class Parse>
  void list(const std::string& name, const char* type, std::vector<Value>& target, const std::vector<std::string>& shown,
            const std::string& about, Parse parse) {
    text(name, (std::string(type) + "[,...]").c_str(), joined(shown, ","), about, [&target, parse](const std::string& given) {
      target.clear();
      for (const std::string& one : splitText(given, ',')) {
        const Value value = parse(one);
        if (std::ranges::find(target, value) == target.end()) target.push_back(value);
      }
    });
  }

  static float valueOf(float);
  static float valueOf(const std::optional<float>&);
  static double valueOf(double);

  CLI::App& command_;
  std::string group_;
};

FrameSize parseSize(const std::string& text) {
  const std::vector<std::string> sides = splitText(text, 'x');
  if (sides.size() != 2) throw Error("--size " + text + ": give WIDTHxHEIGHT in pixels, 640x360 say");
  const WholeRange range{1, kMostPixelsPerSide};
  return {parseWhole("--size (width)", sides[0], range), parseWhole("--size (height)", sides[1], range)};
}

Bounds parseBounds(const std::string& text) {
  const std::vector<double> n = parseNumbers("--bounds", text, {6}, "minx,miny,minz,maxx,maxy,maxz in world units");
  Bounds bounds{.low = vec3(n[0], n[1], n[2]), .high = vec3(n[3], n[4], n[5])};
  for (int axis = 0; axis < 3; ++axis)
    if (bounds.low[axis] > bounds.high[axis])
      throw Error("--bounds " + text + ": the low end lies above the high end; give minx,miny,minz,maxx,maxy,maxz");
  return bounds;
}

SliceSettings parseSlice(const std::string& text) {
  const size_t axis = text.empty() ? std::string::npos : std::string_view("xyz").find(text.front());
  if (axis == std::string::npos || text.size() < 3 || text[1] != ':')
    throw Error("--slice " + text + ": give an axis and a layer of cells, y:12 say");
  return {.axis = static_cast<int>(axis), .index = static_cast<int>(parseWhole("--slice (layer)", text.substr(2), {0, 1u << 20}))};
}

ValueRange parseRange(const std::string& text) {
  const std::vector<std::string> ends = splitText(text, ':');
  if (ends.size() != 2) throw Error("--range " + text + ": give MIN:MAX in the view's unit, 0:100 say");
  const NumberRange all{-1e30, 1e30};
  const ValueRange range{static_cast<float>(parseNumber("--range (low end)", ends[0], all)),
                         static_cast<float>(parseNumber("--range (high end)", ends[1], all))};
  if (!(range[0] < range[1])) throw Error("--range " + text + ": the low end must lie below the high end");
  return range;
}

// all: what needs nothing beside the frame; truth: what the truth of the frame's rays paints.
bool isMeant(const View& view, const std::string& name) {
  if (name == "all") return view.need == ViewNeed::nothing;
  if (name == "truth") return view.need == ViewNeed::truth || view.need == ViewNeed::triangleCosts;
  return name == view.name;
}

std::vector<const View*> parseViews(const std::string& text) {
  std::vector<const View*> views;
  std::vector<std::string> names;
  for (const View& view : allViews()) names.emplace_back(view.name);
  for (const std::string& name : splitText(text, ',')) {
    const bool isGroup = name == "all" || name == "truth";
    if (!isGroup && !findView(name))
      throw Error("--view " + text + ": there is no view '" + name + "'; give all, truth, or some of " + joined(names, ","));
    for (const View& view : allViews())
      if (isMeant(view, name) && std::ranges::find(views, &view) == views.end()) views.push_back(&view);
  }
  return views;
}

CaptureProducts parseProducts(const std::string& text) {
  CaptureProducts products{.grid = false, .gather = false, .rays = false, .hits = false, .counters = false, .preview = false};
  const Choice<bool CaptureProducts::*> known[] = {{"grid", &CaptureProducts::grid},         {"gather", &CaptureProducts::gather},
                                                   {"rays", &CaptureProducts::rays},         {"hits", &CaptureProducts::hits},
                                                   {"counters", &CaptureProducts::counters}, {"preview", &CaptureProducts::preview},
                                                   {"exact", &CaptureProducts::exact}};
  for (const std::string& name : splitText(text, ',')) {
    const auto* found = std::ranges::find_if(known, [&](const auto& one) { return name == one.name; });
    if (found == std::end(known))
      throw Error("--products " + text + ": there is no product '" + name + "'; give some of grid,gather,rays,hits,counters,preview,exact");
    products.*found->value = true;
  }
  return products;
}

void addSceneOptions(CLI::App& command, Options& options) {
  OptionGroup scene(command, "Scene");
  command.add_option("SCENE", options.scene, "A .gltf or .glb file, or a built-in scene ('gridscope scenes' lists them)")
      ->type_name("")
      ->group("Scene")
      ->default_str(options.scene);
  scene.whole("--teapots", options.teapots, {0, kMostTeapots}, "0", "Animated teapots to add");
  scene.whole("--moving", options.moving, {0, kMostTeapots}, "all", "How many of the added teapots move");
  scene.text("--camera", "NAME|EX,EY,EZ,TX,TY,TZ[,FOV]", "the scene's first",
             "A camera's name, or eye and target (world units) and vertical field of view (degrees)",
             [&](const std::string& given) { options.camera = given; });
  scene.number("--time", "SECONDS", options.time, {-kMostSeconds, kMostSeconds}, shownDefault(options.time),
               "Of the (first) frame, in the animations");
  scene.number("--frame-step", "SECONDS", options.frameStep, {-kMostSeconds, kMostSeconds}, "1/60", "From one frame to the next");
  scene.text("--size", "WxH", printed("%ux%u", options.settings.width, options.settings.height),
             "Pixels of the frame, one ray each (a built-in scene may bring its own)",
             [&](const std::string& given) { options.size = parseSize(given); });
  scene.whole("--texture-size", options.settings.textureSize, {1, kMostTexelsPerSide}, std::to_string(options.settings.textureSize),
              "Texels of a diffuse map's side on the device");
}

void addGridOptions(CLI::App& command, Options& options) {
  OptionGroup group(command, "Grid");
  GridSettings& grid = options.settings.grid;
  group.whole("--cells", options.cells, {.low = 1}, std::to_string(grid.cells),
              "Along the longest side (a built-in scene may bring its own)");
  group.number("--cell-edge", "LENGTH", options.cellEdge, {1e-9, 1e9}, "", "World units; instead of --cells");
  group.whole("--capacity", options.capacity, {.low = 1}, std::to_string(grid.capacity),
              "Slots of a cell (a built-in scene may bring its own)");
  group.text("--bounds", "MINX,MINY,MINZ,MAXX,MAXY,MAXZ", "",
             "What the grid covers, world units; default: the scene over its whole animation",
             [&](const std::string& given) { grid.bounds = parseBounds(given); });
  group.choice<Stretch>("--stretch", grid.stretch, {{"auto", Stretch::automatic}, {"x", Stretch::x}, {"y", Stretch::y}, {"z", Stretch::z}},
                        "Axis of the image along which a cell's slots lie; auto: the one with the fewest cells");
  group.choice<Builder>("--builder", grid.builder, {{"compute", Builder::compute}, {"raster", Builder::raster}}, "Both make the same bits");
  group.choice<uint32_t>("--insertion", grid.insertion, {{"sorted", kInsertionSorted}, {"first-come", kInsertionFirstCome}},
                         "sorted: the same grid in every run; first-come: the paper's");
  group.choice<NumberBy>("--number-by", grid.numberBy, {{"file", NumberBy::file}, {"area", NumberBy::area}},
                         "Order of the references; full cells refuse the last: by area, the smallest triangles");
  group.choice<uint32_t>("--overlap", grid.overlap, {{"plane", kOverlapPlane}, {"exact", kOverlapExact}},
                         "plane: the paper's test, generous; exact: triangle against cube");
  group.number("--enlargement", "FACTOR", grid.enlargement, {0.01, 100.0}, shownDefault(grid.enlargement),
               "Of the cell in the overlap test");
  group.choice<UpdateMode>("--update", grid.update, {{"all", UpdateMode::all}, {"moved", UpdateMode::moved}},
                           "all: every dynamic instance anew in each frame; moved: only what moved");
}

void addTraceOptions(CLI::App& command, Options& options) {
  OptionGroup group(command, "Rays and trace");
  TraceSettings& trace = options.settings.trace;
  const NumberRange edges{0.0, 1e6};
  group.choice<uint32_t>("--traversal", trace.traversal, {{"segment", kTraversalSegment}, {"dda", kTraversalDda}},
                         "segment: cell-sized steps, the paper's; dda: every cell that the ray pierces");
  group.number("--back", "EDGES", trace.back, edges, shownDefault(trace.back), "How far a segment reaches back, in cell edges");
  group.number("--ahead", "EDGES", options.ahead, edges, shownDefault(trace.ahead),
               "How far it reaches beyond its end, in cell edges (a built-in scene may bring its own)");
  group.number("--tmin", "EDGES", trace.tMin, edges, shownDefault(trace.tMin), "Nearest hit that counts, in cell edges");
  group.choice<bool>("--gap-fill", trace.gapFill, {{"on", true}, {"off", false}},
                     "Voxel hits in saturated cells where no triangle was hit");
  group.number("--gate", "EDGES", trace.gate, edges, shownDefault(trace.gate),
               "No voxel hit nearer than this to the plane of the surface that the ray leaves, in cell edges");
  group.text("--max-segments", "N", "enough to cross the grid", "Segments (dda: cells) after which a ray ends",
             [&trace](const std::string& given) { trace.maxSegments = parseWhole("--max-segments", given, {.low = 1}); });
  group.whole("--seed", options.settings.bounce.seed, {}, std::to_string(options.settings.bounce.seed), "Of the glossy bounce");
  group.number("--roughness", "0..1", options.settings.bounce.roughness, {0.0, 1.0}, "",
               "Most roughness that the bounce gives a material: rough ones mirror as glossy ones; 1 leaves their own");
  group.text("--rays", "FILE.npy", "",
             "Own rays instead of the bounce: floats of shape (H,W,6|9) or (N,6|9): origin, direction[, launch normal]",
             [&options](const std::string& given) { options.rays = given; });
}

}  // namespace

void addFrameOptions(CLI::App& command, Options& options) {
  addSceneOptions(command, options);
  addGridOptions(command, options);
  addTraceOptions(command, options);
  addDeviceOption(command, options);
  addValidationOption(command, options);
}

void addDeviceOption(CLI::App& command, Options& options) {
  OptionGroup(command, "Device")
      .text("--device", "NAME|INDEX|cpu", "the first that can be used",
            "A Vulkan device ('gridscope info' lists them); cpu: build, update and trace in C++",
            [&](const std::string& given) { options.device = given; });
}

void addValidationOption(CLI::App& command, Options& options) {
  OptionGroup(command, "Device")
      .flag("--validation", options.validation, true, "Vulkan's validation layers, synchronization too; exit 1 when they report anything");
}

void addPictureOptions(CLI::App& command, Options& options) {
  OptionGroup group(command, "Pictures");
  std::vector<std::string> names;
  for (const View& view : allViews()) names.emplace_back(view.name);
  group.text(
      "--view", "NAME[,NAME...]|all|truth", "final",
      "Views to write: " + joined(names, ", ") + "; all: those that need nothing beside the frame; truth: verdict, cause, error, lost",
      [&](const std::string& given) { options.views = parseViews(given); });
  options.views = parseViews("final");
  group.text("--out", "DIR", options.out.string(), "Folder of the pictures: DIR/VIEW.png; with several frames DIR/VIEW.0000.png",
             [&](const std::string& given) { options.out = given; });
  group.whole("--frames", options.frames, {1, kMostFrames}, std::to_string(options.frames), "How many");
  group.text("--slice", "x|y|z:INDEX", "y, the middle", "Layer of cells that the views slice and NAME-slice show",
             [&](const std::string& given) { options.slice = parseSlice(given); });
  group.text("--range", "MIN:MAX", "the view's own", "Values at the ends of the colour map, in the view's unit",
             [&](const std::string& given) { options.range = parseRange(given); });
  group.flag("--no-legend", options.legend, false, "Pictures without the strip below");
  group.flag("--check-cpu", options.checkCpu, true, "Compare every product with the C++ path; exit 1 names the first difference");
  group.whole(
      "--check-exact", options.checkExact, {}, "0",
      "Compare N rays of the last frame with the nearest hit among all triangles; lists those that differ, exit 1 when more than 5 do");
}

void addRunsOption(CLI::App& command, Options& options) {
  OptionGroup(command, "Runs").whole("--runs", options.runs, {20, 100000}, std::to_string(options.runs), "Timed runs of each stage");
}

void addJsonOption(CLI::App& command, Options& options) {
  OptionGroup(command, "Results")
      .text("--json", "FILE", "", "The results as JSON; - is standard output (then text goes to standard error)",
            [&](const std::string& given) { options.json = given; });
}

void addFilesOption(CLI::App& command, Options& options, const std::string& what, size_t count) {
  CLI::Option* files = command.add_option_function<std::vector<std::string>>(
      "files", [&](const std::vector<std::string>& given) { options.captures.files.assign(given.begin(), given.end()); }, what);
  files->required()->type_name("FILE");
  if (count != 0) files->expected(static_cast<int>(count));
  OptionGroup(command, "Files").flag("--salvage", options.captures.salvage, true, "Open damaged captures without the entries that fail");
}

void addCaptureFileOptions(CLI::App& command, Options& options) {
  OptionGroup group(command, "Capture");
  CaptureOptions& captures = options.captures;
  group.text("-o,--output", "FILE.gridcap", "", "The file to write", [&](const std::string& given) { captures.output = given; });
  group.text("--note", "TEXT", "", "Kept in the file: what it shows", [&](const std::string& given) { captures.note = given; });
  group.text("--products", "NAME[,NAME...]", "all but exact",
             "Of grid, gather, rays, hits, counters, preview, exact (the nearest hit among all triangles)",
             [&](const std::string& given) { captures.products = parseProducts(given); });
  group.whole("--sequence", captures.sequence, {1, 65536}, std::to_string(captures.sequence), "Consecutive frames in the file");
  group.flag("--salvage", captures.salvage, true, "Open a damaged capture without the entries that fail");
}

void addReplayChoices(CLI::App& command, Options& options) {
  OptionGroup group(command, "Replay");
  CaptureOptions& captures = options.captures;
  group.choice<ReplayFrom>(
      "--from", captures.from,
      {{"auto", ReplayFrom::automatic}, {"build", ReplayFrom::build}, {"update", ReplayFrom::update}, {"trace", ReplayFrom::trace}},
      "First stage to run again; auto: build where gridscope built the grid, else trace");
  group.whole("--repeat", captures.repeat, {.low = 1}, std::to_string(captures.repeat), "Runs; what is not the same in each is different");
  group.whole("--jobs", captures.jobs, {1, 256}, std::to_string(captures.jobs), "Processes at a time");
  group.text("--shard", "I/N", "1/1", "Every N-th file from the I-th, of the sorted list", [&](const std::string& given) {
    const std::vector<std::string> parts = splitText(given, '/');
    if (parts.size() != 2) throw Error("--shard " + given + ": give I/N, 1/4 say");
    captures.shards = parseWhole("--shard (N)", parts[1], {1, 1000000});
    captures.shard = parseWhole("--shard (I)", parts[0], {1, captures.shards});
  });
  group.text("--junit", "FILE", "", "Verdicts as a JUnit file, a test case a capture",
             [&](const std::string& given) { captures.junit = given; });
  addDifferenceFolderOption(command, options);
}

void addDifferenceFolderOption(CLI::App& command, Options& options) {
  OptionGroup(command, "Pictures")
      .text("--out", "DIR", "", "Folder of a difference picture and an A/B strip for each capture that differs",
            [&](const std::string& given) { options.captures.differences = given; });
}

void addCheckChoices(CLI::App& command, Options& options) {
  OptionGroup group(command, "Check");
  group.whole("--frames", options.frames, {1, kMostFrames}, "1, of a capture all", "How many");
  group.whole("--stability", options.stability, {2, 10000}, "none",
              "Compare N builds: cells and rays that differ; with --insertion first-come the order of arrival decides");
  group.flag("--salvage", options.captures.salvage, true, "Open a damaged capture without the entries that fail");
}

void addFrameNumberOption(CLI::App& command, Options& options) {
  OptionGroup(command, "Frame")
      .whole("--frame", options.frame, {0, kMostFrames - 1}, "0",
             "Which frame of a captured sequence, from 0; of a scene, so many --frame-step after --time");
}

void addPixelOption(CLI::App& command, Options& options) {
  OptionGroup(command, "Ray").text("--pixel", "X,Y", "0,0", "The ray's pixel; 0,0 is the top left", [&](const std::string& given) {
    const std::vector<std::string> parts = splitText(given, ',');
    if (parts.size() != 2) throw Error("--pixel " + given + ": give X,Y, 48,27 say");
    options.captures.pixelX = parseWhole("--pixel (X)", parts[0], {0, kMostPixelsPerSide});
    options.captures.pixelY = parseWhole("--pixel (Y)", parts[1], {0, kMostPixelsPerSide});
  });
}

void addRandomPixelsOption(CLI::App& command, Options& options) {
  OptionGroup(command, "Ray")
      .whole("--random", options.captures.randomPixels, {0, 1000000}, "0",
             "Record as many rays instead, and compare their ends with the frame's hits");
}

void addTuneChoices(CLI::App& command, Options& options) {
  OptionGroup group(command, "Sweep");
  TuneAxes& axes = options.tune.axes;
  group.wholes("--cells-axis", axes.cells, {.low = 1}, "Cells along the longest side to try");
  group.wholes("--capacity-axis", axes.capacities, {.low = 1}, "Capacities to try");
  group.choices<uint32_t>("--overlap-axis", axes.overlaps, {{"plane", kOverlapPlane}, {"exact", kOverlapExact}}, "Overlap tests to try");
  group.choices<NumberBy>("--number-by-axis", axes.numberings, {{"file", NumberBy::file}, {"area", NumberBy::area}}, "Numberings to try");
  group.choices<uint32_t>("--traversal-axis", axes.traversals, {{"segment", kTraversalSegment}, {"dda", kTraversalDda}},
                          "Traversals to try on the best grid");
  const NumberRange edges{0.0, 1e6};
  group.numbers("--back-axis", axes.backs, edges, "Likewise, how far a segment reaches back, in cell edges");
  group.numbers("--ahead-axis", axes.aheads, edges, "Likewise, how far it reaches beyond its end");
  group.numbers("--gate-axis", axes.gates, edges, "Likewise, the gate of gap-filling");
  group.whole("--runs", options.tune.runs, {1, 1000}, std::to_string(options.tune.runs),
              "Timed runs of each build and trace; long ones get fewer");
  group.text("--csv", "FILE", "", "All settings, a line each", [&](const std::string& given) { options.tune.csv = given; });
  group.text("--plot", "FILE.svg|.png", "", "Memory and trace time against wrong rays",
             [&](const std::string& given) { options.tune.plot = given; });
}

void addPageOption(CLI::App& command, Options& options) {
  options.page = "report.html";
  OptionGroup(command, "Results")
      .text("-o,--output", "FILE.html", options.page.string(), "The page to write",
            [&](const std::string& given) { options.page = given; });
}

void addTruthOptions(CLI::App& command, Options& options) {
  OptionGroup group(command, "Truth");
  group.flag("--verify", options.verify, true, "Prove every cause: trace the ray again without that event");
  group.whole("--worst", options.worst, {0, 1000000}, std::to_string(options.worst), "How many of the worst rays to list");
}

std::FILE* textStream(const Options& options) { return options.json == "-" ? stderr : stdout; }

void checkOptions(const Options& options) {
  if (options.cells && options.cellEdge) throw Error("--cells and --cell-edge both say how fine the grid is; give one of them");
  if (options.moving && options.teapots == 0) throw Error("--moving: there are no added teapots that could move; give --teapots N too");
  if (options.moving.value_or(0) > options.teapots)
    throw Error(printed("--moving %u: more than the %u teapots of --teapots", *options.moving, options.teapots));
}

FrameSettings settingsOf(const Options& options, const BuiltInScene* builtIn) {
  FrameSettings settings = options.settings;
  if (options.sizeByDefault) settings.width = options.sizeByDefault->width, settings.height = options.sizeByDefault->height;

  // What the lesson needs. Cells and cell edge say the same thing: one that is given replaces both.
  if (builtIn) {
    if (builtIn->cells != 0) settings.grid.cells = builtIn->cells;
    if (builtIn->cellEdge != 0.0f) settings.grid.cellEdge = builtIn->cellEdge;
    if (builtIn->capacity != 0) settings.grid.capacity = builtIn->capacity;
    if (builtIn->ahead != 0.0f) settings.trace.ahead = builtIn->ahead;
    if (builtIn->width != 0) settings.width = builtIn->width;
    if (builtIn->height != 0) settings.height = builtIn->height;
  }

  // What the person said.
  if (options.cells) settings.grid.cells = *options.cells, settings.grid.cellEdge = 0.0f;
  if (options.cellEdge) settings.grid.cellEdge = *options.cellEdge;
  if (options.capacity) settings.grid.capacity = *options.capacity;
  if (options.ahead) settings.trace.ahead = *options.ahead;
  if (options.size) settings.width = options.size->width, settings.height = options.size->height;
  return settings;
}

}  // namespace gridscope
