// Structures as JSON objects, field by field, described once for both directions. A float is written as {"value": 0.15, "bits": "0x3e19999a"}: for
// people and bit for bit; a plain number is taken too. A field that is absent or null keeps what it had.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/grid/fields.h"
#include "core/trace/settings.h"
#include "shaders/shared/trace/frame.h"

namespace gridscope {

using Json = nlohmann::json;

// Bits of a float as text, and back; false for other texts.
inline std::string bitsText(float value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08x", std::bit_cast<uint32_t>(value));
  return text;
}

inline bool parseBits(const std::string& text, float& value) {
  uint32_t bits = 0;
  if (text.size() != 10 || !text.starts_with("0x")) return false;
  const auto [end, fault] = std::from_chars(text.data() + 2, text.data() + text.size(), bits, 16);
  if (fault != std::errc() || end != text.data() + text.size()) return false;
  value = std::bit_cast<float>(bits);
  return true;
}

// The shortest decimal number that gives the float back.
inline Json shortNumber(float value) {
  if (!std::isfinite(value)) return nullptr;
  char text[32];
  *std::to_chars(text, text + sizeof text - 1, value).ptr = '\0';
  const double number = std::strtod(text, nullptr);
  return static_cast<float>(number) == value ? number : static_cast<double>(value);
}

class FieldWriter {
 public:
  static constexpr bool kWrites = true;
  Json json = Json::object();

  void operator()(const char* name, const float& value) { json[name] = {{"value", shortNumber(value)}, {"bits", bitsText(value)}}; }
  void operator()(const char* name, const vec3& v) {
    json[name] = {{"value", {shortNumber(v.x), shortNumber(v.y), shortNumber(v.z)}},
                  {"bits", {bitsText(v.x), bitsText(v.y), bitsText(v.z)}}};
  }
  void operator()(const char* name, const ivec3& v) { json[name] = {v.x, v.y, v.z}; }
  void operator()(const char* name, const int& value) { json[name] = value; }
  void operator()(const char* name, const uint32_t& value) { json[name] = value; }
  void operator()(const char* name, const bool& value) { json[name] = value; }
  void operator()(const char* name, const std::string& value) { json[name] = value; }
  void operator()(const char* name, const std::vector<std::string>& values) { json[name] = values; }

  template <class Choice>
  void choice(const char* name, const Choice& value, std::initializer_list<const char*> names) {
    const auto index = static_cast<size_t>(value);
    CHECK_LT(index, names.size());
    json[name] = names.begin()[index];
  }
};

class FieldReader {
 public:
  static constexpr bool kWrites = false;

  FieldReader(const Json& json, std::string path) : json_(json), path_(std::move(path)) {
    if (!json.is_object()) throw Error((path_.empty() ? "the manifest" : path_) + " is not an object");
  }

  void require(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      if (find(name) == nullptr) throw Error(placeOf(name) + " is missing");
  }

  // The field's object; an empty one where it is absent.
  FieldReader object(const char* name) const {
    static const Json kNothing = Json::object();
    const Json* field = find(name);
    return FieldReader(field == nullptr ? kNothing : *field, placeOf(name));
  }

  bool has(const char* name) const { return find(name) != nullptr; }
  const Json* find(const char* name) const {
    const auto field = json_.find(name);
    return field == json_.end() || field->is_null() ? nullptr : &*field;
  }

  void operator()(const char* name, float& value) const {
    if (const Json* field = find(name)) readFloats(name, *field, &value, 0);
  }
  void operator()(const char* name, vec3& value) const {
    if (const Json* field = find(name)) readFloats(name, *field, &value.x, 3);
  }
  void operator()(const char* name, ivec3& value) const {
    const Json* field = find(name);
    if (field == nullptr) return;
    if (!field->is_array() || field->size() != 3) throw Error(placeOf(name) + " is not a list of 3 whole numbers");
    for (int i = 0; i < 3; ++i) value[i] = static_cast<int>(whole(name, (*field)[i], INT32_MIN, INT32_MAX));
  }
  void operator()(const char* name, int& value) const {
    if (const Json* field = find(name)) value = static_cast<int>(whole(name, *field, INT32_MIN, INT32_MAX));
  }
  void operator()(const char* name, uint32_t& value) const {
    if (const Json* field = find(name)) value = static_cast<uint32_t>(whole(name, *field, 0, UINT32_MAX));
  }
  void operator()(const char* name, bool& value) const {
    const Json* field = find(name);
    if (field != nullptr && !field->is_boolean()) throw Error(placeOf(name) + " is neither true nor false");
    if (field != nullptr) value = field->get<bool>();
  }
  void operator()(const char* name, std::string& value) const {
    if (const Json* field = find(name)) value = text(name, *field);
  }
  void operator()(const char* name, std::vector<std::string>& values) const {
    const Json* field = find(name);
    if (field == nullptr) return;
    if (!field->is_array()) throw Error(placeOf(name) + " is not a list of texts");
    values.clear();
    for (const Json& value : *field) values.push_back(text(name, value));
  }

  template <class Choice>
  void choice(const char* name, Choice& value, std::initializer_list<const char*> names) const {
    const Json* field = find(name);
    if (field == nullptr) return;
    const std::string chosen = text(name, *field);
    std::string list;
    for (size_t i = 0; i < names.size(); ++i) {
      if (chosen == names.begin()[i]) {
        value = static_cast<Choice>(i);
        return;
      }
      list += (i == 0 ? "" : ", ") + std::string(names.begin()[i]);
    }
    throw Error(placeOf(name) + " is none of " + list);
  }

 private:
  std::string placeOf(const char* name) const { return path_.empty() ? name : path_ + "." + name; }

  std::string text(const char* name, const Json& field) const {
    if (!field.is_string()) throw Error(placeOf(name) + " is not a text");
    return field.get<std::string>();
  }

