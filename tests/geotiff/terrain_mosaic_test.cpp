// The mosaic of a drive, read back with GDAL.
#include "geotiff/terrain_mosaic.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "io/error.hpp"
#include "io/temporary_folder.hpp"
#include "read_raster.hpp"
#include "small_map.hpp"

namespace groundgrid::geotiff {
namespace {

using test::contains;
using test::files_below;
using test::message_of;
using test::Names;
using test::noisy_map;
using test::Raster;
using test::read_raster;
using test::SmallMap;

constexpr float kHighestCount = 4294967296.0F;  // 2³², the float nearest to 2³² - 1

/// What a mosaic of these maps is, with no-data around the cells that are known.
Raster mosaic_of(const std::vector<SmallMap>& maps, const std::string& crs = {}) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "terrain.tif", crs);
  for (const SmallMap& map : maps) mosaic.add(map.view());
  mosaic.finish();
  EXPECT_EQ(files_below(folder.path()), (Names{"terrain.tif"}));
  return read_raster(folder / "terrain.tif");
}

TEST(TerrainMosaic, WeighsHeightsByConfidenceWhereWindowsOverlap) {
  // Two windows of 2 × 2 cells; the second lies one cell to the east and has another z origin.
  SmallMap first(2);
  first.min_x_m = 10.0;
  first.min_y_m = 20.0;
  first.z_origin_m = 100.0;
  first.set(0, 0, 1.0F, 0.5F, 4);
  first.set(1, 0, 2.0F, 0.75F, 5);
  first.set(0, 1, 3.0F, 0.5F, 6);
  first.set(1, 1, 4.0F, 0.0F, 7);
  SmallMap second(2);
  second.min_x_m = 10.5;
  second.min_y_m = 20.0;
  second.z_origin_m = 98.0;
  second.set(0, 0, 6.0F, 0.25F, 8);
  second.set(1, 0, 0.5F, 0.125F, 9);
  second.set(0, 1, 5.0F, 1.0F, 10);
  second.set(1, 1, 0.0F, 0.0F, 11);

  const Raster raster = mosaic_of({first, second});
  EXPECT_EQ(raster.transform, (std::array<double, 6>{10.0, 0.5, 0.0, 21.0, 0.0, -0.5}));
  ASSERT_EQ(raster.columns, 3);
  ASSERT_EQ(raster.rows, 2);
  // (0.75 · 102 + 0.25 · 104) / 1 = 102.5; the north-eastern cell was never known.
  EXPECT_EQ(raster.bands[0].pixels, (std::vector<float>{103.0F, 103.0F, kNoData,  //
                                                        101.0F, 102.5F, 98.5F}));
  EXPECT_EQ(raster.bands[1].pixels, (std::vector<float>{0.5F, 1.0F, kNoData,  //
                                                        0.5F, 0.75F, 0.125F}));
  // Points count also in the scans that did not make the cell known, and where none did.
  EXPECT_EQ(raster.bands[2].pixels, (std::vector<float>{6.0F, 17.0F, 11.0F,  //
                                                        4.0F, 13.0F, 9.0F}));
  // All cells of a window are around each of them: 22 points in the first scan, 38 in the second,
  // on 1.5 m × 1.5 m.
  EXPECT_EQ(raster.bands[3].pixels,
            (std::vector<float>{22.0F / 2.25F, 38.0F / 2.25F, 38.0F / 2.25F,  //
                                22.0F / 2.25F, 38.0F / 2.25F, 38.0F / 2.25F}));
}

TEST(TerrainMosaic, SaysWhatItsBandsAre) {
  const Raster raster = mosaic_of({noisy_map(2, 0.0, 0.0, 1)}, "EPSG:32632");
  ASSERT_EQ(raster.bands.size(), 5U);
  EXPECT_EQ(raster.bands[0].name, "height");
  EXPECT_EQ(raster.bands[1].name, "confidence");
  EXPECT_EQ(raster.bands[2].name, "count");
  EXPECT_EQ(raster.bands[3].name, "density");
  EXPECT_EQ(raster.bands[4].name, "standard deviation");
  for (const Raster::Band& band : raster.bands) EXPECT_EQ(band.no_data, -9999.0);
  EXPECT_EQ(raster.epsg, "EPSG:32632");
}

