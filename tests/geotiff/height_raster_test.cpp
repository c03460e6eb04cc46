// Terrains of our own and of others, read into arrays.
#include "geotiff/height_raster.hpp"

#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "geotiff/terrain_raster.hpp"
#include "io/error.hpp"
#include "io/temporary_folder.hpp"
#include "make_raster.hpp"
#include "small_map.hpp"

namespace groundgrid::geotiff {
namespace {

using test::contains;
using test::kHole;
using test::make_raster;
using test::message_of;
using test::RasterPlan;

class HeightRasterFile : public ::testing::Test {
 protected:
  HeightRaster read(const RasterPlan& plan) {
    make_raster(path, plan);
    return read_height_raster(path);
  }
  std::string error_of(const RasterPlan& plan) {
    make_raster(path, plan);
    return error();
  }
  [[nodiscard]] std::string error() const {
    ::testing::internal::CaptureStderr();
    std::string message = message_of<io::Error>([&] { (void)read_height_raster(path); });
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(contains(message, "height.tif: expected "));
    return message;
  }

  test::TemporaryFolder folder;
  std::filesystem::path path = folder / "height.tif";
};

TEST_F(HeightRasterFile, HoldsOurOwnTerrain) {
  test::SmallMap map(4, 0.5);
  map.min_x_m = 10.0;
  map.min_y_m = 20.0;
  map.z_origin_m = 100.0;
  map.set(0, 0, 1.0F, 0.5F, 3);
  map.set(3, 3, 0.0F, 0.0F, 2);
  write_terrain(path, map.view(), "EPSG:32632");
  const HeightRaster raster = read_height_raster(path);
  EXPECT_EQ(raster.frame.columns, 4);
  EXPECT_EQ(raster.frame.rows, 4);
  EXPECT_EQ(raster.frame.transform, (std::array<double, 6>{10.0, 0.5, 0.0, 22.0, 0.0, -0.5}));
  EXPECT_TRUE(contains(raster.frame.crs, "UTM zone 32N"));
  ASSERT_EQ(raster.heights_m.size(), 16U);
  EXPECT_EQ(raster.heights_m[12], 101.0F);
  EXPECT_TRUE(std::isnan(raster.heights_m[3]));
  EXPECT_EQ(raster.count[12], 3.0F);
  EXPECT_EQ(raster.count[3], 2.0F);
  EXPECT_TRUE(std::isnan(raster.count[0]));
  EXPECT_FLOAT_EQ(raster.density[8], 3.0F / 2.25F);
  EXPECT_TRUE(std::isnan(raster.density[0]));
}

TEST_F(HeightRasterFile, MayHoldHeightsAlone) {
  const HeightRaster raster = read(RasterPlan{});
  EXPECT_EQ(raster.heights_m, std::vector<float>(16, 10.0F));
  EXPECT_TRUE(raster.count.empty());
  EXPECT_TRUE(raster.density.empty());
  EXPECT_EQ(raster.frame.crs, "");
}

TEST_F(HeightRasterFile, HasHoles) {
  RasterPlan plan;
  plan.no_data = -32768.0;
  plan.values = {1.0F, -32768.0F, kHole};
  const HeightRaster raster = read(plan);
  EXPECT_EQ(raster.heights_m[0], 1.0F);
  EXPECT_TRUE(std::isnan(raster.heights_m[1]));
  EXPECT_TRUE(std::isnan(raster.heights_m[2]));
  EXPECT_EQ(raster.heights_m[3], 10.0F);
}

TEST_F(HeightRasterFile, MayBeInFeet) {
  for (const char* const unit : {"ft", "foot", "Feet"}) {
    RasterPlan plan;
    plan.unit = unit;
    EXPECT_FLOAT_EQ(read(plan).heights_m[0], 3.048F) << unit;
  }
  RasterPlan plan;
  plan.values = {3937.0F};
  for (const char* const unit : {"US survey foot", "us-ft"}) {
    plan.unit = unit;
    EXPECT_FLOAT_EQ(read(plan).heights_m[0], 1200.0F) << unit;
  }
}

TEST_F(HeightRasterFile, MayHoldScaledWholeNumbers) {
  RasterPlan plan;
  plan.type = "Int16";
  plan.scale = 0.25;
  plan.no_data = -1.0;
  plan.values = {7.0F, -1.0F};
  const HeightRaster raster = read(plan);
  EXPECT_EQ(raster.heights_m[0], 1.75F);
  EXPECT_TRUE(std::isnan(raster.heights_m[1]));
}

TEST_F(HeightRasterFile, MustBeThere) {
  EXPECT_TRUE(contains(error(), "a GeoTIFF, got no file of that name"));
}

TEST_F(HeightRasterFile, MustBeAGeoTiff) {
  test::write_file(path, "no raster at all");
  EXPECT_TRUE(contains(error(), "a GeoTIFF, got "));
}

TEST_F(HeightRasterFile, MustBeWhole) {
  RasterPlan plan;
  plan.columns = plan.rows = 300;
  make_raster(path, plan);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_TRUE(contains(error(), "a GeoTIFF, got "));
}

TEST_F(HeightRasterFile, MustNotBeLargerThanMemory) {
  // A file of some bytes that promises 40 GB.
  GDALRegister_GTiff();
  const std::array<const char*, 3> options{"SPARSE_OK=TRUE", "TILED=YES", nullptr};
  std::unique_ptr<GDALDataset> raster(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      path.c_str(), 100'000, 100'000, 1, GDT_Float32, const_cast<char**>(options.data())));
  std::array<double, 6> transform{0.0, 1.0, 0.0, 0.0, 0.0, -1.0};
  raster->SetGeoTransform(transform.data());
  raster.reset();
  EXPECT_TRUE(contains(error(), "at most 100 million pixels, got 100000 x 100000; cut "));
}

TEST_F(HeightRasterFile, MustSayWhereItLies) {
  RasterPlan plan;
  plan.placed = false;
  EXPECT_TRUE(contains(error_of(plan), "got one without georeference; set it with gdal_edit.py"));
}

TEST_F(HeightRasterFile, MustNotBeTurned) {
  RasterPlan plan;
  plan.turned = 0.1;
  EXPECT_TRUE(contains(error_of(plan), "got a raster that is turned"));
}

TEST_F(HeightRasterFile, MustBeInMetresOnTheGround) {
  RasterPlan plan;
  plan.crs = "EPSG:4326";
  EXPECT_TRUE(contains(error_of(plan), "projected in metres, got the system 'WGS 84'; gdalwarp"));
  plan.crs = "EPSG:2225";
  EXPECT_TRUE(contains(error_of(plan), "got the system 'NAD83 / California zone 1 (ftUS)'"));
}

TEST_F(HeightRasterFile, MustBeInAKnownUnit) {
  RasterPlan plan;
  plan.unit = "fathom";
  EXPECT_TRUE(contains(error_of(plan), "heights in metres or feet, got the unit 'fathom'"));
}

TEST_F(HeightRasterFile, MustHoldHeights) {
  // A hole that nobody marked as one would look like an error of ten kilometres.
  RasterPlan plan;
  plan.values = {1.0F, -9999.0F};
  EXPECT_TRUE(contains(error_of(plan),
                       "heights from -1000 to 9000 m, got one of -9999 m; if it "
                       "stands for no height, say so with gdal_edit.py -a_nodata"));
  plan.values = {1.0F, INFINITY};
  EXPECT_TRUE(contains(error_of(plan), "got one of inf m"));
}

}  // namespace
}  // namespace groundgrid::geotiff
