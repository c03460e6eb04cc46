// What a mosaic leaves on disk: nothing before its end, nothing half, and the same bytes each time.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geotiff/terrain_file.hpp"
#include "geotiff/terrain_mosaic.hpp"
#include "io/error.hpp"
#include "io/temporary_folder.hpp"
#include "read_raster.hpp"
#include "small_map.hpp"
#include "support/limited_file_size.hpp"

namespace groundgrid::geotiff {
namespace {

using test::contains;
using test::files_below;
using test::message_of;
using test::Names;
using test::noisy_map;
using test::read_raster;

TEST(TerrainMosaicFile, LeavesNothingWithoutFinish) {
  const test::TemporaryFolder folder;
  {
    TerrainMosaic mosaic(folder / "terrain.tif");
    for (int scan = 0; scan < 4; ++scan) mosaic.add(noisy_map(100, 200.0 * scan, 0.0, 1).view());
    EXPECT_EQ(files_below(folder.path()), Names{}) << "not even while it is made";
  }
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(TerrainMosaicFile, ReplacesAFileOnlyAtTheEnd) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "terrain.tif", "old");
  TerrainMosaic mosaic(folder / "terrain.tif");
  mosaic.add(noisy_map(10, 0.0, 0.0, 1).view());
  EXPECT_EQ(test::read_file(folder / "terrain.tif"), "old");
  mosaic.finish();
  EXPECT_EQ(read_raster(folder / "terrain.tif").columns, 10);
}

TEST(TerrainMosaicFile, GrowsFurtherAfterItWasWritten) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "terrain.tif");
  mosaic.add(noisy_map(10, 0.0, 0.0, 1).view());
  mosaic.finish();
  mosaic.add(noisy_map(10, 2.5, 0.0, 2).view());
  mosaic.finish();
  EXPECT_EQ(read_raster(folder / "terrain.tif").columns, 15);
  EXPECT_EQ(files_below(folder.path()), (Names{"terrain.tif"}));
}

// As two containers on one folder have it, whose processes have the same number.
TEST(TerrainMosaicFile, DoesNotMixWithAnotherOfTheSameNameAtTheSameTime) {
  const test::TemporaryFolder folder;
  const RasterGrid grid{0.0, 0.0, 1.0, 600, 600};
  const auto value = [](float number) {
    TerrainBlock block;
    std::fill_n(block.band(0), TerrainBlock::kSide * TerrainBlock::kSide, number);
    return block;
  };
  TerrainFile one(folder / "a.tif", grid, {});
  TerrainFile other(folder / "a.tif", grid, {});
  for (int row = 0; row < one.block_rows(); ++row)
    for (int column = 0; column < one.block_columns(); ++column) {
      TerrainBlock ones = value(1.0F);
      TerrainBlock twos = value(2.0F);
      one.write(column, row, ones);
      other.write(column, row, twos);
    }
  one.commit();
  EXPECT_EQ(read_raster(folder / "a.tif").bands[0].pixels, std::vector<float>(600 * 600, 1.0F));
  other.commit();
  EXPECT_EQ(read_raster(folder / "a.tif").bands[0].pixels, std::vector<float>(600 * 600, 2.0F));
  EXPECT_EQ(files_below(folder.path()), (Names{"a.tif"}));
}

TEST(TerrainMosaicFile, MayBeMoved) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "a.tif");
  mosaic.add(noisy_map(10, 0.0, 0.0, 1).view());
  TerrainMosaic moved(std::move(mosaic));
  moved.finish();
  EXPECT_EQ(read_raster(folder / "a.tif").columns, 10);
}

TEST(TerrainMosaicFile, SaysAtOnceThatAFolderIsMissing) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(
      contains(message_of<io::Error>([&] { TerrainMosaic mosaic(folder / "none/terrain.tif"); }),
               "none/terrain.tif: expected a place to write to, got No such file"));
}

TEST(TerrainMosaicFile, RefusesAnUnknownReferenceSystemAtOnce) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(contains(message_of<std::invalid_argument>(
                           [&] { TerrainMosaic mosaic(folder / "terrain.tif", "EPSG:999999"); }),
                       "'EPSG:999999'"));
}

TEST(TerrainMosaicFile, AFullDiskIsNoticedWhenTilesAreSetAside) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "terrain.tif");
  mosaic.add(noisy_map(200, 0.0, 0.0, 1).view());
  const test::LimitedFileSize limit(500'000);
  EXPECT_TRUE(
      contains(message_of<io::Error>([&] { mosaic.add(noisy_map(200, 500.0, 0.0, 2).view()); }),
               "terrain.tif: expected a place to write to, got File too large"));
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(TerrainMosaicFile, AFullDiskAtTheEndLeavesTheOldFile) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "terrain.tif", "old");
  TerrainMosaic mosaic(folder / "terrain.tif");
  mosaic.add(noisy_map(200, 0.0, 0.0, 1).view());
  {
    const test::LimitedFileSize limit(100'000);
    EXPECT_THROW(mosaic.finish(), io::Error);
  }
  EXPECT_EQ(test::read_file(folder / "terrain.tif"), "old");
  EXPECT_EQ(files_below(folder.path()), (Names{"terrain.tif"}));
}

TEST(TerrainMosaicFile, TwoRunsWriteTheSameBytes) {
  const test::TemporaryFolder folder;
  for (const char* const name : {"a.tif", "b.tif"}) {
    TerrainMosaic mosaic(folder / name, "EPSG:32632");
    for (unsigned scan = 0; scan < 6; ++scan)
      mosaic.add(noisy_map(150, 40.0 * scan, 25.0 * (scan % 3), scan).view());
    mosaic.finish();
  }
  EXPECT_TRUE(test::read_file(folder / "a.tif") == test::read_file(folder / "b.tif"));
}

}  // namespace
}  // namespace groundgrid::geotiff