TEST(TerrainMosaic, CountsStayAtTheirGreatestValue) {
  SmallMap map(1);
  map.set(0, 0, 0.0F, 1.0F, 3'000'000'000U);
  EXPECT_EQ(mosaic_of({map, map}).at(3, 0, 0), kHighestCount);
}

TEST(TerrainMosaic, KeepsMillimetresOverManyScansFarFromTheOrigin) {
  SmallMap map(1);
  map.min_x_m = 456'789.25;
  map.min_y_m = 5'432'100.5;
  map.z_origin_m = 1000.0;
  map.set(0, 0, 0.125F, 0.3F, 1);
  const Raster raster = mosaic_of(std::vector<SmallMap>(10'000, map));
  EXPECT_EQ(raster.at(1, 0, 0), 1000.125F);
  EXPECT_EQ(raster.transform,
            (std::array<double, 6>{456'789.25, 0.5, 0.0, 5'432'101.0, 0.0, -0.5}));
}

TEST(TerrainMosaic, TheDensityIsTheGreatestOfOneScan) {
  // 0.33 m cells, so that 3 × 3 of them are 0.9801 m².
  SmallMap map(5, 0.33);
  map.set(2, 2, 0.0F, 1.0F, 20);
  map.set(3, 2, 0.0F, 1.0F, 6);
  SmallMap later(5, 0.33);
  later.set(2, 2, 0.0F, 1.0F, 15);
  later.set(4, 4, 0.0F, 1.0F, 7);
  const Raster raster = mosaic_of({map, later});
  // Cropped to columns 1 to 4 and rows 1 to 4.
  ASSERT_EQ(raster.columns, 4);
  ASSERT_EQ(raster.rows, 4);
  const auto points = [&](int column, int row) {
    return raster.at(4, column - 1, 4 - row) * 0.9801F;
  };
  EXPECT_FLOAT_EQ(points(2, 2), 26.0F) << "26, then 15: never the sum of both scans";
  EXPECT_FLOAT_EQ(points(1, 2), 20.0F);
  EXPECT_FLOAT_EQ(points(4, 2), 6.0F);
  EXPECT_FLOAT_EQ(points(3, 3), 26.0F) << "26, then 22";
  EXPECT_FLOAT_EQ(points(4, 4), 7.0F);
  EXPECT_EQ(raster.at(4, 0, 0), kNoData) << "no point within its square";
  EXPECT_EQ(raster.at(3, 3 - 1, 4 - 3), 0.0F) << "points only around it";
}

TEST(TerrainMosaic, TellsOfPointsWhereNoScanShowedGround) {
  SmallMap map(7, 0.33);
  map.set(1, 1, 2.5F, 0.5F);
  map.set(5, 5, 9.0F, 0.0F, 4);
  const Raster raster = mosaic_of({map});
  // Row and column 1 to 6: the square around the points reaches one cell farther than they do.
  ASSERT_EQ(raster.columns, 6);
  ASSERT_EQ(raster.rows, 6);
  for (const int band : {1, 2}) EXPECT_EQ(raster.at(band, 4, 1), kNoData);
  EXPECT_EQ(raster.at(3, 4, 1), 4.0F);
  EXPECT_FLOAT_EQ(raster.at(4, 4, 1), 4.0F / 0.9801F);
  // The height of the cell without points is known from a scan that has passed.
  EXPECT_EQ(raster.at(1, 0, 5), 2.5F);
  EXPECT_EQ(raster.at(3, 0, 5), 0.0F);
  EXPECT_EQ(raster.at(4, 0, 5), 0.0F);
  for (const int band : {1, 2, 3, 4}) EXPECT_EQ(raster.at(band, 2, 3), kNoData);
}

TEST(TerrainMosaic, IsCroppedToWhatWasSeen) {
  SmallMap map(300);
  map.min_x_m = -75.0;
  map.min_y_m = -50.0;
  map.set(17, 40, 1.0F, 0.5F, 1);
  map.set(130, 290, 2.0F, 0.5F, 2);
  map.set(280, 33, 3.0F, 0.5F, 3);
  const Raster raster = mosaic_of({map});
  // Columns 16 to 281 and rows 32 to 291: the squares of the outermost points.
  ASSERT_EQ(raster.columns, 266);
  ASSERT_EQ(raster.rows, 260);
  EXPECT_EQ(raster.transform,
            (std::array<double, 6>{-75.0 + 8.0, 0.5, 0.0, -50.0 + 146.0, 0.0, -0.5}));
  EXPECT_EQ(raster.at(1, 17 - 16, 291 - 40), 1.0F);
  EXPECT_EQ(raster.at(1, 130 - 16, 291 - 290), 2.0F);
  EXPECT_EQ(raster.at(1, 280 - 16, 291 - 33), 3.0F);
  std::size_t known = 0;
  for (const float height : raster.bands[0].pixels) known += height == kNoData ? 0U : 1U;
  EXPECT_EQ(known, 3U);
}

TEST(TerrainMosaic, TilesAndBlocksFitTogether) {
  // Neither the tiles of the lattice nor the blocks of the file begin where the other do.
  const SmallMap first = noisy_map(400, -31.5, -77.0, 1);
  SmallMap second = noisy_map(400, -31.5 - 100.0, -77.0 - 150.0, 2);
  for (int row = 300; row < 400; ++row)
    for (int column = 200; column < 400; ++column) second.set(column, row, NAN, 0.0F);
  const Raster raster = mosaic_of({first, second});
  ASSERT_EQ(raster.columns, 600);
  ASSERT_EQ(raster.rows, 700);
  const auto expect_map = [&](const SmallMap& map, int column0, int row0) {
    for (int row = 0; row < map.size; ++row) {
      for (int column = 0; column < map.size; ++column) {
        const auto cell = static_cast<std::size_t>(row * map.size + column);
        if (map.confidence[cell] == 0.0F) continue;
        ASSERT_NEAR(raster.at(1, column0 + column, 699 - row0 - row), map.height[cell], 1e-6)
            << column << ", " << row;
        ASSERT_EQ(raster.at(2, column0 + column, 699 - row0 - row), map.confidence[cell]);
        ASSERT_EQ(raster.at(3, column0 + column, 699 - row0 - row),
                  static_cast<float>(map.statistics[cell].count));
      }
    }
  };
  expect_map(first, 200, 300);
  expect_map(second, 0, 0);
}

TEST(TerrainMosaic, TilesThatLeaveAndComeBackLoseNothing) {
  const SmallMap here = noisy_map(200, 3.5, -8.0, 1);
  const SmallMap again = noisy_map(200, 5.0, -9.5, 2);
  const SmallMap late = noisy_map(200, 6.5, -8.0, 3);
  SmallMap elsewhere(200);
  elsewhere.min_x_m = 3.5 + 400.0;
  const Raster staying = mosaic_of({here, again, late});
  const Raster returning = mosaic_of({here, elsewhere, again, elsewhere, late});
  EXPECT_EQ(staying.transform, returning.transform);
  for (std::size_t band = 0; band < staying.bands.size(); ++band)
    EXPECT_TRUE(staying.bands[band].pixels == returning.bands[band].pixels)
        << staying.bands[band].name;
}

TEST(TerrainMosaic, ALatticeThatIsOffIsTakenAtTheNearestCell) {
  SmallMap first(1);
  first.set(0, 0, 1.0F, 1.0F, 1);
  SmallMap second = first;
  second.min_x_m = 1.2;   // 2.4 cells
  second.min_y_m = -0.3;  // -0.6 cells
  second.set(0, 0, 2.0F, 1.0F, 1);
  const Raster raster = mosaic_of({first, second});
  ASSERT_EQ(raster.columns, 3);
  ASSERT_EQ(raster.rows, 2);
  EXPECT_EQ(raster.transform, (std::array<double, 6>{0.0, 0.5, 0.0, 0.5, 0.0, -0.5}));
  EXPECT_EQ(raster.at(1, 0, 0), 1.0F);
  EXPECT_EQ(raster.at(1, 2, 1), 2.0F);
}

TEST(TerrainMosaic, MemoryDoesNotGrowOverFiveKilometres) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "terrain.tif");
  SmallMap map = noisy_map(364, 0.0, 0.0, 1);
  map.resolution_m = 0.33;
  std::size_t most = 0;
  for (int scan = 0; scan < 250; ++scan) {
    map.min_x_m = 0.33 * std::round(20.0 * scan / 0.33);
    map.min_y_m = 0.33 * std::round(8.0 * scan / 0.33);
    mosaic.add(map.view());
    most = std::max(most, mosaic.resident_bytes());
  }
  // A window of 364 cells and its margin touch at most 5 × 5 tiles of 128 × 128 cells, 28 bytes
  // a cell.
  EXPECT_LE(most, std::size_t{25} * 128 * 128 * 28);
}

TEST(TerrainMosaic, AreasWithoutCellsTakeNoRoomAndReadAsNoData) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "terrain.tif");
  SmallMap map(1);
  map.set(0, 0, 1.0F, 0.5F, 1);
  mosaic.add(map.view());
  map.min_x_m = 1000.0;
  map.min_y_m = 1500.0;
  mosaic.add(map.view());
  mosaic.finish();
  // 2001 × 3001 cells in four bands are 96 MB.
  EXPECT_LT(std::filesystem::file_size(folder / "terrain.tif"), 20'000U);
  const Raster raster = read_raster(folder / "terrain.tif");
  ASSERT_EQ(raster.columns, 2001);
  ASSERT_EQ(raster.rows, 3001);
  for (const Raster::Band& band : raster.bands) {
    std::size_t known = 0;
    for (const float pixel : band.pixels) known += pixel == kNoData ? 0U : 1U;
    EXPECT_EQ(known, 2U) << band.name;
  }
}

TEST(TerrainMosaic, ADriveThatNoRasterHoldsIsAnError) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "terrain.tif");
  SmallMap map(1);
  map.set(0, 0, 1.0F, 0.5F, 1);
  mosaic.add(map.view());
  map.min_x_m = 5'000'000.0;
  map.min_y_m = 9'000'000.0;
  mosaic.add(map.view());
  EXPECT_TRUE(contains(message_of<io::Error>([&] { mosaic.finish(); }),
                       "terrain.tif: expected a drive that one raster can hold, got one over 5000 "
                       "km by 9000 km; check the poses"));
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(TerrainMosaic, RefusesViewsThatDoNotBelongTogether) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "terrain.tif");
  mosaic.add(SmallMap(3, 0.5).view());
  EXPECT_THROW(mosaic.add(SmallMap(3, 0.25).view()), std::invalid_argument);
  SmallMap map(3, 0.5);
  TerrainView view = map.view();
  view.confidence = view.confidence.first(8);
  EXPECT_THROW(mosaic.add(view), std::invalid_argument);
  map.min_x_m = 1e300;
  EXPECT_THROW(mosaic.add(map.view()), std::invalid_argument);
  map.min_x_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mosaic.add(map.view()), std::invalid_argument);
}

