// Sheets: what stands in their cells, the order of rows, the search, CSV.
#include "app/frame/sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace gridscope {
namespace {

// Three cells: 1,2,3 refused 1,234 for "gate"; 11,2,3 nothing; 1,2,0 is not known.
Sheet smallSheet() {
  Sheet sheet{.name = "cells"};
  sheet.ids = {321, 331, 21};
  const ivec3 extent(20, 5, 9);
  const auto number = [&](int x, int y, int z) { return double((z * extent.y + y) * extent.x + x); };
  sheet.columns = {
      {.title = "cell", .kind = ColumnKind::place, .values = {number(1, 2, 3), number(11, 2, 3), number(1, 2, 0)}, .extent = extent},
      {.title = "refused", .kind = ColumnKind::whole, .values = {1234, 0, NAN}},
      {.title = "cause", .kind = ColumnKind::word, .values = {1, 0, 1}, .words = {"stepped over", "Gate, \"held\""}},
      {.title = "t", .kind = ColumnKind::decimal, .values = {4.30267, 0.05, 12}}};
  return sheet;
}

std::vector<uint32_t> found(const Sheet& sheet, std::string_view search) { return sheetRows(sheet, {.column = 99}, search).rows; }
using Rows = std::vector<uint32_t>;

TEST(Sheet, ACellShowsItsValueAsPeopleReadIt) {
  const Sheet sheet = smallSheet();
  EXPECT_EQ(sheetText(sheet.columns[0], 1), "11, 2, 3");
  EXPECT_EQ(sheetText(sheet.columns[1], 0), "1,234");
  EXPECT_EQ(sheetText(sheet.columns[1], 2), "\u2013");
  EXPECT_EQ(sheetText(sheet.columns[3], 0), "4.303");
  SheetColumn pixels{.title = "pixel", .kind = ColumnKind::place, .values = {643}, .extent = ivec3(640, 360, 0)};
  EXPECT_EQ(sheetText(pixels, 0), "3, 1");
  const SheetColumn references{.title = "reference", .kind = ColumnKind::reference, .values = {3106}};
  EXPECT_EQ(sheetText(references, 0), "0x00000C22");
  EXPECT_EQ(found({.name = "triangles", .columns = {references}, .ids = {3106}}, "0x00000c22"), (std::vector<uint32_t>{0}));
  EXPECT_EQ(found({.name = "triangles", .columns = {references}, .ids = {3106}}, "22"), (std::vector<uint32_t>{}));
}

TEST(Sheet, RowsAreSortedEitherWayAndWhatIsNotKnownComesLast) {
  const Sheet sheet = smallSheet();
  EXPECT_EQ(sheetRows(sheet, {1, true}, "").rows, (Rows{0, 1, 2}));
  EXPECT_EQ(sheetRows(sheet, {1, false}, "").rows, (Rows{1, 0, 2}));
  EXPECT_EQ(sheetRows(sheet, {3, true}, "").rows, (Rows{2, 0, 1}));
}

TEST(Sheet, WordsAreSortedByTheAlphabetAndEqualOnesKeepTheirOrder) {
  EXPECT_EQ(sheetRows(smallSheet(), {2, false}, "").rows, (Rows{0, 2, 1}));
  EXPECT_EQ(sheetRows(smallSheet(), {2, true}, "").rows, (Rows{1, 0, 2}));
}

TEST(Sheet, ASearchFindsTextAnywhereInARowInSmallOrCapitalLetters) {
  const Sheet sheet = smallSheet();
  EXPECT_EQ(found(sheet, ""), (Rows{0, 1, 2}));
  EXPECT_EQ(found(sheet, "gAtE"), (Rows{0, 2}));
  EXPECT_EQ(found(sheet, "1234"), (Rows{0}));
  EXPECT_EQ(found(sheet, "1,234"), (Rows{0}));
  EXPECT_EQ(found(sheet, "4.30"), (Rows{0}));
  EXPECT_EQ(found(sheet, "1,2,3"), (Rows{0, 1}));
  EXPECT_EQ(found(sheet, "gate 4.30"), (Rows{0}));
  EXPECT_EQ(found(sheet, "nothing like it"), (Rows{}));
}

TEST(Sheet, ATitleBeforeATermSearchesThatColumnAlone) {
  const Sheet sheet = smallSheet();
  EXPECT_EQ(found(sheet, "cell 1,2,3"), (Rows{0}));
  EXPECT_EQ(found(sheet, "CELL 1, 2, 3"), (Rows{0}));
  EXPECT_EQ(found(sheet, "cell 11,2,3"), (Rows{1}));
  EXPECT_EQ(found(sheet, "refused 0"), (Rows{1}));
  EXPECT_EQ(found(sheet, "refused 123"), (Rows{}));
  EXPECT_EQ(found(sheet, "cause over"), (Rows{1}));
}

TEST(Sheet, ComparisonsTakeNumbersAndNeverWhatIsNotKnown) {
  const Sheet sheet = smallSheet();
  EXPECT_EQ(found(sheet, "refused>0"), (Rows{0}));
  EXPECT_EQ(found(sheet, "refused>=0"), (Rows{0, 1}));
  EXPECT_EQ(found(sheet, "refused<1,235"), (Rows{0, 1}));
  EXPECT_EQ(found(sheet, "t<1"), (Rows{1}));
  EXPECT_EQ(found(sheet, "t=4.303"), (Rows{0}));
  EXPECT_EQ(found(sheet, "t<=12 refused>5"), (Rows{0}));
}

TEST(Sheet, TheAreaFiltersBeforeTheSearchAndBothAreCounted) {
  Sheet sheet = smallSheet();
  sheet.inArea = {0, 1, 1};
  const SheetRows rows = sheetRows(sheet, {}, "gate");
  EXPECT_EQ(rows.inArea, 2u);
  EXPECT_EQ(rows.rows, (Rows{2}));
}

TEST(Sheet, CsvQuotesCommasAndQuotesAndLeavesOutWhatIsNotKnown) {
  EXPECT_EQ(sheetCsv(smallSheet(), Rows{0, 2}),
            "cell,refused,cause,t\r\n\"1,2,3\",1234,\"Gate, \"\"held\"\"\",4.30267\r\n\"1,2,0\",,\"Gate, \"\"held\"\"\",12\r\n");
}

TEST(Sheet, AColumnThatNobodyWorkedOutShowsDashesAndDoesNotSort) {
  Sheet sheet = smallSheet();
  sheet.columns[1].known = false;
  EXPECT_EQ(sheetText(sheet.columns[1], 0), "\u2013");
  EXPECT_EQ(sheetRows(sheet, {1, false}, "").rows, (Rows{0, 1, 2}));
  EXPECT_EQ(found(sheet, "refused>0"), (Rows{}));
}

TEST(Sheet, RowsOfFieldsBecomeCsvWithQuotesWhereAPlaceHasCommas) {
  const std::vector<std::vector<std::string>> rows{{"cell", "rays"}, {"1,2,3", "4"}};
  EXPECT_EQ(csvText(rows), "cell,rays\r\n\"1,2,3\",4\r\n");
}

TEST(Sheet, ACsvFileIsNamedByItsSceneAndTable) {
  EXPECT_EQ(csvName("scenes/sponza.glb", "cells"), "sponza_cells.csv");
  EXPECT_EQ(csvName("hall", "rays"), "hall_rays.csv");
}

}  // namespace
}  // namespace gridscope
