// References of other resolutions, origins, units and systems, brought onto a terrain's pixels.
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "geotiff/height_raster.hpp"
#include "io/error.hpp"
#include "io/temporary_folder.hpp"
#include "make_raster.hpp"

namespace groundgrid::geotiff {
namespace {

using test::contains;
using test::kHole;
using test::make_raster;
using test::message_of;
using test::RasterPlan;

/// x 100 to 104, y 200 to 204, pixels of a metre.
RasterFrame small_frame(const std::string& crs = "") {
  RasterFrame frame{.columns = 4, .rows = 4, .transform = {100.0, 1.0, 0.0, 204.0, 0.0, -1.0}};
  if (crs.empty()) return frame;
  OGRSpatialReference reference;
  EXPECT_EQ(reference.SetFromUserInput(crs.c_str()), OGRERR_NONE);
  char* wkt = nullptr;
  reference.exportToWkt(&wkt);
  frame.crs = wkt;
  CPLFree(wkt);
  return frame;
}

class HeightResampling : public ::testing::Test {
 protected:
  ResampledHeights resampled(const RasterPlan& plan, const RasterFrame& onto = small_frame(),
                             std::optional<LengthUnit> unit = {}) {
    make_raster(path, plan);
    return resample_heights(path, onto, unit);
  }
  std::vector<float> heights(const RasterPlan& plan, const RasterFrame& onto = small_frame()) {
    ResampledHeights result = resampled(plan, onto);
    EXPECT_TRUE(result.remarks.empty());
    return result.heights_m;
  }
  std::string error_of(const RasterPlan& plan, const RasterFrame& onto = small_frame()) {
    make_raster(path, plan);
    ::testing::internal::CaptureStderr();
    std::string message = message_of<io::Error>([&] { (void)resample_heights(path, onto); });
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(contains(message, "reference.tif: expected "));
    return message;
  }

  test::TemporaryFolder folder;
  std::filesystem::path path = folder / "reference.tif";
};

double plane(double x, double y) { return 0.5 * (x - 100.0) - 0.25 * (y - 200.0) + 40.0; }

void expect_plane(const std::vector<float>& heights, const RasterFrame& frame) {
  ASSERT_EQ(heights.size(), static_cast<std::size_t>(frame.columns * frame.rows));
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      const double x = frame.transform[0] + (column + 0.5) * frame.transform[1];
      const double y = frame.transform[3] + (row + 0.5) * frame.transform[5];
      EXPECT_NEAR(heights[static_cast<std::size_t>(row * frame.columns + column)], plane(x, y),
                  1e-5)
          << column << ", " << row;
    }
  }
}

TEST_F(HeightResampling, LeavesTheSamePixelsAsTheyAre) {
  RasterPlan plan;
  plan.fill(plane);
  plan.no_data = -9999.0;
  plan.values[5] = -9999.0F;
  plan.values[15] = kHole;
  const std::vector<float> result = heights(plan);
  for (std::size_t pixel = 0; pixel < result.size(); ++pixel) {
    if (pixel == 5 || pixel == 15)
      EXPECT_TRUE(std::isnan(result[pixel])) << pixel;
    else
      EXPECT_EQ(result[pixel], plan.values[pixel]) << pixel;
  }
}

TEST_F(HeightResampling, AHoleInACoarseReferenceStaysAHole) {
  // Pixels of 2 m, one of them without a height: four pixels of the terrain.
  RasterPlan plan{.columns = 4, .rows = 4, .west = 98.0, .north = 206.0, .pixel = 2.0};
  plan.fill(plane);
  plan.no_data = -9999.0;
  plan.values[5] = -9999.0F;  // x 100 to 102, y 202 to 204
  const std::vector<float> result = heights(plan);
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      EXPECT_EQ(std::isnan(result[row * 4 + column]), row < 2 && column < 2)
          << column << ", " << row;
}

TEST_F(HeightResampling, InterpolatesBetweenThePixelsOfACoarseReference) {
  RasterPlan plan{.columns = 6, .rows = 6, .west = 95.0, .north = 210.0, .pixel = 2.5};
  plan.fill(plane);
  expect_plane(heights(plan), small_frame());
}

TEST_F(HeightResampling, InterpolatesWhereTheOriginsDiffer) {
  RasterPlan plan{.columns = 6, .rows = 6, .west = 99.25, .north = 204.75};
  plan.fill(plane);
  expect_plane(heights(plan), small_frame());
}

