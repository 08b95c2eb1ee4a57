// See manifest.h.
#include "core/capture/manifest.h"

#include <cmath>
#include <set>

#include "core/base/gltf_files.h"
#include "core/grid/derive.h"
#include "core/trace/derive.h"
#include "shaders/shared/grid/parameters.h"

namespace gridscope {

namespace {

constexpr const char* kFormat = "gridscope capture";
constexpr int kMostDepth = 64;  // of nested JSON; ours has 5
constexpr size_t kMostFrames = 65536;
constexpr size_t kMostFrameSide = 65535;

// Where a foreign capture says nothing: as the pipeline has it for a scene of the grid's size.
constexpr float kOriginOffset = 1e-5f;  // of the diagonal
const vec3 kSunDirection = glm::normalize(vec3(0.35f, 0.85f, 0.25f));

Bounds gridBounds(const GridParameters& grid) { return {grid.origin, grid.origin + vec3(grid.cellCount) * grid.cellEdge}; }

void readSettings(const FieldReader& field, PixelSize size, FrameSettings& settings) {
  settings.width = size.width;
  settings.height = size.height;
  const FieldReader grid = field.object("grid");
  describe(grid, settings.grid);
  if (grid.has("bounds")) {
    settings.grid.bounds.emplace();
    const FieldReader bounds = grid.object("bounds");
    bounds.require({"low", "high"});
    describe(bounds, *settings.grid.bounds);
  }
  const FieldReader trace = field.object("trace"), bounce = field.object("bounce"), camera = field.object("camera");
  describe(trace, settings.trace);
  describe(bounce, settings.bounce);
  describe(camera, settings.camera);
  field("width", settings.width);
  field("height", settings.height);
  field("textureSize", settings.textureSize);
  if (settings.width < 1 || settings.height < 1 || settings.width > kMostFrameSide || settings.height > kMostFrameSide)
    throw Error("settings.width and height are not from 1 to 65535");
}

// A capture without a camera is seen from a corner of its grid.
void placeCamera(const Bounds& bounds, CameraPose& pose) {
  pose.eye = bounds.high;
  pose.target = (bounds.low + bounds.high) * 0.5f;
}

void readFrame(const FieldReader& field, const Capture& capture, float diagonal, CaptureFrame& frame) {
  frame.bounce.seed = capture.settings.bounce.seed;
  frame.bounce.roughness = capture.settings.bounce.roughness;
  frame.bounce.originOffset = kOriginOffset * diagonal;
  frame.view.farDistance = diagonal;
  frame.view.sunDirection = kSunDirection;
  field("timeSeconds", frame.timeSeconds);
  const FieldReader camera = field.object("camera"), bounce = field.object("bounce"), view = field.object("view");
  if (!field.has("camera"))
    frame.camera = deriveCamera(capture.settings.camera, capture.settings.width, capture.settings.height, diagonal);
  else
    camera.require({"eye", "nearPlane", "right", "tanHalfWidth", "up", "tanHalfHeight", "forward"});
  frame.camera.width = capture.settings.width;
  frame.camera.height = capture.settings.height;
  describe(camera, frame.camera);
  describe(bounce, frame.bounce);
  describe(view, frame.view);
}

template <class Structure>
Json written(Structure structure) {
  FieldWriter field;
  describe(field, structure);
  return field.json;
}

Json settingsJson(const FrameSettings& settings) {
  Json json = {{"grid", written(settings.grid)},     {"trace", written(settings.trace)}, {"bounce", written(settings.bounce)},
               {"camera", written(settings.camera)}, {"width", settings.width},          {"height", settings.height},
               {"textureSize", settings.textureSize}};
  if (settings.grid.bounds) json["grid"]["bounds"] = written(*settings.grid.bounds);
  return json;
}

Json gridJson(const GridParameters& parameters) {
  GridParameters grid = parameters;
  FieldWriter field;
  describeShape(field, grid);
  describeDerived(field, grid);
  return field.json;
}

}  // namespace

Json parseManifest(std::string_view text) {
  // What would be read in two ways, or overflow a stack later, ends here.
  std::vector<std::set<std::string>> keys;
  const auto watch = [&keys](int depth, Json::parse_event_t event, Json& value) {
    if (depth > kMostDepth) throw Error("is nested more than " + std::to_string(kMostDepth) + " levels deep");
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
      throw Error("has the key '" + plainName(value.get<std::string>()) + "' twice");
    return true;
  };
  Json manifest;
  try {
    manifest = Json::parse(text, watch);
  } catch (const Json::exception&) {
    throw Error("is not JSON");
  }
  if (!manifest.is_object() || manifest.value("format", Json()) != kFormat)
    throw Error(std::string("is not of a capture: its format is not '") + kFormat + "'");
  const uint32_t version = manifestVersion(manifest);
  if (version > kCaptureVersion)
    throw Error("is of version " + std::to_string(version) + "; this program reads versions up to " + std::to_string(kCaptureVersion) +
                ": use a newer one");
  return manifest;
}

uint32_t manifestVersion(const Json& manifest) {
  const FieldReader field(manifest, "");
  field.require({"version"});
  uint32_t version = 0;
  field("version", version);
  if (version == 0) throw Error("version is 0; versions begin at 1");
  return version;
}

std::vector<ListedEntry> listedEntries(const Json& manifest) {
  std::vector<ListedEntry> entries;
  const auto list = manifest.find("entries");
  if (list == manifest.end() || !list->is_object()) throw Error("entries is missing: an object with each array's dtype and shape");
  for (const auto& [name, facts] : list->items()) {
    const std::string place = "entries." + plainName(name);
    const FieldReader field(facts, place);
    field.require({"dtype", "shape"});
    const Json& shape = *field.find("shape");
    std::string dtype;
    field("dtype", dtype);
    ListedEntry entry{.name = name, .type = NpyType::u1, .shape = {}};
    bool known = false;
    for (NpyType type : {NpyType::u1, NpyType::u2, NpyType::u4, NpyType::u8, NpyType::i4, NpyType::i8, NpyType::f4, NpyType::f8})
      if (dtype == npyTypeName(type)) entry.type = type, known = true;
    if (!known) throw Error(place + ".dtype is none of |u1, <u2, <u4, <u8, <i4, <i8, <f4, <f8");
    if (!shape.is_array() || shape.size() > 32) throw Error(place + ".shape is not a list of at most 32 whole numbers");
    for (const Json& side : shape) {
      if (!side.is_number_unsigned()) throw Error(place + ".shape is not a list of whole numbers");
      entry.shape.push_back(side.get<uint64_t>());
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

size_t manifestFrameCount(const Json& manifest) {
  const auto frames = manifest.find("frames");
  if (frames == manifest.end() || frames->is_null()) return 1;
  if (!frames->is_array() || frames->empty() || frames->size() > kMostFrames) throw Error("frames is not a list of 1 to 65536 frames");
  return frames->size();
}

void readManifest(const Json& manifest, PixelSize size, Capture& capture) {
  const FieldReader field(manifest, "");
  field("writer", capture.writer);
  field("device", capture.device);
  field("driver", capture.driver);
  field("note", capture.note);

  // Settings, then what derives from them.
  const FieldReader settings = field.object("settings");
  readSettings(settings, size, capture.settings);
  field.require({"grid"});
  readGridFields(field.object("grid"), capture.settings.grid, capture.grid);
  capture.trace = deriveTrace(capture.settings.trace, capture.grid);
  const FieldReader trace = field.object("trace");
  describe(trace, capture.trace);

  // The scene's facts.
  const FieldReader scene = field.object("scene"), bounds = scene.object("bounds");
  capture.bounds = gridBounds(capture.grid);
  describe(bounds, capture.bounds);
  if (!settings.has("camera")) placeCamera(capture.bounds, capture.settings.camera);
  scene("name", capture.names.scene);
  scene("meshes", capture.names.meshes);
  scene("instances", capture.names.instances);
  scene("materials", capture.names.materials);

  // Frames. Without a list there is one.
  const float diagonal = glm::length(capture.bounds.high - capture.bounds.low);
  static const Json kNothing = Json::object();
  const Json* frames = field.find("frames");
  for (size_t i = 0; i < capture.frames.size(); ++i) {
    capture.frames[i].bounce.frame = static_cast<uint32_t>(i);
    readFrame(FieldReader(frames == nullptr ? kNothing : (*frames)[i], "frames[" + std::to_string(i) + "]"), capture, diagonal,
              capture.frames[i]);
  }
}

Json makeManifest(const Capture& capture) {
  Json manifest = {{"format", kFormat},
                   {"version", kCaptureVersion},
                   {"writer", capture.writer},
                   {"device", capture.device},
                   {"driver", capture.driver},
                   {"note", capture.note},
                   {"settings", settingsJson(capture.settings)},
                   {"grid", gridJson(capture.grid)},
                   {"trace", written(capture.trace)}};
  manifest["scene"] = {{"name", capture.names.scene},
                       {"meshes", capture.names.meshes},
                       {"instances", capture.names.instances},
                       {"materials", capture.names.materials},
                       {"bounds", written(capture.bounds)}};
  manifest["frames"] = Json::array();
  for (const CaptureFrame& frame : capture.frames) {
    Json json = {{"camera", written(frame.camera)}, {"bounce", written(frame.bounce)}, {"view", written(frame.view)}};
    FieldWriter field;
    field("timeSeconds", frame.timeSeconds);
    json.update(field.json);
    manifest["frames"].push_back(std::move(json));
  }
  return manifest;
}

Json unknownKeys(const Json& object, const Json& known) {
  if (object.is_array() && known.is_array() && object.size() == known.size()) {
    Json rest = Json::array();
    bool any = false;
    for (size_t i = 0; i < object.size(); ++i) {
      rest.push_back(unknownKeys(object[i], known[i]));
      any = any || !rest.back().is_null();
    }
    return any ? rest : Json();
  }
  if (!object.is_object() || !known.is_object()) return {};
  Json rest;
  for (const auto& [key, value] : object.items()) {
    const auto match = known.find(key);
    Json part = match == known.end() ? value : unknownKeys(value, *match);
    if (!part.is_null()) rest[key] = std::move(part);
  }
  return rest;
}

void addKeys(Json& object, const Json& more) {
  if (object.is_array() && more.is_array() && object.size() == more.size()) {
    for (size_t i = 0; i < object.size(); ++i) addKeys(object[i], more[i]);
  } else if (object.is_object() && more.is_object()) {
    for (const auto& [key, value] : more.items()) {
      const auto match = object.find(key);
      if (match == object.end())
        object[key] = value;
      else
        addKeys(*match, value);
    }
  }
}

}  // namespace gridscope