  int64_t whole(const char* name, const Json& field, int64_t low, int64_t high) const {
    const bool fits = field.is_number_unsigned() ? field.get<uint64_t>() <= static_cast<uint64_t>(high)
                                                 : field.is_number_integer() && field.get<int64_t>() >= low && field.get<int64_t>() <= high;
    if (!fits) throw Error(placeOf(name) + " is not a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return field.get<int64_t>();
  }

  // `count` floats of a list; 0: one without a list.
  void readFloats(const char* name, const Json& field, float* values, size_t count) const {
    const bool withBits = field.is_object();
    const Json* numbers = withBits ? member(field, "value") : &field;
    const Json* bits = withBits ? member(field, "bits") : nullptr;
    if (withBits && bits == nullptr) throw Error(placeOf(name) + " has no bits");
    for (const Json* list : {numbers, bits})
      if (list != nullptr && count > 0 && (!list->is_array() || list->size() != count))
        throw Error(placeOf(name) + " is not a list of " + std::to_string(count) + " numbers");
    for (size_t i = 0; i < std::max<size_t>(count, 1); ++i) {
      const auto item = [&](const Json* list) { return list == nullptr ? nullptr : count > 0 ? &(*list)[i] : list; };
      values[i] = readFloat(name, item(numbers), item(bits));
    }
  }

  static const Json* member(const Json& object, const char* name) {
    const auto field = object.find(name);
    return field == object.end() ? nullptr : &*field;
  }

  float readFloat(const char* name, const Json* number, const Json* bits) const {
    const bool hasNumber = number != nullptr && number->is_number();
    if (!hasNumber && bits == nullptr) throw Error(placeOf(name) + " is not a number");
    const double wide = hasNumber ? number->get<double>() : 0.0;
    if (std::abs(wide) > 3.4028234663852886e38) throw Error(placeOf(name) + " is beyond a 32-bit float");
    const float plain = static_cast<float>(wide);
    if (bits == nullptr) return plain;
    float exact = 0.0f;
    if (!bits->is_string() || !parseBits(bits->get<std::string>(), exact))
      throw Error(placeOf(name) + ": its bits are not like \"0x3f800000\"");
    if (hasNumber && std::bit_cast<uint32_t>(plain) != std::bit_cast<uint32_t>(exact))
      throw Error(placeOf(name) + ": its value and its bits disagree; leave the bits out to set the value");
    return exact;
  }

  const Json& json_;
  std::string path_;
};

// --- The structures. What a person sets comes with the option's default, what derives from it with the same formula as derive.h's.

template <class Fields>
void describe(Fields& field, GridSettings& settings) {
  field("cells", settings.cells);
  field("cellEdge", settings.cellEdge);
  field("capacity", settings.capacity);
  field.choice("stretch", settings.stretch, {"x", "y", "z", "auto"});
  field.choice("builder", settings.builder, {"compute", "raster"});
  field.choice("insertion", settings.insertion, {"sorted", "first-come"});
  field.choice("overlap", settings.overlap, {"plane", "exact"});
  field("enlargement", settings.enlargement);
  field.choice("numberBy", settings.numberBy, {"file", "area"});
  field.choice("update", settings.update, {"all", "moved"});
}

template <class Fields>
void describe(Fields& field, Bounds& bounds) {
  field("low", bounds.low);
  field("high", bounds.high);
}

template <class Fields>
void describe(Fields& field, TraceSettings& settings) {
  field.choice("traversal", settings.traversal, {"segment", "dda"});
  field("back", settings.back);
  field("ahead", settings.ahead);
  field("tMin", settings.tMin);
  field("gapFill", settings.gapFill);
  field("gate", settings.gate);
  field("maxSegments", settings.maxSegments);
}

template <class Fields>
void describe(Fields& field, BounceSettings& settings) {
  field("seed", settings.seed);
  field("roughness", settings.roughness);
}

template <class Fields>
void describe(Fields& field, CameraPose& pose) {
  field("name", pose.name);
  field("eye", pose.eye);
  field("target", pose.target);
  field("up", pose.up);
  field("verticalFovDegrees", pose.verticalFovDegrees);
}

template <class Fields>
void describe(Fields& field, TraceParameters& trace) {
  field("tMin", trace.tMin);
  field("back", trace.back);
  field("ahead", trace.ahead);
  field("gate", trace.gate);
  field("gapFill", trace.gapFill);
  field.choice("traversal", trace.traversal, {"segment", "dda"});
  field("maxSegments", trace.maxSegments);
  field("segmentsPerPass", trace.segmentsPerPass);
}

template <class Fields>
void describe(Fields& field, CameraParameters& camera) {
  field("eye", camera.eye);
  field("nearPlane", camera.nearPlane);
  field("right", camera.right);
  field("tanHalfWidth", camera.tanHalfWidth);
  field("up", camera.up);
  field("tanHalfHeight", camera.tanHalfHeight);
  field("forward", camera.forward);
  field("width", camera.width);
  field("height", camera.height);
}

template <class Fields>
void describe(Fields& field, BounceParameters& bounce) {
  field("frame", bounce.frame);
  field("seed", bounce.seed);
  field("roughness", bounce.roughness);
  field("originOffset", bounce.originOffset);
}

template <class Fields>
void describe(Fields& field, ViewParameters& view) {
  field("rangeLow", view.rangeLow);
  field("rangeHigh", view.rangeHigh);
  field("colourMap", view.colourMap);
  field("width", view.width);
  field("height", view.height);
  field("sliceAxis", view.sliceAxis);
  field("sliceIndex", view.sliceIndex);
  field("farDistance", view.farDistance);
  field("sunDirection", view.sunDirection);
}

}  // namespace gridscope
