// What the panels and overlays that show a ray's step share: its facts, worked out once; its glyph; sentences with links.
#pragma once

#include <imgui.h>

#include <memory>
#include <string_view>

#include "app/frame/step_facts.h"
#include "app/model/window_model.h"

namespace gridscope {

// The selected step with its facts. Valid until the next call.
struct ShownStep {
  std::shared_ptr<const RecordedRay> ray;
  StepFacts facts;
  Sentence sentence;
};
const ShownStep* shownStepFacts(const WindowModel& model);  // null: no step is shown

// The mark of a step's outcome, about `size` pixels across.
void drawStepGlyph(ImDrawList* list, ImVec2 centre, float size, StepOutcome kind);
void stepGlyphInline(StepOutcome kind);  // before a word

// A sentence in a box of the panel's width with a 4 px bar in a colour (0xRRGGBB of the dark theme); clicked links select what they name.
float sentenceBoxHeight(const Sentence& sentence, float width);
void drawSentenceBox(WindowModel& model, const Sentence& sentence, uint32_t barColour, const char* id);

// Selects what a part of a sentence names.
void followLink(WindowModel& model, const SentencePart& part);

// The instance that a reference belongs to, as the scene numbers it.
uint32_t sceneInstanceOf(const SceneFacts& scene, uint32_t reference);

}  // namespace gridscope