TEST(TerrainMosaic, WithoutScansOrGroundThereIsNothingToWrite) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "terrain.tif");
  const auto finish = [&] { return message_of<io::Error>([&] { mosaic.finish(); }); };
  EXPECT_TRUE(contains(finish(), "terrain.tif: expected terrain to write"));
  mosaic.add(TerrainView{});
  EXPECT_TRUE(contains(finish(), "terrain.tif: expected terrain to write"));
  mosaic.add(SmallMap(3).view());
  EXPECT_TRUE(contains(finish(), "terrain.tif: expected terrain to write"));
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(TerrainMosaic, IsEmptyUntilAScanHasShownGround) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "terrain.tif");
  EXPECT_TRUE(mosaic.empty());
  mosaic.add(TerrainView{});
  EXPECT_TRUE(mosaic.empty());
  // Points alone, without confidence, tell no height.
  SmallMap map(3);
  map.set(1, 1, 0.5F, 0.0F, 9);
  mosaic.add(map.view());
  EXPECT_TRUE(mosaic.empty());
  map.set(2, 0, 0.5F, 0.125F, 9);
  mosaic.add(map.view());
  EXPECT_FALSE(mosaic.empty());
  mosaic.finish();
  EXPECT_FALSE(mosaic.empty());
  EXPECT_EQ(read_raster(folder / "terrain.tif").at(1, 2, 2), 0.5F);
}

}  // namespace
}  // namespace groundgrid::geotiff
