// One map as a GeoTIFF, read back with GDAL.
#include "geotiff/terrain_raster.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <limits>
#include <random>
#include <stdexcept>

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
using test::Raster;
using test::read_raster;
using test::SmallMap;

/// 3 × 3 cells of half a metre; (2, 0), in the south-east, is unknown.
SmallMap nine_cells() {
  SmallMap map(3);
  map.min_x_m = 100.0;
  map.min_y_m = 200.0;
  map.z_origin_m = 50.0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      map.set(column, row, 0.25F * static_cast<float>(row * 3 + column), 0.5F,
              static_cast<std::uint32_t>(10 * row + column));
  map.set(2, 0, 9.0F, 0.0F, 7);
  return map;
}

/// A map that no compressor makes small.
SmallMap noisy_map(int size) {
  SmallMap map(size);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> height(-3.0F, 3.0F);
  std::uniform_real_distribution<float> confidence(0.1F, 1.0F);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      map.set(column, row, height(random), confidence(random),
              static_cast<std::uint32_t>(random() % 1000));
  return map;
}

TEST(TerrainRaster, IsNorthUpWithPixelsOfACell) {
  const test::TemporaryFolder folder;
  write_terrain(folder / "a.tif", nine_cells().view());
  const Raster raster = read_raster(folder / "a.tif");
  EXPECT_EQ(raster.columns, 3);
  EXPECT_EQ(raster.rows, 3);
  EXPECT_EQ(raster.transform, (std::array<double, 6>{100.0, 0.5, 0.0, 201.5, 0.0, -0.5}));
  const std::vector<float> height{51.5F,  51.75F, 52.0F,   //
                                  50.75F, 51.0F,  51.25F,  //
                                  50.0F,  50.25F, kNoData};
  const std::vector<float> confidence{0.5F, 0.5F, 0.5F,  //
                                      0.5F, 0.5F, 0.5F,  //
                                      0.5F, 0.5F, kNoData};
  const std::vector<float> count{20.0F, 21.0F, 22.0F,  //
                                 10.0F, 11.0F, 12.0F,  //
                                 0.0F,  1.0F,  7.0F};
  // Points in the 3 × 3 cells around on 2.25 m²: 12 + 16 + 6 + 8 in the corners and so on.
  const std::vector<float> points_around{62.0F, 96.0F,  66.0F,  //
                                         63.0F, 104.0F, 74.0F,  //
                                         22.0F, 41.0F,  31.0F};
  ASSERT_EQ(raster.bands.size(), 5U);
  EXPECT_EQ(raster.bands[0].pixels, height);
  EXPECT_EQ(raster.bands[1].pixels, confidence);
  EXPECT_EQ(raster.bands[2].pixels, count);
  for (std::size_t pixel = 0; pixel < height.size(); ++pixel)
    EXPECT_EQ(raster.bands[4].pixels[pixel] == kNoData, height[pixel] == kNoData) << pixel;
  for (std::size_t pixel = 0; pixel < points_around.size(); ++pixel)
    EXPECT_FLOAT_EQ(raster.bands[3].pixels[pixel] * 2.25F, points_around[pixel]) << pixel;
}

TEST(TerrainRaster, SaysWhatItsBandsAre) {
  const test::TemporaryFolder folder;
  write_terrain(folder / "a.tif", nine_cells().view());
  const Raster raster = read_raster(folder / "a.tif");
  ASSERT_EQ(raster.bands.size(), 5U);
  EXPECT_EQ(raster.bands[0].name, "height");
  EXPECT_EQ(raster.bands[1].name, "confidence");
  EXPECT_EQ(raster.bands[2].name, "count");
  EXPECT_EQ(raster.bands[3].name, "density");
  EXPECT_EQ(raster.bands[4].name, "standard deviation");
  EXPECT_EQ(raster.bands[0].unit, "m");
  EXPECT_EQ(raster.bands[1].unit, "");
  EXPECT_EQ(raster.bands[2].unit, "");
  EXPECT_EQ(raster.bands[3].unit, "1/m2");
  EXPECT_EQ(raster.bands[4].unit, "m");
  for (const Raster::Band& band : raster.bands) {
    EXPECT_EQ(band.type, "Float32");
    EXPECT_TRUE(band.has_no_data);
    EXPECT_EQ(band.no_data, -9999.0);
  }
  EXPECT_EQ(raster.compression, "DEFLATE");
  EXPECT_EQ(raster.block, (std::array<int, 2>{256, 256}));
}

