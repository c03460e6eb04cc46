// `groundgrid evaluate-terrain` as users run it. Rasters of other makers, units and systems are
// tested beside their library, the arithmetic beside its own.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../geotiff/small_map.hpp"
#include "geotiff/terrain_raster.hpp"
#include "run_program.hpp"
#include "segment_fixture.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contains;
using test::ProgramRun;
using test::run_program;
using test::shell_word;
using test::SmallMap;

/// A terrain of 20 × 20 cells of 0.33 m, 30 points in each of the western half, 1 in the cells of
/// the column beside it, none farther east; and its reference, 0.25 m higher.
class EvaluateTerrain : public ::testing::Test {
 protected:
  EvaluateTerrain() {
    SmallMap terrain(20, 0.33);
    for (int row = 0; row < 20; ++row)
      for (int column = 0; column < 20; ++column)
        terrain.set(column, row, 5.0F, 1.0F, column < 10 ? 30 : (column == 10 ? 1 : 0));
    geotiff::write_terrain(map, terrain.view());
    write(reference, [](int, int) { return 5.25F; });
  }

  void write(const fs::path& path, const std::function<float(int column, int row)>& height,
             const std::string& crs = "", double min_x_m = 0.0) const {
    SmallMap raster(20, 0.33);
    raster.min_x_m = min_x_m;
    for (int row = 0; row < 20; ++row)
      for (int column = 0; column < 20; ++column)
        raster.set(column, row, height(column, row), 1.0F);
    geotiff::write_terrain(path, raster.view(), crs);
  }
  [[nodiscard]] ProgramRun evaluate(const std::string& more = "") const {
    return run_program("evaluate-terrain " + more + " " + shell_word(map) + " " +
                       shell_word(reference));
  }
  [[nodiscard]] json figures(const std::string& more = "") const {
    const ProgramRun run = evaluate("--json " + more);
    EXPECT_EQ(run.exit_code, 0) << run.words;
    return json::parse(run.output);
  }

  test::TemporaryFolder folder;
  fs::path map = folder / "terrain.tif";
  fs::path reference = folder / "reference.tif";
};

