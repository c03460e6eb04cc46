// `groundgrid segment --terrain`; what is in the rasters is tested beside their library.
#include <algorithm>
#include <cmath>

#include "geotiff/height_raster.hpp"
#include "segment_fixture.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::files_below;
using test::Names;
using test::ProgramRun;
using test::read_file;
using test::Segment;

TEST_F(Segment, WritesTheTerrainOfADrive) {
  dataset.add_sequence("00", 2);
  dataset.add_sequence("01", 1);
  const ProgramRun run = segment("--terrain");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(
      files_below(output()),
      (Names{"run.json", "sequences/00/predictions/000000.label",
             "sequences/00/predictions/000001.label", "sequences/00/terrain.tif",
             "sequences/01/predictions/000000.label", "sequences/01/terrain.tif", "timing.csv"}));
  EXPECT_EQ(read_file(output() / "sequences/00/terrain.tif").substr(0, 2), "II");
  EXPECT_EQ(record()["sequences"][1]["terrain"], "sequences/01/terrain.tif");
}

TEST_F(Segment, WritesNoTerrainUnasked) {
  dataset.add_sequence("00", 1);
  ASSERT_EQ(segment().exit_code, 0);
  EXPECT_FALSE(fs::exists(output() / "sequences/00/terrain.tif"));
  EXPECT_EQ(record()["sequences"][0]["terrain"], nullptr);
}

TEST_F(Segment, WritesATerrainForEachSingleScan) {
  dataset.add_sequence("00", 2);
  ASSERT_EQ(segment("--terrain --single-scan").exit_code, 0);
  EXPECT_TRUE(fs::exists(output() / "sequences/00/terrain/000000.tif"));
  EXPECT_TRUE(fs::exists(output() / "sequences/00/terrain/000001.tif"));
  EXPECT_FALSE(fs::exists(output() / "sequences/00/terrain.tif"));
}

TEST_F(Segment, WritesTheLayersBesideTheTerrain) {
  dataset.add_sequence("00", 2);
  ASSERT_EQ(segment("--terrain --terrain-layers --drive-step-m 0.05").exit_code, 0);
  EXPECT_TRUE(fs::exists(output() / "sequences/00/terrain.tif"));
  EXPECT_TRUE(fs::exists(output() / "sequences/00/terrain_layers.tif"));
  ASSERT_EQ(segment("--terrain --terrain-layers --single-scan").exit_code, 0);
  EXPECT_TRUE(fs::exists(output() / "sequences/00/terrain/000001_layers.tif"));
  EXPECT_EQ(segment("--terrain-layers").exit_code, 2);
  EXPECT_EQ(segment("--terrain --drive-step-m 0.05").exit_code, 2);
  EXPECT_EQ(segment("--terrain --terrain-layers --drive-step-m -1").exit_code, 2);
}

std::ptrdiff_t cells_with_a_height(const fs::path& raster) {
  const std::vector<float> heights = geotiff::read_height_raster(raster).heights_m;
  return std::count_if(heights.begin(), heights.end(),
                       [](float height) { return !std::isnan(height); });
}

TEST_F(Segment, FillsTheGapsOfTheTerrainUnlessAskedNotTo) {
  dataset.add_sequence("00", 2);
  const fs::path raster = output() / "sequences/00/terrain.tif";
  ASSERT_EQ(segment("--terrain --terrain-as-seen").exit_code, 0);
  const std::ptrdiff_t seen = cells_with_a_height(raster);
  ASSERT_EQ(segment("--terrain").exit_code, 0);
  EXPECT_GT(cells_with_a_height(raster), seen);
  EXPECT_EQ(segment("--terrain-as-seen").exit_code, 2);
}

TEST_F(Segment, TheTerrainDoesNotChangeTheLabels) {
  dataset.add_sequence("00", 3);
  const fs::path file = output() / "sequences/00/predictions/000002.label";
  ASSERT_EQ(segment().exit_code, 0);
  const std::string labels = read_file(file);
  ASSERT_EQ(segment("--terrain").exit_code, 0);
  EXPECT_EQ(read_file(file), labels);
}

TEST_F(Segment, AFarOriginDoesNotChangeTheLabels) {
  dataset.add_sequence("00", 3);
  const fs::path file = output() / "sequences/00/predictions/000002.label";
  ASSERT_EQ(segment().exit_code, 0);
  const std::string labels = read_file(file);
  const ProgramRun run = segment("--terrain --crs EPSG:32632 --origin 456789,5432100,117");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(read_file(file), labels);
}

TEST_F(Segment, RefusesACrsThatDoesNotExist) {
  dataset.add_sequence("00", 1);
  const ProgramRun run = segment("--terrain --crs EPSG:99999999");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(run.words, "EPSG:99999999"));
  EXPECT_FALSE(fs::exists(output()));
}

TEST_F(Segment, TerrainFlagsNeedEachOther) {
  dataset.add_sequence("00", 1);
  EXPECT_EQ(segment("--crs EPSG:32632").exit_code, 2);
  EXPECT_EQ(segment("--origin 1,2,3").exit_code, 2);
  EXPECT_EQ(segment("--terrain --heading-deg 90").exit_code, 2);
  EXPECT_EQ(segment("--terrain --origin 1,2").exit_code, 2);
  EXPECT_EQ(segment("--terrain --origin 1,2,inf").exit_code, 2);
}

TEST_F(Segment, DoesWithoutTerrainWhereNoScanShowsGround) {
  dataset.add_sequence("00", 1);
  dataset.add_sequence("01", 1);
  test::write_numbers(dataset.scan_file("00", 0), std::vector<float>(400, std::nanf("")));
  const ProgramRun run = segment("--terrain");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.words, "not written, since no scan showed any ground"));
  EXPECT_EQ(record()["sequences"][0]["terrain"], nullptr);
  EXPECT_EQ(record()["sequences"][1]["terrain"], "sequences/01/terrain.tif");
}

// So far away that the raster between would fill the disk.
TEST_F(Segment, KeepsTheLabelsWhereTheTerrainIsTooLargeIfAskedTo) {
  dataset.add_sequence("00", 2);
  test::write_file(dataset.folder / "sequences/00/poses.txt",
                   "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 1e8\n");
  EXPECT_EQ(segment("--terrain").exit_code, 1);
  const ProgramRun run = segment("--terrain --keep-going");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(record()["counts"]["scans"], 2);
  EXPECT_EQ(record()["sequences"][0]["terrain"], nullptr);
}

TEST_F(Segment, AFailedRunLeavesNoTerrain) {
  dataset.add_sequence("00", 3);
  fs::resize_file(dataset.scan_file("00", 2), 100);
  EXPECT_EQ(segment("--terrain").exit_code, 1);
  EXPECT_EQ(files_below(output()), (Names{"sequences/00/predictions/000000.label",
                                          "sequences/00/predictions/000001.label", "timing.csv"}));
}

}  // namespace
}  // namespace groundgrid::program