TEST_F(HeightResampling, TakesTheMeanOfAFineReference) {
  RasterPlan plan{.columns = 8, .rows = 8, .pixel = 0.5};
  plan.values.assign(64, 10.0F);
  plan.no_data = -9999.0;
  plan.values[0] = 1.0F;
  plan.values[1] = 2.0F;
  plan.values[8] = 4.0F;
  plan.values[9] = 9.0F;
  // The next one: three holes; the last one: nothing but holes.
  plan.values[2] = plan.values[3] = plan.values[10] = -9999.0F;
  plan.values[11] = 7.0F;
  plan.values[54] = plan.values[55] = plan.values[62] = plan.values[63] = -9999.0F;
  const std::vector<float> result = heights(plan);
  EXPECT_FLOAT_EQ(result[0], 4.0F);
  EXPECT_FLOAT_EQ(result[1], 7.0F);
  EXPECT_FLOAT_EQ(result[2], 10.0F);
  EXPECT_TRUE(std::isnan(result[15]));
}

TEST_F(HeightResampling, LeavesAHoleWhereTheReferenceEnds) {
  RasterPlan plan{.columns = 2, .rows = 4};
  plan.fill(plane);
  const std::vector<float> result = heights(plan);
  EXPECT_FALSE(std::isnan(result[1]));
  EXPECT_TRUE(std::isnan(result[2]));
  EXPECT_TRUE(std::isnan(result[3]));
}

TEST_F(HeightResampling, TakesRowsFromTheSouthToo) {
  RasterPlan plan;
  plan.fill(plane);
  RasterFrame south_up = small_frame();
  south_up.transform = {100.0, 1.0, 0.0, 200.0, 0.0, 1.0};
  expect_plane(heights(plan, south_up), south_up);
}

TEST_F(HeightResampling, TurnsFeetIntoMetres) {
  RasterPlan plan;
  plan.values.assign(16, 1000.0F);
  plan.unit = "ft";
  EXPECT_FLOAT_EQ(heights(plan)[0], 304.8F);
  plan.unit = "US survey foot";
  EXPECT_FLOAT_EQ(heights(plan)[0], static_cast<float>(1'200'000.0 / 3937.0));
}

TEST_F(HeightResampling, TurnsTheFeetOfAVerticalSystemIntoMetres) {
  RasterPlan plan;
  plan.values.assign(16, 3937.0F);
  plan.crs = "EPSG:26941+6360";  // NAD83 / California zone 1 in metres, NAVD88 in US survey feet
  EXPECT_FLOAT_EQ(heights(plan, small_frame("EPSG:26941"))[0], 1200.0F);
}

TEST_F(HeightResampling, TurnsAReferenceInFeetOnTheGroundIntoMetres) {
  // The same zone in US survey feet, heights too; 100 m are 328.083 of them.
  constexpr double kFoot = 1200.0 / 3937.0;
  RasterPlan plan{.columns = 60,
                  .rows = 60,
                  .west = 95.0 / kFoot,
                  .north = 209.0 / kFoot,
                  .pixel = 1.0,
                  .crs = "EPSG:2225",
                  .unit = "US survey foot"};
  plan.fill([](double x, double y) { return plane(x * kFoot, y * kFoot) / kFoot; });
  const RasterFrame frame = small_frame("EPSG:26941");
  const std::vector<float> result = heights(plan, frame);
  // The mean over whole pixels of a foot lies within half a foot of the pixel's middle.
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      EXPECT_NEAR(result[row * 4 + column],
                  plane(100.5 + static_cast<double>(column), 203.5 - static_cast<double>(row)),
                  0.02);
}

TEST_F(HeightResampling, AsksForTheUnitWhereOnlyTheGroundIsInFeet) {
  RasterPlan plan;
  plan.crs = "EPSG:2225";
  EXPECT_TRUE(contains(error_of(plan, small_frame("EPSG:2225")),
                       "a raster that names the unit of its heights, got none, and x and y in 'US "
                       "survey foot'; name the unit with --reference-unit"));
  const RasterFrame frame = small_frame("EPSG:2225");
  EXPECT_FLOAT_EQ(resampled(plan, frame, LengthUnit::metre).heights_m[0], 10.0F);
  EXPECT_FLOAT_EQ(resampled(plan, frame, LengthUnit::foot).heights_m[0], 3.048F);
}

TEST_F(HeightResampling, TheUnitThatWasAskedForGoesFirst) {
  RasterPlan plan;
  plan.unit = "ft";
  plan.values.assign(16, 3937.0F);
  EXPECT_FLOAT_EQ(resampled(plan, small_frame(), LengthUnit::us_survey_foot).heights_m[0], 1200.0F);
}