TEST_F(EvaluateTerrain, PrintsATable) {
  const ProgramRun run = evaluate();
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(run.words, "");
  EXPECT_TRUE(contains(run.output, "20 x 20 cells of 0.33 m x 0.33 m; 0 have a height but no "));
  EXPECT_TRUE(
      contains(run.output, "Vertical offset -0.250 m, the median of 220 dense cells; left"));
  EXPECT_TRUE(contains(run.output,
                       "\nall                                 400        400     100.00 "
                       "   0.250    0.250   -0.250    0.250\n"));
  EXPECT_TRUE(contains(run.output, "\nstandard deviation "));
  EXPECT_TRUE(contains(run.output, "\n0-5 "));
  EXPECT_EQ(run.output.find("distance from the path"), std::string::npos);
  std::istringstream lines(run.output.substr(run.output.find("\n\n")));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST_F(EvaluateTerrain, PrintsJson) {
  const json result = figures();
  EXPECT_EQ(result["program"], "groundgrid");
  EXPECT_EQ(result["command"], "evaluate-terrain");
  EXPECT_EQ(result["map"], map.string());
  // The squares of column 10 hold 60 points or more of column 9, those of column 11 three at most.
  EXPECT_EQ(result["density"]["dense"]["cells"], 220);
  EXPECT_EQ(result["density"]["sparse"]["cells"], 20);
  // Six cells are 1.98 m: columns 12 to 17.
  EXPECT_EQ(result["density"]["unseen_near"]["cells"], 120);
  EXPECT_EQ(result["density"]["unseen_far"]["cells"], 40);
  // 27 points per m² are three in a cell.
  EXPECT_EQ(result["paper_selection"]["cells"], 200);
  EXPECT_NEAR(result["all"]["rmse_m"].get<double>(), 0.25, 1e-6);
  // Every height has a deviation, most of them far less than the quarter of a metre it is off.
  EXPECT_EQ(result["standard_deviation"]["all"]["cells"], 400);
  EXPECT_LT(result["standard_deviation"]["dense"]["within_two"].get<double>(), 0.25);
  EXPECT_LT(result["standard_deviation"]["dense"]["median_m"].get<double>(), 0.1);
  EXPECT_TRUE(result["remarks"].empty());
}

TEST_F(EvaluateTerrain, TakesTheOffsetOut) {
  const json result = figures("--solve-offset");
  EXPECT_NEAR(result["offset"]["median_m"].get<double>(), -0.25, 1e-6);
  EXPECT_EQ(result["offset"]["taken_out"], true);
  EXPECT_NEAR(result["all"]["rmse_m"].get<double>(), 0.0, 1e-6);
}

TEST_F(EvaluateTerrain, TakesMasks) {
  write(folder / "kerb.tif", [](int column, int) { return column == 3 ? 1.0F : 0.0F; });
  write(folder / "trees.tif", [](int, int row) { return row < 2 ? 1.0F : 0.0F; });
  const json result = figures("--mask kerb=" + shell_word(folder / "kerb.tif") +
                              " --mask trees=" + shell_word(folder / "trees.tif"));
  ASSERT_EQ(result["masks"].size(), 2U);
  EXPECT_EQ(result["masks"][0]["mask"], "kerb");
  EXPECT_EQ(result["masks"][0]["cells"], 20);
  EXPECT_EQ(result["masks"][1]["cells"], 40);
}

TEST_F(EvaluateTerrain, TakesAPath) {
  // North along column 0.
  test::write_file(folder / "poses.txt", "0 0.1 0.1 0 0 0 0 1\n1 0.1 6.5 0 0 0 0 1\n");
  const json bins = figures("--path " + shell_word(folder / "poses.txt"))["path_distance"];
  ASSERT_EQ(bins.size(), 5U);
  // Cell 16 is 5.28 m away, cell 15 is 4.95 m.
  EXPECT_EQ(bins[0]["cells"], 16 * 20);
  EXPECT_EQ(bins[1]["cells"], 4 * 20);
}

TEST_F(EvaluateTerrain, TakesThePathOfACamera) {
  // The camera's z is the LiDAR's x, its -x the LiDAR's y: along the southern row.
  test::write_file(folder / "calib.txt", "Tr: 0 -1 0 0 0 0 -1 0 1 0 0 0\n");
  test::write_file(folder / "poses.txt",
                   "1 0 0 -0.1 0 1 0 0 0 0 1 0.1\n1 0 0 -0.1 0 1 0 0 0 0 1 6.5\n");
  const json bins = figures("--path " + shell_word(folder / "poses.txt") + " --calibration " +
                            shell_word(folder / "calib.txt"))["path_distance"];
  EXPECT_EQ(bins[0]["cells"], 16 * 20);
}

TEST_F(EvaluateTerrain, RefusesAPathThatIsElsewhere) {
  test::write_file(folder / "poses.txt", "0 500 0 0 0 0 0 1\n");
  const ProgramRun run = evaluate("--path " + shell_word(folder / "poses.txt"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words,
                       "expected poses on the terrain, got none there; the first is at "
                       "x 500.0, y 0.0; give them in the frame of the terrain"));
  test::write_file(folder / "poses.txt", "0 500 0\n");
  EXPECT_TRUE(contains(evaluate("--path " + shell_word(folder / "poses.txt")).words,
                       "mend the file, or leave --path out"));
}

TEST_F(EvaluateTerrain, TakesGroupsFromAnotherTerrain) {
  // A height raster of another method, one cell to the east of ours: no groups of its own.
  const fs::path other = folder / "other.tif";
  SmallMap heights(20, 0.33);
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 20; ++column) heights.set(column, row, 5.75F, 1.0F);
  heights.min_x_m = 0.33;
  geotiff::write_terrain(other, heights.view());
  const ProgramRun run = run_program("evaluate-terrain --json --groups " + shell_word(map) + " " +
                                     shell_word(other) + " " + shell_word(reference));
  ASSERT_EQ(run.exit_code, 0) << run.words;
  const json result = json::parse(run.output);
  EXPECT_EQ(result["density"]["dense"]["cells"], 220);
  EXPECT_EQ(result["density"]["dense"]["covered"], 200) << "not the westernmost column";
  EXPECT_NEAR(result["density"]["dense"]["bias_m"].get<double>(), 0.5, 1e-6);
}

