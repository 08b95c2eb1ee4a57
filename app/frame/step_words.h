// What became of a step of a ray, for people: its class with a fixed colour and shape, and the words for tests. Sentences are pieces, some of
// which are links; step_facts.h makes them. No ImGui here.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/trace/trace.h"

namespace gridscope {

enum class StepOutcome {
  outside,  // starts outside the grid
  revisit,  // starts in the cell visited last: skipped
  empty,    // the cell's first slot is blank
  tested,   // references were tested, none was hit
  held,     // the same in a saturated cell, but the gap was not filled
  hit,      // a triangle was hit (dda: the nearest so far)
  voxelHit  // the gap was filled: the ray ends
};
inline constexpr int kStepOutcomeCount = 7;

enum class StepShape { dot, ring, square, hatchedSquare, filledSquare, diamond, cross };

struct StepLook {
  std::string_view word;
  uint32_t colour;  // kColour... (palette.h)
  StepShape shape;
};

StepOutcome stepOutcome(const RayRecord& record, uint32_t step);
const StepLook& stepLook(StepOutcome kind);

// "hit", "behind", "before window", "past end", "outside", "parallel", "farther", "alpha 12".
std::string testWord(const TestRecord& test);
uint32_t testColour(uint32_t verdict);  // of kTest...

// One piece of a sentence.
struct SentencePart {
  enum class Link { none, cell, triangle, instance, step, pixel };
  std::string text;
  Link link = Link::none;
  ivec3 cell{-1};       // of Link::cell
  uint32_t number = 0;  // of the others: reference, scene instance, step, pixel
  uint32_t colour = 0;  // kColour... of a word with a meaning; 0: plain
};
using Sentence = std::vector<SentencePart>;

std::string plainText(const Sentence& sentence);

std::string cellNumbers(ivec3 cell);  // "(72, 4, 47)"

}  // namespace gridscope
