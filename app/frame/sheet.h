// A table as plain values: columns of numbers or words, the order of its rows by a column, the rows that a person's search leaves, and the
// table as CSV. Knows nothing of what it shows.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace gridscope {

using glm::ivec3;

enum class ColumnKind {
  whole,      // 1,234
  decimal,    // 1.234
  percent,    // 12.3 %
  reference,  // 0x00000C22
  word,       // of a list of words
  place,      // 72, 4, 47 of a cell, 214, 192 of a pixel
};

struct SheetColumn {
  std::string title;  // "refused"; one word or two, small letters
  std::string about;  // one sentence: what is counted
  ColumnKind kind = ColumnKind::whole;
  std::vector<double> values;      // one a row: the number, of the word in `words`, or of the place (x fastest); NaN: not known
  std::vector<std::string> words;  // of ColumnKind::word
  ivec3 extent{0};                 // of ColumnKind::place: the grid's or frame's size; z 0: a pixel
  bool known = true;               // false: nobody has worked out these values yet, all rows show a dash
};

struct Sheet {
  std::string name;  // of CSV files: "cells"
  std::vector<SheetColumn> columns;
  std::vector<uint32_t> ids;    // one a row: what the row names
  std::vector<uint8_t> inArea;  // one a row: 1 where the area's rays led; empty: no area filters
  size_t rowCount() const { return ids.size(); }
};

// What stands in a table's cell: "1,234", "72, 4, 47", "-" for what is not known.
std::string sheetText(const SheetColumn& column, size_t row);

// The same for a program: no thousands commas, no unit, nothing for what is not known.
std::string sheetPlainText(const SheetColumn& column, size_t row);

struct SheetOrder {
  size_t column = 0;
  bool falling = true;
  bool operator==(const SheetOrder&) const = default;
};

// Rows that pass the area and the search, in order. What is not known comes last either way; equal rows keep the sheet's order.
struct SheetRows {
  std::vector<uint32_t> rows;
  size_t inArea = 0;  // rows that the area left, before the search
};

// `search`: terms with a space between them; a row must hold all of them, in small or capital letters.
//   text          anywhere in what the row shows; commas within a number may be left out
//   TITLE text    in that column: a number or a place must be equal ("cell 72,4,47"), a word must hold the text ("cause gate")
//   TITLE>number  likewise <, >=, <=, = ("refused>5")
SheetRows sheetRows(const Sheet& sheet, const SheetOrder& order, std::string_view search);

// The rows as RFC 4180 says: titles first, CRLF, quotes where a comma, quote or line break stands.
std::string sheetCsv(const Sheet& sheet, std::span<const uint32_t> rows);

// Any rows of fields likewise, titles among them.
std::string csvText(std::span<const std::vector<std::string>> rows);

// "hall_cells.csv"; scene: path or name.
std::string csvName(const std::string& scene, const std::string& table);

}  // namespace gridscope
