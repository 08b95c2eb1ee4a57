// Part of the guard (guard.h): that every buffer view lies in its buffer, every accessor in its view, and that the nodes are
// trees. The document has the known shape (shape.h).
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/gltf_files.h"

namespace gridscope {

void checkRanges(const nlohmann::json& document, const std::vector<Bytes>& buffers);
void checkNodeTree(const nlohmann::json& document);

// Bytes of a glTF component type (5120 ... 5126), 0 for an unknown one.
uint32_t gltfComponentBytes(uint64_t componentType);

}  // namespace gridscope
