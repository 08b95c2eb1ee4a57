// The pieces of the right column: a body for each kind of selection, and what they are made of.
#pragma once

#include <optional>
#include <string>

#include "app/model/window_model.h"
#include "app/ui/widgets/step_parts.h"

namespace gridscope {

// Bodies, each for what is selected.
void drawStepInspector(WindowModel& model, const ShownStep& shown);
void drawCellInspector(WindowModel& model, ivec3 cell);
void drawTriangleInspector(WindowModel& model, uint32_t reference);
void drawInstanceInspector(WindowModel& model, uint32_t sceneInstance);
void drawPixelTab(WindowModel& model);
void drawBookmarksTab(WindowModel& model);

// The selection's name, its class in its colour, and at the right: focus, and copy as text.
struct InspectorTitle {
  std::string name;
  std::string word;
  uint32_t colour = 0;               // kColour... of the word
  std::optional<StepOutcome> glyph;  // before the word; otherwise a swatch
  bool hatched = false;
  std::optional<Bounds> focus;  // world; nothing: the button is disabled
  std::string text;             // what is copied
};
void drawInspectorTitle(WindowModel& model, const InspectorTitle& title);

// A row "label  value" whose value may have changed against the step before: then it is marked. What follows on the line goes on with SameLine.
void factLabel(const char* label, bool changed = false);
void factValue(const char* label, const std::string& value, bool changed = false);

std::string pointText(const vec3& point);

// The mesh's material; "-" where there is none.
std::string materialName(const SceneFacts& scene, uint32_t reference);

}  // namespace gridscope
