// The window's tables of a small frame: their values, the area filter, and what is not known yet.
#include "app/frame/table_rows.h"

#include <gtest/gtest.h>

#include "app/frame/find_next.h"
#include "app/jobs/table_job.h"
#include "tests/frame/small_frame.h"

namespace gridscope {
namespace {

// The row of an id, as the table shows it.
std::vector<std::string> shown(const Sheet& sheet, uint32_t id) {
  std::vector<std::string> texts;
  for (size_t row = 0; row < sheet.rowCount(); ++row)
    if (sheet.ids[row] == id)
      for (const SheetColumn& column : sheet.columns) texts.push_back(sheetText(column, row));
  return texts;
}

using Texts = std::vector<std::string>;
const std::string kDash = "\u2013";

TEST(TableRows, CellsHaveWhatTheyWereAskedToTake) {
  const SmallFrame small;
  const Sheet sheet = makeSheet(TableKind::cells, small.frame, {});
  const GridParameters& grid = small.frame.parameters.grid;
  const ivec3 full = gridCell(grid, vec3(1.3f, 1.5f, 1.3f));
  const std::string place = std::to_string(full.x) + ", " + std::to_string(full.y) + ", " + std::to_string(full.z);
  EXPECT_EQ(shown(sheet, idOfCell(grid, full)), (Texts{place, "3", "2", "1", "100.0 %", kDash, kDash}));
  EXPECT_EQ(cellOfId(grid, idOfCell(grid, full)), full);
  EXPECT_EQ(sheet.rowCount(), 2u);
}

TEST(TableRows, TrianglesCountTheCellsThatHoldThemAndLossesWaitForTheLedger) {
  SmallFrame small;
  Sheet sheet = makeSheet(TableKind::triangles, small.frame, {});
  EXPECT_EQ(shown(sheet, makeReference(0, 0)), (Texts{"0x00000000", "floor", "0", "0.180", "1", kDash, kDash}));
  EXPECT_EQ(shown(sheet, makeReference(0, 2))[size_t(TriangleColumn::stored)], "0");
  EXPECT_EQ(shown(sheet, makeReference(1, 0))[size_t(TriangleColumn::mesh)], "post");

  Ledger ledger;
  ledger.triangles = {
      {makeReference(0, 0), 1, 0, 0}, {makeReference(0, 1), 1, 0, 0}, {makeReference(0, 2), 0, 1, 7}, {makeReference(1, 0), 1, 0, 0}};
  small.frame.ledger = std::make_shared<const Ledger>(ledger);
  sheet = makeSheet(TableKind::triangles, small.frame, {});
  EXPECT_EQ(shown(sheet, makeReference(0, 2)), (Texts{"0x00000002", "floor", "2", "0.180", "0", "1", kDash}));
  small.tellTruth();
  sheet = makeSheet(TableKind::triangles, small.frame, {});
  EXPECT_EQ(shown(sheet, makeReference(0, 2))[size_t(TriangleColumn::raysLost)], "7");
}

TEST(TableRows, InstancesSumTheirTrianglesAndSayWhatWasDoneToThem) {
  SmallFrame small;
  Sheet sheet = makeSheet(TableKind::instances, small.frame, {});
  EXPECT_EQ(shown(sheet, 0), (Texts{"the floor", "floor", "static", "3", "2", kDash, kDash}));
  EXPECT_EQ(shown(sheet, 1), (Texts{"the post", "post", "static", "1", "1", kDash, kDash}));
  small.frame.request.edits = {{.sceneInstance = 1, .kind = InstanceEdit::Kind::hide}};
  EXPECT_EQ(shown(makeSheet(TableKind::instances, small.frame, {}), 1)[size_t(InstanceColumn::state)], "hidden");
}

TEST(TableRows, RaysLeaveOutPixelsWithoutOneAndMissesHaveNoDistance) {
  SmallFrame small;
  Sheet sheet = makeSheet(TableKind::rays, small.frame, {});
  EXPECT_EQ(sheet.rowCount(), 7u);
  EXPECT_EQ(shown(sheet, 1), (Texts{"1, 0", "triangle hit", "7.000", "1", "10", kDash, kDash}));
  EXPECT_EQ(shown(sheet, 6), (Texts{"2, 1", "miss", kDash, "6", "60", kDash, kDash}));
  small.tellTruth();
  sheet = makeSheet(TableKind::rays, small.frame, {});
  EXPECT_EQ(shown(sheet, 4)[size_t(RayColumn::verdict)], std::string(verdictName(kVerdictVoxelWrong).title));
  EXPECT_EQ(shown(sheet, 4)[size_t(RayColumn::cause)], std::string(causeName(kCauseRefused).title));
  EXPECT_EQ(shown(sheet, 1)[size_t(RayColumn::cause)], kDash);
}

TEST(TableRows, AnAreaMarksItsRaysAndWhatTheyHit) {
  const SmallFrame small;
  const PixelArea area{ivec2(2, 0), ivec2(4, 1)};
  const Sheet rays = makeSheet(TableKind::rays, small.frame, area);
  EXPECT_EQ(sheetRows(rays, {}, "").inArea, 2u);

  const Sheet triangles = makeSheet(TableKind::triangles, small.frame, area);
  SmallFrame withRays;
  withRays.frame.rays = std::make_shared<const std::vector<Ray>>(8, makeRay(vec3(1.3f, 7.5f, 1.3f), vec3(0.0f, -1.0f, 0.0f)));
  const Sheet hitTriangles = makeSheet(TableKind::triangles, withRays.frame, area);
  EXPECT_EQ(sheetRows(triangles, {}, "").inArea, 0u);
  EXPECT_EQ(sheetRows(hitTriangles, {}, "").inArea, 1u);
  EXPECT_EQ(sheetRows(makeSheet(TableKind::instances, withRays.frame, area), {}, "").inArea, 1u);
  EXPECT_EQ(sheetRows(makeSheet(TableKind::cells, withRays.frame, area), {}, "").inArea, 1u);
}

TEST(TableRows, WhileAnotherGridIsOnItsWayTheOldOneKeepsItsShape) {
  SmallFrame small;
  FrameSnapshot coarser = small.frame;
  coarser.parameters.grid.cellCount = ivec3(1);
  const PixelArea area{ivec2(0), ivec2(4, 2)};
  const Sheet before = makeSheet(TableKind::cells, small.frame, area), now = makeSheet(TableKind::cells, coarser, area);
  EXPECT_EQ(now.ids, before.ids);
  EXPECT_EQ(now.inArea, before.inArea);
}

TEST(TableRows, AFrameWithoutProductsMakesEmptyTables) {
  const FrameSnapshot nothing;
  for (const TableKind kind : {TableKind::cells, TableKind::instances, TableKind::triangles, TableKind::rays})
    EXPECT_EQ(makeSheet(kind, nothing, {}).rowCount(), 0u);
}

TEST(TableJob, ShowsTheLastTableUntilTheNextIsDoneAndKeepsTheSheetWhenOnlyTheSearchChanges) {
  SmallFrame small;
  TableJob job;
  TableWish wish{.kind = TableKind::rays, .frame = std::make_shared<const FrameSnapshot>(small.frame)};
  job.want(wish);
  job.finish();
  ASSERT_TRUE(job.result());
  const std::shared_ptr<const Sheet> sheet = job.result()->sheet;
  EXPECT_EQ(job.result()->shown.rows.size(), 7u);

  wish.search = "voxel";
  wish.frame = std::make_shared<const FrameSnapshot>(small.frame);  // a later snapshot of the same pieces
  job.want(wish);
  job.finish();
  EXPECT_EQ(job.result()->shown.rows.size(), 1u);
  EXPECT_EQ(job.result()->sheet, sheet);

  const uint64_t number = job.result()->number;
  job.want(wish);
  EXPECT_FALSE(job.running());
  EXPECT_EQ(job.result()->number, number);
}

}  // namespace
}  // namespace gridscope
