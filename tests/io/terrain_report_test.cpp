#include "evaluation/terrain_report.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "temporary_folder.hpp"

namespace groundgrid::evaluation {
namespace {

using test::contains;

TerrainReport small_report() {
  TerrainReport report{
      .map = "map.tif", .reference = "reference.tif", .lattice = {4, 3, 0.5, 0.25}};
  TerrainFigures& figures = report.figures;
  figures.without_reference = 2;
  figures.offset = {.median_m = -0.125, .cells = 3, .of_dense = true};
  figures.all = terrain_errors(10, {0.25, 0.25, -0.5});
  figures.by_slope = {{.from = 0.0, .to = 5.0, .errors = terrain_errors(4, {0.25})},
                      {.from = 5.0, .to = std::numeric_limits<double>::infinity()}};
  return report;
}

TerrainReport whole_report() {
  TerrainReport report = small_report();
  TerrainFigures& figures = report.figures;
  figures.offset.taken_out = true;
  figures.by_density = ErrorsByDensity{.dense = terrain_errors(4, {0.5, 0.5})};
  figures.paper = terrain_errors(123'456'789, {1234.5});
  figures.by_path_distance = {{.from = 0.0, .to = 5.0, .errors = terrain_errors(1, {})}};
  figures.by_mask = {{.name = "kerb", .errors = terrain_errors(2, {0.0, 0.125})}};
  report.remarks = {"the reference has no CRS"};
  return report;
}

TEST(TerrainReport, PrintsATable) {
  const std::string table = to_table(whole_report());
  for (
      const char* part :
      {"map.tif\nagainst reference.tif\n! the reference has no CRS\n"
       "4 x 3 cells of 0.5 m x 0.25 m; 2 have a height but no reference.\n"
       "Vertical offset -0.125 m, the median of 3 dense cells; taken out of all figures.\n",
       "\ndense                                 4          2      50.00    0.500    0.500   +0.500 "
       "   0.500\n",
       "\nsparse                                0          0          -        -        -        - "
       "       -\n",
       "\nunseen, seen within 2 m ", "\nunseen, farther ",
       "\nall                                  10          3      30.00    0.354    0.333   +0.000 "
       "   0.500\n",
       "\nthe paper's selection         123456789          1       0.00 1234.500 1234.500 ",
       "\ndistance from the path, m ", "\n0-5 ", "\nslope of the reference, % ", "\n5 and more ",
       "\nkerb "})
    EXPECT_TRUE(contains(table, part));
}

TEST(TerrainReport, FitsAHundredColumns) {
  std::istringstream table(to_table(whole_report()));
  for (std::string line; std::getline(table, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST(TerrainReport, LeavesOutWhatIsNotKnown) {
  const std::string table = to_table(small_report());
  EXPECT_TRUE(contains(table, "left in all figures"));
  for (const char* part : {"\ndense", "unseen", "selection", "path", "mask", "!"})
    EXPECT_EQ(table.find(part), std::string::npos) << part;
}

TEST(TerrainReport, SaysThatNothingCouldBeCompared) {
  TerrainReport report = small_report();
  report.figures.offset = {};
  EXPECT_TRUE(contains(to_table(report), "No cell has both an estimated and a reference height."));
}

TEST(TerrainReport, GivesJson) {
  const auto json = to_json(whole_report());
  EXPECT_EQ(json["map"], "map.tif");
  EXPECT_EQ(json["columns"], 4);
  EXPECT_EQ(json["cell_height_m"], 0.25);
  EXPECT_EQ(json["cells_without_reference"], 2);
  EXPECT_EQ(json["offset"]["median_m"], -0.125);
  EXPECT_EQ(json["offset"]["of"], "dense");
  EXPECT_EQ(json["offset"]["taken_out"], true);
  EXPECT_EQ(json["all"]["cells"], 10);
  EXPECT_EQ(json["all"]["coverage"], 0.3);
  EXPECT_EQ(json["density"]["dense"]["rmse_m"], 0.5);
  EXPECT_EQ(json["density"]["unseen_far"]["cells"], 0);
  EXPECT_EQ(json["paper_selection"]["p95_m"], 1234.5);
  EXPECT_EQ(json["path_distance"][0]["to_m"], 5.0);
  EXPECT_EQ(json["slope"][1]["to_percent"], nullptr);
  EXPECT_EQ(json["masks"][0]["mask"], "kerb");
  EXPECT_EQ(json["remarks"][0], "the reference has no CRS");
  // Figures of nothing.
  EXPECT_TRUE(contains(json["path_distance"][0].dump(), "\"rmse_m\":null"));
}

TEST(TerrainReport, GivesNullForWhatIsNotKnown) {
  const auto json = to_json(small_report());
  EXPECT_EQ(json["density"], nullptr);
  EXPECT_EQ(json["paper_selection"], nullptr);
  EXPECT_EQ(json["path_distance"], nullptr);
  EXPECT_TRUE(json["masks"].empty());
}

}  // namespace
}  // namespace groundgrid::evaluation
