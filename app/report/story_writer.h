// Puts the parts of a pixel's story together (pixel_story.h).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/base/text.h"
#include "app/report/pixel_story.h"

namespace gridscope {

class StoryWriter {
 public:
  explicit StoryWriter(const StoryInput& input) : input_(input) {}

  StoryWriter& text(std::string words) { return add({.text = std::move(words)}); }
  StoryWriter& number(std::string words) { return add({.kind = StoryPart::Kind::number, .text = std::move(words)}); }
  StoryWriter& cell(ivec3 cell) {
    return add({.kind = StoryPart::Kind::cell, .text = printed("cell (%d, %d, %d)", cell.x, cell.y, cell.z), .cell = cell});
  }
  StoryWriter& step(int segment, ivec3 cell) {
    return add({.kind = StoryPart::Kind::step, .text = printed("step %d", segment), .cell = cell, .segment = segment});
  }
  // The same at the beginning of a sentence.
  StoryWriter& stepTitle(int segment, ivec3 cell) {
    return add({.kind = StoryPart::Kind::step, .text = printed("Step %d", segment), .cell = cell, .segment = segment});
  }
  StoryWriter& refusedWord() { return add({.kind = StoryPart::Kind::refused, .text = "refused"}); }
  StoryWriter& mesh(uint32_t reference) {
    return add({.kind = StoryPart::Kind::mesh, .text = meshText(scene(), input_.names, reference), .reference = reference});
  }
  // "triangle 5,388 of nave vault".
  StoryWriter& triangle(uint32_t reference) {
    triangleAlone(reference);
    return isTriangleOf(scene(), reference) ? text(" of ").mesh(reference) : text(", which is no triangle of the scene");
  }
  StoryWriter& triangleAlone(uint32_t reference) {
    const std::string name =
        isTriangleOf(scene(), reference) ? "triangle " + grouped(nameTriangle(scene(), reference).triangle) : printed("0x%08X", reference);
    return add({.kind = StoryPart::Kind::triangle, .text = name, .reference = reference});
  }
  StoryWriter& end() { return text("\n"); }
  std::vector<StoryPart> take() { return std::move(parts_); }

 private:
  const NumberedScene& scene() const { return input_.truth.trace.scene; }
  StoryWriter& add(StoryPart part) {
    parts_.push_back(std::move(part));
    return *this;
  }

  const StoryInput& input_;
  std::vector<StoryPart> parts_;
};

}  // namespace gridscope
