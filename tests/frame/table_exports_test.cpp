// The CSV rows of the tables that are no sheets.
#include "app/frame/table_exports.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/model/exports.h"
#include "app/model/window_model.h"

namespace gridscope {
namespace {

TEST(TableExports, CausesComeWithTheirProofsOnceThereAreAny) {
  TruthTotals totals{.rays = 10, .agreeHit = 6};
  totals.verdicts[kVerdictHole] = 4;
  totals.causes[kCauseRefused] = 3, totals.causes[kCauseGate] = 1;
  const CsvRows without = causeRows(totals, nullptr);
  ASSERT_EQ(without.size(), 3u);
  EXPECT_EQ(without[1][0], "refused");
  EXPECT_EQ(without[1][1], "3");
  EXPECT_EQ(without[1][2], "75");
  EXPECT_EQ(without[1][4], "");
  ProofTotals proofs;
  proofs.causes[kCauseRefused] = {.alone = 2, .chain = 1, .total = 3, .controlConfirmed = 0, .controlTotal = 3};
  EXPECT_EQ(causeRows(totals, &proofs)[1][4], "2");
  for (const auto& row : without) EXPECT_EQ(row.size(), without[0].size());
}

TEST(TableExports, MeshesAndCellsThatCostRaysComeTheWorstFirst) {
  Ledger ledger;
  ledger.meshes = {{.index = 0, .stored = 5, .lost = 1, .rays = 2}, {.index = 1, .stored = 9, .lost = 4, .rays = 7}, {.index = 2}};
  ledger.cells = {{.cell = ivec3(1, 2, 3), .tried = 4, .stored = 2, .refused = 2, .rays = 1},
                  {.cell = ivec3(0), .tried = 9, .stored = 2, .refused = 7, .rays = 5}};
  const CsvRows meshes = meshRows(ledger, {.scene = "test", .meshes = {"wall"}, .instances = {}, .materials = {}});
  ASSERT_EQ(meshes.size(), 3u);
  EXPECT_EQ(meshes[1][0], "mesh 1");
  EXPECT_EQ(meshes[2][0], "wall");
  EXPECT_EQ(costlyCellRows(ledger)[1], (std::vector<std::string>{"0,0,0", "9", "2", "7", "5"}));
}

TEST(TableExports, AFileIsWrittenBesideWhatIsThereAndSaidWithItsRows) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "gridscope_table_exports",
                              before = std::filesystem::current_path();
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
  std::ofstream("scene_causes.csv") << "old";
  WindowModel model;
  exportCsv(model, "causes", {{"cause", "rays"}, {"gate", "1"}, {"refused", "2"}});
  model.files.finish();
  std::filesystem::current_path(before);
  const std::vector<FileJobs::News> news = model.files.takeNews();
  ASSERT_EQ(news.size(), 1u);
  EXPECT_FALSE(news[0].failed) << news[0].text;
  EXPECT_TRUE(news[0].text.starts_with("Exported 2 rows to ")) << news[0].text;
  std::stringstream text;
  text << std::ifstream(folder / "scene_causes_2.csv").rdbuf();
  EXPECT_EQ(text.str(), "cause,rays\r\ngate,1\r\nrefused,2\r\n");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace gridscope
