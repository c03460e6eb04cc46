#include "geotiff/layers_mosaic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "geotiff/terrain_raster.hpp"
#include "io/error.hpp"
#include "io/temporary_folder.hpp"
#include "read_raster.hpp"
#include "small_map.hpp"
#include "support/limited_file_size.hpp"

namespace groundgrid::geotiff {
namespace {

using test::read_raster;
using test::SmallMap;

class LayersOfADrive : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(path_.parent_path()); }
  void TearDown() override { std::filesystem::remove_all(path_.parent_path()); }

  static void add(LayersMosaic& mosaic, const SmallMap& map) {
    TerrainLayers layers(1.5);  // three cells of half a metre
    layers.update(map.view());
    mosaic.add(map.view(), layers);
  }

  std::filesystem::path path_ = std::filesystem::path(::testing::TempDir()) /
                                ::testing::UnitTest::GetInstance()->current_test_info()->name() /
                                "layers.tif";
};

/// Every cell known and flat; a slope of 1 where asked for.
SmallMap known_map(int size, double slope, float confidence) {
  SmallMap map(size);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      map.set(column, row, static_cast<float>(0.5 * slope * column), confidence);
  return map;
}

void set_highest(SmallMap& map, int column, int row, double height) {
  CellStatistics& points = map.statistics[static_cast<std::size_t>(row * map.size + column)];
  points.count = 1;
  points.min = points.max =
      static_cast<std::int32_t>(std::lround(height / CellStatistics::kStep_m));
}

TEST_F(LayersOfADrive, LeaveTheOldFileWhereTheDiskIsFull) {
  test::write_file(path_, "old");
  LayersMosaic mosaic(path_, {});
  add(mosaic, known_map(9, 1.0, 1.0F));
  {
    const test::LimitedFileSize limit(100);
    EXPECT_THROW(mosaic.finish(), io::Error);
  }
  EXPECT_EQ(test::read_file(path_), "old");
  EXPECT_EQ(test::files_below(path_.parent_path()), (test::Names{"layers.tif"}));
}

TEST_F(LayersOfADrive, HaveNamedBandsInTheirPlace) {
  SmallMap map = known_map(9, 1.0, 1.0F);
  map.min_x_m = 100.0;
  map.min_y_m = 50.0;
  set_highest(map, 2, 1, 2.0);  // 1 m above its cell
  LayersMosaic mosaic(path_, {});
  EXPECT_TRUE(mosaic.empty());
  add(mosaic, map);
  EXPECT_FALSE(mosaic.empty());
  mosaic.finish();
  const test::Raster raster = read_raster(path_);
  ASSERT_EQ(raster.bands.size(), 5U);
  EXPECT_EQ(raster.bands[0].name, "slope");
  EXPECT_EQ(raster.bands[0].unit, "deg");
  EXPECT_EQ(raster.bands[1].name, "step");
  EXPECT_EQ(raster.bands[2].name, "roughness");
  EXPECT_EQ(raster.bands[3].name, "obstacle_height");
  EXPECT_EQ(raster.bands[4].name, "traversability");
  EXPECT_EQ(raster.columns, 9);
  EXPECT_EQ(raster.transform[0], 100.0);
  EXPECT_EQ(raster.transform[3], 54.5);
  // Row 1 of the map is the raster's row 7 from the north.
  EXPECT_NEAR(raster.at(1, 2, 7), 45.0F, 1e-4F);
  EXPECT_NEAR(raster.at(2, 2, 7), 0.0F, 1e-5F);
  EXPECT_NEAR(raster.at(4, 2, 7), 1.0F, 1e-4F);
  EXPECT_EQ(raster.at(5, 2, 7), 0.0F);
  EXPECT_EQ(raster.at(4, 4, 4), kNoData);
  EXPECT_EQ(raster.at(5, 4, 4), 0.0F);  // too steep
}

TEST_F(LayersOfADrive, KeepTheGroundOfTheGreatestConfidenceAndTheLastObstacle) {
  SmallMap sure = known_map(9, 0.0, 0.9F);
  set_highest(sure, 4, 4, 1.5);  // a car that drives off
  SmallMap unsure = known_map(9, 1.0, 0.5F);
  set_highest(unsure, 4, 4, 2.0);  // its ground, at 2 m in this map
  LayersMosaic mosaic(path_, {});
  add(mosaic, sure);
  add(mosaic, unsure);
  mosaic.finish();
  const test::Raster raster = read_raster(path_);
  EXPECT_NEAR(raster.at(1, 4, 4), 0.0F, 1e-4F);
  EXPECT_EQ(raster.at(4, 4, 4), 0.0F);
  EXPECT_EQ(raster.at(5, 4, 4), 1.0F);
}

TEST_F(LayersOfADrive, OfALongDriveComeBackFromDisk) {
  LayersMosaic mosaic(path_, {});
  // Ten windows of 64 cells, 100 cells apart: the first ones are far behind at the end.
  for (int i = 0; i < 10; ++i) {
    SmallMap map = known_map(64, 0.1 * i, 1.0F);
    map.min_x_m = 50.0 * i;
    add(mosaic, map);
  }
  mosaic.finish();
  const test::Raster raster = read_raster(path_);
  EXPECT_EQ(raster.columns, 964);
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(raster.at(1, 100 * i + 32, 32), std::atan(0.1 * i) * 180.0 / 3.14159265358979, 1e-3)
        << i;
  EXPECT_EQ(raster.at(1, 80, 32), kNoData);
}

TEST_F(LayersOfADrive, RefuseWhatDoesNotFit) {
  LayersMosaic mosaic(path_, {});
  EXPECT_THROW(mosaic.finish(), io::Error);
  const SmallMap map = known_map(9, 0.0, 1.0F);
  EXPECT_THROW(mosaic.add(map.view(), TerrainLayers()), std::invalid_argument);
  EXPECT_THROW(LayersMosaic(path_, {.max_step_m = -1.0}), std::invalid_argument);
  EXPECT_THROW(LayersMosaic(path_.parent_path() / "none" / "a.tif", {}), io::Error);
  EXPECT_FALSE(std::filesystem::exists(path_));
}

}  // namespace
}  // namespace groundgrid::geotiff
