// One pixel's whole story in sentences: what its ray should have met, what it met, which event made the difference, and how that was
// proven. The story is a list of parts, so that a window can make links of the names of meshes, triangles, cells and steps, and a
// terminal plain text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/capture/capture.h"
#include "core/truth/proof.h"
#include "core/truth/truth.h"

namespace gridscope {

// A piece of a sentence. `text` is what a person reads, with the spaces around it; the rest is what a link leads to.
struct StoryPart {
  enum class Kind { text, mesh, triangle, cell, step, number, refused };  // refused: the word, in its colour
  Kind kind = Kind::text;
  std::string text;                   // "\n" ends a sentence's line
  uint32_t reference = kNoReference;  // of a triangle; of any triangle of the mesh, for a mesh
  ivec3 cell{-1};                     // of a cell, and of a step's cell
  int segment = -1;                   // of a step: StepRecord::segment
};

// What a story is told from. What it refers to must outlive the call.
struct StoryInput {
  const TruthInput& truth;
  const CaptureNames& names;  // of the scene
  uint32_t pixel = 0;
  uint32_t width = 0;  // of the frame, pixels
  const Ray& ray;
  const Hit& traced;
  const Hit& exact;
  const RayTruth& told;          // of this ray
  const Proof* proof = nullptr;  // null: not proven
};

std::vector<StoryPart> tellPixel(const StoryInput& input);

// The first sentence alone: verdict and cause.
std::vector<StoryPart> tellVerdict(const StoryInput& input);

// Is it a reference to a triangle that the scene has? A damaged grid may hold others.
bool isTriangleOf(const NumberedScene& scene, uint32_t reference);

// What a person calls the mesh that a reference's triangle belongs to.
std::string meshText(const NumberedScene& scene, const CaptureNames& names, uint32_t reference);

std::string plainText(const std::vector<StoryPart>& parts);

}  // namespace gridscope
