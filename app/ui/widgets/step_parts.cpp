// See step_parts.h.
#include "app/ui/widgets/step_parts.h"

#include <algorithm>
#include <vector>

#include "app/model/held_ray.h"
#include "app/model/ray_stepping.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

// A word of a sentence, placed in its box.
struct PlacedWord {
  const SentencePart* part;
  size_t partIndex;
  std::string_view text;
  ImVec2 place, size;
};

struct PlacedSentence {
  std::vector<PlacedWord> words;
  float height = 0.0f;
};

constexpr float kBoxPadding = 8.0f, kBar = 4.0f, kLineHeight = 18.0f;  // pixels at UI scale 1

ImFont* wordFont(const SentencePart& part) { return part.link == SentencePart::Link::none ? windowFonts().sans : windowFonts().mono; }

// Links stay whole; plain text breaks behind its spaces.
PlacedSentence placeWords(const Sentence& sentence, float width) {
  PlacedSentence placed;
  const float left = unit(kBar + kBoxPadding), right = std::max(width - unit(kBoxPadding), left + unit(40));
  ImVec2 at(left, unit(kBoxPadding - 2));
  for (size_t index = 0; index < sentence.size(); ++index) {
    const SentencePart& part = sentence[index];
    ImFont* font = wordFont(part);
    const std::string_view text = part.text;
    for (size_t begin = 0; begin < text.size();) {
      const size_t space = part.link == SentencePart::Link::none ? text.find(' ', begin) : std::string_view::npos;
      const size_t end = space == std::string_view::npos ? text.size() : space + 1;
      const std::string_view word = text.substr(begin, end - begin);
      const std::string_view inked = word.back() == ' ' ? word.substr(0, word.size() - 1) : word;
      const float inkedWidth = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, inked.data(), inked.data() + inked.size()).x;
      if (at.x + inkedWidth > right && at.x > left) at = ImVec2(left, at.y + unit(kLineHeight));
      const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, word.data(), word.data() + word.size());
      placed.words.push_back({&part, index, word, at, ImVec2(size.x, unit(kLineHeight))});
      at.x += size.x;
      begin = end;
    }
  }
  placed.height = at.y + unit(kLineHeight) + unit(kBoxPadding - 2);
  return placed;
}

bool drawWord(const PlacedWord& word, ImVec2 corner) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  ImFont* font = wordFont(*word.part);
  const bool isLink = word.part->link != SentencePart::Link::none;
  const ImVec4 colour = isLink ? uiColour(UiColour::link) : word.part->colour ? meaningColour(word.part->colour) : uiColour(UiColour::text);
  const ImVec2 place(corner.x + word.place.x, corner.y + word.place.y);
  const float drop = 0.5f * (word.size.y - font->FontSize);
  list->AddText(font, font->FontSize, ImVec2(place.x, place.y + drop), packed(colour), word.text.data(),
                word.text.data() + word.text.size());
  if (!isLink) return false;
  ImGui::SetCursorScreenPos(place);
  ImGui::PushID(static_cast<int>(word.partIndex));
  const bool clicked = ImGui::InvisibleButton("word", ImVec2(std::max(word.size.x, 1.0f), word.size.y));
  ImGui::PopID();
  if (ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    list->AddLine(ImVec2(place.x, place.y + word.size.y - unit(2)), ImVec2(place.x + word.size.x, place.y + word.size.y - unit(2)),
                  packed(colour));
  }
  return clicked;
}

}  // namespace

const ShownStep* shownStepFacts(const WindowModel& model) {
  struct Cached {
    ShownStep shown;
    uint32_t step = 0;
    std::shared_ptr<const Grid> grid;
    std::shared_ptr<const Demand> demand;
  };
  static Cached cached;
  const std::shared_ptr<const RecordedRay> ray = shownRay(model);
  const std::optional<uint32_t> step = shownStep(model);
  if (!ray || !step || !model.frame->grid || !model.frame->worldTriangles || !model.frame->scene) return nullptr;
  const FrameSnapshot& frame = *model.frame;
  if (cached.shown.ray != ray || cached.step != *step || cached.grid != frame.grid || cached.demand != frame.demand) {
    cached.shown.facts = stepFacts(frame, *ray, *step);
    cached.shown.sentence = explainStep(frame, *ray, cached.shown.facts);
    cached.shown.ray = ray;
    cached.step = *step, cached.grid = frame.grid, cached.demand = frame.demand;
  }
  return &cached.shown;
}

