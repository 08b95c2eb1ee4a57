// What tables are drawn from: the strip above them, small buttons, titles, numbers to the right, rows that can be clicked.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace gridscope {

inline constexpr ImGuiTableFlags kTableFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable | ImGuiTableFlags_NoBordersInBody |
                                               ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX;

// Colours and spacing of tables while it lives.
class TableStyle {
 public:
  TableStyle();
  ~TableStyle();
  TableStyle(const TableStyle&) = delete;
  TableStyle& operator=(const TableStyle&) = delete;
};

float tableRowHeight();  // of one row, pixels of this window

void beginStrip();             // the line above a table: what comes next stands on it
void toTheRight(float width);  // goes on in the present line, `width` before the right edge, where there is room
bool smallButton(const char* label, const char* id, const char* tooltip, bool enabled = true, const char* whyNot = "");
bool rowButton(const char* label, const char* id, const char* tooltip, bool enabled = true, const char* whyNot = "");  // within a row
float smallButtonWidth(const char* label);
bool exportButton(const char* tooltip, bool enabled = true, const char* whyNot = "");  // "Export CSV" at the right end of the present line

void tableTitle(const char* title, bool toTheRight);  // in the present column of the title row
bool rowSelectable(bool selected);                    // spans the row; what follows is drawn over it
void smallText(std::string_view text, const ImVec4& colour);
void rightNumber(std::string_view text, const ImVec4& colour);  // at the right of the column
void leftNumber(std::string_view text, const ImVec4& colour);

}  // namespace gridscope