TEST(TerrainRaster, SeveralBlocksFitTogether) {
  const test::TemporaryFolder folder;
  const SmallMap map = noisy_map(300);
  write_terrain(folder / "a.tif", map.view());
  const Raster raster = read_raster(folder / "a.tif");
  ASSERT_EQ(raster.rows, 300);
  for (int row = 0; row < 300; ++row) {
    for (int column = 0; column < 300; ++column) {
      const auto cell = static_cast<std::size_t>(row * 300 + column);
      ASSERT_EQ(raster.at(1, column, 299 - row), map.height[cell]) << column << ", " << row;
      ASSERT_EQ(raster.at(2, column, 299 - row), map.confidence[cell]);
      ASSERT_EQ(raster.at(3, column, 299 - row), static_cast<float>(map.statistics[cell].count));
    }
  }
}

TEST(TerrainRaster, ALocalFrameHasNoReferenceSystem) {
  const test::TemporaryFolder folder;
  write_terrain(folder / "a.tif", nine_cells().view());
  EXPECT_EQ(read_raster(folder / "a.tif").epsg, "");
}

TEST(TerrainRaster, KeepsTheReferenceSystemAndUtmCoordinates) {
  const test::TemporaryFolder folder;
  SmallMap map = nine_cells();
  map.min_x_m = 456'789.125;
  map.min_y_m = 5'432'100.25;
  map.z_origin_m = 115.0;
  write_terrain(folder / "a.tif", map.view(), "EPSG:32632");
  const Raster raster = read_raster(folder / "a.tif");
  EXPECT_EQ(raster.epsg, "EPSG:32632");
  EXPECT_EQ(raster.area_or_point, "Area");
  EXPECT_EQ(raster.transform,
            (std::array<double, 6>{456'789.125, 0.5, 0.0, 5'432'101.75, 0.0, -0.5}));
  EXPECT_EQ(raster.at(1, 0, 2), 115.0F);
}

TEST(TerrainRaster, LeavesOneFileWhateverTheReferenceSystem) {
  for (const char* const crs :
       {"", "EPSG:32632", "EPSG:25832+7837", "+proj=tmerc +lat_0=49.01 +lon_0=8.43 +ellps=GRS80",
        "+proj=ortho +lat_0=49.01 +lon_0=8.43"}) {
    const test::TemporaryFolder folder;
    write_terrain(folder / "a.tif", nine_cells().view(), crs);
    EXPECT_EQ(files_below(folder.path()), (Names{"a.tif"})) << crs;
  }
}

TEST(TerrainRaster, RefusesAReferenceSystemThatAGeoTiffCannotHold) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(contains(message_of<std::invalid_argument>([&] {
                         write_terrain(folder / "a.tif", nine_cells().view(), "+proj=isea");
                       }),
                       "'+proj=isea' is one that a GeoTIFF cannot hold"));
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(TerrainRaster, RefusesAnUnknownReferenceSystem) {
  const test::TemporaryFolder folder;
  const auto write = [&](const char* crs) {
    return message_of<std::invalid_argument>(
        [&] { write_terrain(folder / "a.tif", nine_cells().view(), crs); });
  };
  EXPECT_TRUE(contains(write("EPSG:999999"), "unknown coordinate reference system 'EPSG:999999'"));
  EXPECT_TRUE(contains(write("Utopia"), "unknown coordinate reference system 'Utopia'"));
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(TerrainRaster, RefusesAReferenceSystemThatIsNotInMetres) {
  const test::TemporaryFolder folder;
  // Degrees, US survey feet, and metres from the Earth's centre.
  for (const char* const crs : {"EPSG:4326", "EPSG:2225", "EPSG:4978"})
    EXPECT_TRUE(contains(message_of<std::invalid_argument>(
                             [&] { write_terrain(folder / "a.tif", nine_cells().view(), crs); }),
                         std::string("'") + crs + "' is not projected in metres"));
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(TerrainRaster, RefusesAMapThatHasNotBegun) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(
      contains(message_of<io::Error>([&] { write_terrain(folder / "a.tif", TerrainView{}); }),
               "a.tif: expected terrain to write"));
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(TerrainRaster, RefusesViewsThatDoNotHoldTogether) {
  const test::TemporaryFolder folder;
  const SmallMap map = nine_cells();
  const auto write = [&](const TerrainView& view) { write_terrain(folder / "a.tif", view); };
  TerrainView view = map.view();
  view.size = 4;
  EXPECT_THROW(write(view), std::invalid_argument);
  view = map.view();
  view.resolution_m = 0.0;
  EXPECT_THROW(write(view), std::invalid_argument);
  view = map.view();
  view.min_y_m = std::numeric_limits<double>::infinity();
  EXPECT_THROW(write(view), std::invalid_argument);
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(TerrainRaster, ReplacesAFileOfThatName) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a.tif", "old");
  write_terrain(folder / "a.tif", nine_cells().view());
  EXPECT_EQ(read_raster(folder / "a.tif").columns, 3);
  EXPECT_EQ(files_below(folder.path()), (Names{"a.tif"}));
}

TEST(TerrainRaster, SaysThatAFolderIsMissing) {
  const test::TemporaryFolder folder;
  ::testing::internal::CaptureStderr();
  const std::string message =
      message_of<io::Error>([&] { write_terrain(folder / "none/a.tif", nine_cells().view()); });
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(contains(message, "none/a.tif: expected a place to write to, got "));
  EXPECT_TRUE(contains(message, "No such file or directory"));
}

TEST(TerrainRaster, DoesNotReplaceAFolder) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a.tif/b.txt", "kept");
  EXPECT_THROW(write_terrain(folder / "a.tif", nine_cells().view()), io::Error);
  EXPECT_EQ(files_below(folder.path()), (Names{"a.tif/b.txt"}));
}

// The disk may be full for the blocks, or only for the index that is written when the file closes.
class TerrainRasterFullDisk : public ::testing::TestWithParam<std::uintmax_t> {};

TEST_P(TerrainRasterFullDisk, IsNoticedAndLeavesTheOldFile) {
  const test::TemporaryFolder folder;
  const SmallMap map = noisy_map(300);
  write_terrain(folder / "whole.tif", map.view());
  const std::uintmax_t whole = std::filesystem::file_size(folder / "whole.tif");
  ASSERT_GT(whole, GetParam());
  std::filesystem::remove(folder / "whole.tif");
  test::write_file(folder / "a.tif", "old");
  ::testing::internal::CaptureStderr();
  {
    const test::LimitedFileSize limit(whole - GetParam());
    EXPECT_TRUE(
        contains(message_of<io::Error>([&] { write_terrain(folder / "a.tif", map.view()); }),
                 "a.tif: expected a place to write to, got "));
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(test::read_file(folder / "a.tif"), "old");
  EXPECT_EQ(files_below(folder.path()), (Names{"a.tif"}));
}

INSTANTIATE_TEST_SUITE_P(BytesTooFew, TerrainRasterFullDisk,
                         ::testing::Values(1U, 100U, 10'000U, 400'000U));

}  // namespace
}  // namespace groundgrid::geotiff