TEST_F(HeightResampling, TakesTheSameMapInTwoSystemsAsTheSame) {
  // ETRS89 and WGS 84 in the same zone lie on each other.
  RasterPlan plan{.columns = 12, .rows = 12, .west = 449'996.0, .north = 5'430'008.0};
  plan.crs = "EPSG:25832";
  plan.fill([](double x, double y) { return plane(x - 449'900.0, y - 5'429'800.0); });
  RasterFrame frame = small_frame("EPSG:32632");
  frame.transform[0] = 450'000.0;
  frame.transform[3] = 5'430'004.0;
  const std::vector<float> result = heights(plan, frame);
  EXPECT_NEAR(result[0], plane(100.5, 203.5), 1e-4);
  EXPECT_NEAR(result[15], plane(103.5, 200.5), 1e-4);
}

TEST_F(HeightResampling, TransformsBetweenZones) {
  // A surface that rises along the x of zone 33, seen from zone 32, whose north is 4° away.
  OGRSpatialReference zone_32;
  OGRSpatialReference zone_33;
  zone_32.importFromEPSG(32632);
  zone_33.importFromEPSG(32633);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&zone_32, &zone_33));
  const auto x_in_zone_33 = [&](double x, double y) {
    transformation->Transform(1, &x, &y);
    return std::pair(x, y);
  };
  const auto [x0, y0] = x_in_zone_33(700'000.0, 5'430'000.0);
  RasterPlan plan{.columns = 40, .rows = 40, .west = x0 - 20.0, .north = y0 + 20.0};
  plan.crs = "EPSG:32633";
  const double origin = x0;
  plan.fill([origin](double x, double) { return x - origin; });
  RasterFrame frame = small_frame("EPSG:32632");
  frame.transform[0] = 700'000.0;
  frame.transform[3] = 5'430'004.0;
  const std::vector<float> result = heights(plan, frame);
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      EXPECT_NEAR(result[row * 4 + column],
                  x_in_zone_33(700'000.5 + static_cast<double>(column),
                               5'430'003.5 - static_cast<double>(row))
                          .first -
                      x0,
                  0.002);
}

TEST_F(HeightResampling, SaysWhichOneHasNoReferenceSystem) {
  RasterPlan plan;
  const ResampledHeights without = resampled(plan, small_frame("EPSG:32632"));
  ASSERT_EQ(without.remarks.size(), 1U);
  EXPECT_TRUE(contains(without.remarks[0], "reference.tif names no reference system"));
  EXPECT_EQ(without.heights_m, std::vector<float>(16, 10.0F));
  plan.crs = "EPSG:32632";
  const ResampledHeights with = resampled(plan);
  ASSERT_EQ(with.remarks.size(), 1U);
  EXPECT_TRUE(contains(with.remarks[0], "the terrain names no reference system"));
  EXPECT_EQ(with.heights_m, std::vector<float>(16, 10.0F));
}

TEST_F(HeightResampling, RefusesSystemsThatCannotBeTransformed) {
  RasterPlan plan;
  plan.crs = "LOCAL_CS[\"the yard\",UNIT[\"metre\",1]]";
  const std::string message = error_of(plan, small_frame("EPSG:32632"));
  EXPECT_TRUE(contains(message, "can be transformed into 'WGS 84 / UTM zone 32N', got 'the yard'"));
  EXPECT_TRUE(contains(message, "gdal_edit.py -a_srs"));
}

TEST_F(HeightResampling, NamesBothExtentsWhereTheyDoNotMeet) {
  RasterPlan plan;
  plan.west = 1000.0;
  const std::string message = error_of(plan);
  EXPECT_TRUE(contains(message,
                       "values where the terrain lies (x 100.0 to 104.0, y 200.0 to "
                       "204.0), got none there; in the terrain's frame it covers x 1000.0 "
                       "to 1004.0, y 200.0 to 204.0; check that both lie in the same "));
}

TEST_F(HeightResampling, RefusesAReferenceThatIsAllHoleThere) {
  RasterPlan plan;
  plan.no_data = 10.0;
  EXPECT_TRUE(contains(error_of(plan), "got none there"));
}

TEST_F(HeightResampling, RefusesHolesThatNobodyMarked) {
  RasterPlan plan;
  plan.values.assign(16, -9999.0F);
  EXPECT_TRUE(contains(error_of(plan), "got one of -9999 m"));
}

TEST_F(HeightResampling, RefusesABrokenFile) {
  RasterPlan plan;
  plan.columns = plan.rows = 300;
  make_raster(path, plan);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 100);
  EXPECT_TRUE(contains(message_of<io::Error>([&] { (void)resample_heights(path, small_frame()); }),
                       "a GeoTIFF"));
}

TEST_F(HeightResampling, AMaskTakesTheNearestPixel) {
  // Pixels of 0.8 m; a mean would blur what is in and what is out.
  RasterPlan plan{.columns = 5, .rows = 5, .pixel = 0.8, .type = "Byte"};
  plan.values.assign(25, 0.0F);
  plan.values[0] = 1.0F;
  plan.values[24] = 255.0F;
  make_raster(path, plan);
  std::vector<float> expected(16, 0.0F);
  expected[0] = 1.0F;
  expected[15] = 255.0F;
  EXPECT_EQ(resample_mask(path, small_frame()), expected);
  plan.west = 500.0;
  make_raster(path, plan);
  EXPECT_THROW((void)resample_mask(path, small_frame()), io::Error);
}

}  // namespace
}  // namespace groundgrid::geotiff
