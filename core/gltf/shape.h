// The shape of a glTF document, as tables: which keys the loader knows and what each must be. A document that has passed holds
// nothing but known keys with values of the right kind, and every index in it is in range.
// Source: the JSON schemas of the glTF 2.0 specification, Khronos Group, 2021.
#pragma once

#include <nlohmann/json.hpp>

namespace gridscope {

// A copy of the document with the known keys alone. Throws Error naming the place: "meshes[3].primitives[0].indices ...".
nlohmann::json knownShape(const nlohmann::json& document);

}  // namespace gridscope