void drawStepGlyph(ImDrawList* list, ImVec2 centre, float size, StepOutcome kind) {
  const StepLook& look = stepLook(kind);
  const ImU32 colour = packed(meaningColour(look.colour));
  const float half = 0.5f * size;
  const ImVec2 low(centre.x - half, centre.y - half), high(centre.x + half, centre.y + half);
  switch (look.shape) {
    case StepShape::dot: list->AddCircleFilled(centre, 0.3f * size, colour, 12); break;
    case StepShape::ring: list->AddCircle(centre, 0.42f * size, colour, 16, std::max(1.5f, 0.14f * size)); break;
    case StepShape::square: list->AddRectFilled(low, high, colour, unit(2)); break;
    case StepShape::hatchedSquare:
      list->AddRectFilled(low, high, colour, unit(2));
      hatch(list, ImVec2(low.x + 1, low.y + 1), ImVec2(high.x - 1, high.y - 1), packed(uiColour(UiColour::panel)));
      list->AddRect(low, high, colour, unit(2), 0, unit(1.5f));
      break;
    case StepShape::filledSquare:
      list->AddRectFilled(low, high, colour, 0.0f);
      list->AddRect(ImVec2(low.x - 1, low.y - 1), ImVec2(high.x + 1, high.y + 1), packed(uiColour(UiColour::text)), 0.0f, 0, 1.0f);
      break;
    case StepShape::diamond:
      list->AddQuadFilled(ImVec2(centre.x, low.y - 1), ImVec2(high.x + 1, centre.y), ImVec2(centre.x, high.y + 1),
                          ImVec2(low.x - 1, centre.y), colour);
      break;
    case StepShape::cross:
      list->AddLine(ImVec2(low.x + 2, low.y + 2), ImVec2(high.x - 2, high.y - 2), colour, unit(1.5f));
      list->AddLine(ImVec2(low.x + 2, high.y - 2), ImVec2(high.x - 2, low.y + 2), colour, unit(1.5f));
      break;
  }
}

void stepGlyphInline(StepOutcome kind) {
  const float height = ImGui::GetTextLineHeight();
  const ImVec2 place = ImGui::GetCursorScreenPos();
  drawStepGlyph(ImGui::GetWindowDrawList(), ImVec2(place.x + unit(6), place.y + 0.5f * height), unit(10), kind);
  ImGui::Dummy(ImVec2(unit(12), height));
  ImGui::SameLine(0.0f, unit(5));
}

float sentenceBoxHeight(const Sentence& sentence, float width) { return placeWords(sentence, width).height; }

void drawSentenceBox(WindowModel& model, const Sentence& sentence, uint32_t barColour, const char* id) {
  const float width = ImGui::GetContentRegionAvail().x;
  const PlacedSentence placed = placeWords(sentence, width);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(corner, ImVec2(corner.x + width, corner.y + placed.height), packed(uiColour(UiColour::head)));
  list->AddRectFilled(corner, ImVec2(corner.x + unit(kBar), corner.y + placed.height), packed(meaningColour(barColour)));
  ImGui::PushID(id);
  const SentencePart* clicked = nullptr;
  for (const PlacedWord& word : placed.words)
    if (drawWord(word, corner)) clicked = word.part;
  ImGui::PopID();
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy(ImVec2(width, placed.height));
  if (clicked) followLink(model, SentencePart(*clicked));
}

void followLink(WindowModel& model, const SentencePart& part) {
  switch (part.link) {
    case SentencePart::Link::cell: model.selection.selectCell(part.cell); break;
    case SentencePart::Link::triangle: model.selection.selectTriangle(part.number); break;
    case SentencePart::Link::instance: model.selection.selectInstance(part.number); break;
    case SentencePart::Link::step: selectStepAt(model, part.number); break;
    case SentencePart::Link::pixel: model.selection.selectPixel(part.number); break;
    case SentencePart::Link::none: break;
  }
}

uint32_t sceneInstanceOf(const SceneFacts& scene, uint32_t reference) {
  const uint32_t instance = referenceInstance(reference);
  return instance < scene.numbered.sources.size() ? scene.numbered.sources[instance].sceneInstance : 0;
}

}  // namespace gridscope