TEST_F(EvaluateTerrain, WarnsOfAReferenceWithoutASystem) {
  SmallMap terrain(20, 0.33);
  terrain.set(3, 3, 5.0F, 1.0F, 9);
  geotiff::write_terrain(map, terrain.view(), "EPSG:32632");
  const ProgramRun run = evaluate();
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.output, "\n! " + reference.string() + " names no reference system"));
  EXPECT_EQ(figures()["remarks"].size(), 1U);
}

TEST_F(EvaluateTerrain, SaysThatTheRastersDoNotMeet) {
  write(
      reference, [](int, int) { return 5.0F; }, "", 5000.0);
  const ProgramRun run = evaluate();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_TRUE(contains(run.words, "x 0.0 to 6.6"));
  EXPECT_TRUE(contains(run.words, "x 5000.0 to 5006.6"));
}

TEST_F(EvaluateTerrain, FailsWhereAFileIsMissing) {
  fs::remove(reference);
  const ProgramRun run = evaluate();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "reference.tif: expected a GeoTIFF, got no file of that name"));
}

TEST_F(EvaluateTerrain, RefusesWhatItDoesNotUnderstand) {
  EXPECT_EQ(run_program("evaluate-terrain " + shell_word(map)).exit_code, 2);
  EXPECT_EQ(evaluate("--reference-unit fathom").exit_code, 2);
  EXPECT_EQ(evaluate("--calibration calib.txt").exit_code, 2);
  for (const char* mask : {"kerb", "=kerb.tif", "kerb="}) {
    const ProgramRun run = evaluate(std::string("--mask ") + mask);
    EXPECT_EQ(run.exit_code, 2) << mask;
    EXPECT_TRUE(contains(run.words, "--mask: expected NAME=FILE.tif"));
  }
}

TEST_F(EvaluateTerrain, TakesTheUnitOfTheReference) {
  write(reference, [](int, int) { return 5.0F / 0.3048F; });
  const json result = figures("--reference-unit ft");
  EXPECT_NEAR(result["all"]["rmse_m"].get<double>(), 0.0, 1e-5);
}

class EvaluateSegmentedTerrain : public test::Segment {};

TEST_F(EvaluateSegmentedTerrain, IsThatOfTheStreet) {
  // The street is level, 1.73 m below the LiDAR.
  dataset.add_sequence("00", 3);
  ASSERT_EQ(segment("--terrain").exit_code, 0);
  SmallMap street(2, 200.0);
  street.min_x_m = street.min_y_m = -200.0;
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) street.set(column, row, -1.73F, 1.0F);
  geotiff::write_terrain(folder / "street.tif", street.view());
  const fs::path sequence = dataset.path() / "sequences/00";
  const ProgramRun run = run_program(
      "evaluate-terrain --json " + shell_word(output() / "sequences/00/terrain.tif") + " " +
      shell_word(folder / "street.tif") + " --path " + shell_word(sequence / "poses.txt") +
      " --calibration " + shell_word(sequence / "calib.txt"));
  ASSERT_EQ(run.exit_code, 0) << run.words;
  const auto result = json::parse(run.output);
  EXPECT_GT(result["density"]["dense"]["cells"].get<int>(), 100);
  EXPECT_LT(result["density"]["dense"]["rmse_m"].get<double>(), 0.05);
  EXPECT_GT(result["density"]["sparse"]["cells"].get<int>(), 1000);
  EXPECT_GT(result["path_distance"][0]["covered"].get<int>(), 100);
  // Where points fell without ground there are cells without a height.
  EXPECT_LT(result["all"]["coverage"].get<double>(), 1.0);
}

}  // namespace
}  // namespace groundgrid::program
