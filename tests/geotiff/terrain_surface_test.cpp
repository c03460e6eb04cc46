// What is taken out of a terrain, and how its gaps are filled.
#include "geotiff/terrain_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "geotiff/terrain_mosaic.hpp"
#include "io/temporary_folder.hpp"
#include "read_raster.hpp"
#include "small_map.hpp"

namespace groundgrid::geotiff {
namespace {

constexpr double kCell_m = 0.5;
constexpr float kGap = std::numeric_limits<float>::quiet_NaN();
using HeightAt = std::function<float(std::int64_t column, std::int64_t row)>;

HeightWindow window_of(const CellRange& cells, const HeightAt& height_at) {
  HeightWindow window(cells);
  for (std::int64_t row = cells.first_row; row < cells.end_row; ++row)
    for (std::int64_t column = cells.first_column; column < cells.end_column; ++column)
      window.heights[window.index(column, row)] = height_at(column, row);
  return window;
}

HeightWindow surface_of(const CellRange& cells, const HeightAt& height_at,
                        const SurfaceOptions& options = {}) {
  HeightWindow window = window_of(cells, height_at);
  TerrainSurface(options, kCell_m).complete(window);
  return window;
}

float at(const HeightWindow& window, std::int64_t column, std::int64_t row) {
  return window.heights[window.index(column, row)];
}

TEST(TerrainSurface, LeavesGroundAsItIsBitForBit) {
  // 0.2 m a cell of 0.5 m is a slope of 0.4, and 0.1 m more a kerb.
  const HeightAt street = [](std::int64_t column, std::int64_t) {
    return 0.2F * static_cast<float>(column) + (column > 5 ? 0.1F : 0.0F);
  };
  const HeightWindow surface = surface_of({0, 12, 0, 12}, street);
  EXPECT_EQ(surface.heights, window_of({0, 12, 0, 12}, street).heights);
}

TEST(TerrainSurface, TakesOutWhatRisesFasterThanGroundDoes) {
  // A step of 0.15 m and a slope of 0.5 let a cell lie 0.4 m above its neighbour 0.5 m away.
  SurfaceOptions options;
  options.step_m = 0.15;
  options.max_slope = 0.5;
  const auto peak = [&options](float height) {
    const HeightAt meadow = [height](std::int64_t column, std::int64_t row) {
      return column == 5 && row == 5 ? height : 2.0F;
    };
    return surface_of({0, 11, 0, 11}, meadow, options);
  };
  EXPECT_EQ(at(peak(2.19F), 5, 5), 2.19F);
  EXPECT_NEAR(at(peak(2.41F), 5, 5), 2.0F, 1e-5F);
}

TEST(TerrainSurface, TakesOutWhatStandsAboveTheSurfaceButNotTerraces) {
  // Both rise by 0.2 m a cell up to 0.6 m, which the neighbours alone allow.
  const auto mound = [](std::int64_t half) {
    return surface_of({-40, 41, -40, 41}, [half](std::int64_t column, std::int64_t row) {
      const std::int64_t from_top = std::max(std::abs(column), std::abs(row)) - half;
      return std::clamp(0.6F - 0.2F * static_cast<float>(from_top), 0.0F, 0.6F);
    });
  };
  EXPECT_LT(at(mound(0), 0, 0), 0.3F);
  EXPECT_EQ(at(mound(8), 0, 0), 0.6F);
}

TEST(TerrainSurface, HoldsCellsAgainstThoseInReachOnly) {
  // A plateau 3 m high that ends 2.0 m (4 cells) and 2.5 m west of column 4 and 5.
  const HeightAt plateau = [](std::int64_t column, std::int64_t) {
    return column <= 0 ? 0.0F : 3.0F;
  };
  SurfaceOptions options;
  options.fill_m = 0.0;
  options.reach_m = 2.0;
  const HeightWindow surface = surface_of({-8, 12, 0, 9}, plateau, options);
  EXPECT_TRUE(std::isnan(at(surface, 1, 4)));
  EXPECT_TRUE(std::isnan(at(surface, 4, 4)));
  EXPECT_EQ(at(surface, 5, 4), 3.0F);
  EXPECT_EQ(at(surface, 0, 4), 0.0F);
}

TEST(TerrainSurface, FillsAGapOnASlopeAlongIt) {
  const HeightAt slope = [](std::int64_t column, std::int64_t row) {
    const bool gap = column > 3 && column < 7 && row > 3 && row < 7;
    return gap ? kGap : 10.0F + 0.1F * static_cast<float>(column);
  };
  const HeightWindow surface = surface_of({0, 11, 0, 11}, slope);
  EXPECT_NEAR(at(surface, 5, 5), 10.5, 0.01);
  EXPECT_NEAR(at(surface, 4, 5), 10.4, 0.01);
  EXPECT_NEAR(at(surface, 6, 5), 10.6, 0.01);
}

TEST(TerrainSurface, FillsNoFartherThanAsked) {
  const HeightAt half = [](std::int64_t column, std::int64_t) { return column < 0 ? 1.0F : kGap; };
  SurfaceOptions options;
  options.fill_m = 2.0;
  const HeightWindow surface = surface_of({-6, 10, 0, 12}, half, options);
  EXPECT_NEAR(at(surface, 3, 6), 1.0F, 1e-5F);
  EXPECT_TRUE(std::isnan(at(surface, 5, 6)));
}

TEST(TerrainSurface, IsTheSameWindowByWindowToAMillimetre) {
  const HeightAt hills = [](std::int64_t column, std::int64_t row) {
    const auto mixed = static_cast<std::uint64_t>(column * 7919 + row * 104729 + 1000003) % 101;
    return mixed < 40 ? kGap : 0.012F * static_cast<float>(mixed % 10);
  };
  TerrainSurface surface(SurfaceOptions{}, kCell_m);
  HeightWindow whole = window_of(surface.window_around({0, 60, 0, 60}), hills);
  surface.complete(whole);
  for (const CellRange& part : {CellRange{0, 30, 0, 60}, CellRange{30, 60, 0, 60}}) {
    HeightWindow window = window_of(surface.window_around(part), hills);
    surface.complete(window);
    for (std::int64_t row = part.first_row; row < part.end_row; ++row)
      for (std::int64_t column = part.first_column; column < part.end_column; ++column)
        ASSERT_NEAR(at(window, column, row), at(whole, column, row), 1e-3F) << column << ' ' << row;
  }
}

TEST(TerrainSurface, WindowsSideBySideAgreeWhereTheyMeet) {
  // Hills of which stripes are known, so that there is much to fill.
  const HeightAt hills = [](std::int64_t column, std::int64_t row) {
    if ((row / 9) % 2 == 0 || (column / 16) % 3 == 0) return kGap;
    return static_cast<float>(3.0 * std::sin(static_cast<double>(column) / 40.0) +
                              2.0 * std::cos(static_cast<double>(row) / 25.0));
  };
  TerrainSurface surface(SurfaceOptions{}, kCell_m);
  HeightWindow left = window_of(surface.window_around({0, 256, 0, 256}), hills);
  surface.complete(left);
  HeightWindow right = window_of(surface.window_around({256, 512, 0, 256}), hills);
  surface.complete(right);
  std::vector<float> apart;  // of filled cells
  for (std::int64_t row = 0; row < 256; ++row)
    for (std::int64_t column = 250; column < 262; ++column)
      if (std::isnan(hills(column, row)) && !std::isnan(at(left, column, row)))
        apart.push_back(std::abs(at(left, column, row) - at(right, column, row)));
  ASSERT_GT(apart.size(), 500U);
  std::sort(apart.begin(), apart.end());
  EXPECT_LT(apart[apart.size() / 2], 0.01F);
  EXPECT_LT(apart.back(), 0.15F);
}

TEST(TerrainSurface, DeviationsGrowIntoGapsAndAreNowhereElse) {
  const HeightAt gap = [](std::int64_t column, std::int64_t) {
    return column < 20 || column >= 32 ? 1.0F : kGap;
  };
  SurfaceOptions options;
  options.fill_m = 2.0;
  const HeightWindow surface = surface_of({0, 52, 0, 52}, gap, options);
  const auto deviation = [&surface](std::int64_t column) {
    return surface.deviations[surface.index(column, 26)];
  };
  EXPECT_GT(deviation(10), 0.0F);
  EXPECT_LT(deviation(10), 0.1F);
  EXPECT_GT(deviation(22), deviation(10));
  EXPECT_TRUE(std::isnan(deviation(26)));  // more than 2 m from both sides
  EXPECT_TRUE(std::isnan(at(surface, 26, 26)));
}

TEST(TerrainSurface, WithoutOptionsHeightsStayAndHaveDeviations) {
  const HeightAt peak = [](std::int64_t column, std::int64_t row) {
    if (column == 3 && row == 3) return kGap;
    return column == 5 && row == 5 ? 9.0F : 2.0F;
  };
  HeightWindow surface = window_of({0, 11, 0, 11}, peak);
  TerrainSurface(std::nullopt, kCell_m).complete(surface);
  EXPECT_EQ(at(surface, 5, 5), 9.0F);
  EXPECT_TRUE(std::isnan(at(surface, 3, 3)));
  EXPECT_TRUE(std::isnan(surface.deviations[surface.index(3, 3)]));
  EXPECT_GT(surface.deviations[surface.index(5, 5)], 3.0F) << "far off the plane around it";
  EXPECT_GT(surface.deviations[surface.index(9, 9)], 0.0F);
}

TEST(TerrainSurface, WithoutAnyHeightThereIsNone) {
  const HeightWindow surface =
      surface_of({0, 4, 0, 4}, [](std::int64_t, std::int64_t) { return kGap; });
  EXPECT_TRUE(std::all_of(surface.heights.begin(), surface.heights.end(),
                          [](float height) { return std::isnan(height); }));
}

/// Cells of 0.5 m at height 1, with a gap of one cell and a peak of another.
test::SmallMap meadow() {
  test::SmallMap map(7);
  for (int row = 0; row < 7; ++row)
    for (int column = 0; column < 7; ++column) map.set(column, row, 1.0F, 0.5F, 3);
  map.set(2, 3, 1.0F, 0.0F, 3);
  map.set(4, 3, 9.0F, 0.5F, 3);
  return map;
}

void expect_completed(const test::Raster& raster) {
  const std::vector<float>& height = raster.bands[0].pixels;
  const std::vector<float>& confidence = raster.bands[1].pixels;
  const std::vector<float>& count = raster.bands[2].pixels;
  ASSERT_EQ(height.size(), 49U);
  for (const float pixel : height) EXPECT_NEAR(pixel, 1.0F, 1e-5F);
  EXPECT_EQ(count, std::vector<float>(49, 3.0F));
  for (std::size_t i = 0; i < 49; ++i)
    EXPECT_EQ(confidence[i], i == 23 || i == 25 ? 0.0F : 0.5F) << i;
}

TEST(TerrainSurface, FilledCellsOfARasterHaveConfidenceZero) {
  const test::TemporaryFolder folder;
  write_terrain(folder / "scan.tif", meadow().view(), {}, SurfaceOptions{});
  expect_completed(test::read_raster(folder / "scan.tif"));
}

TEST(TerrainSurface, FilledCellsOfADriveHaveConfidenceZero) {
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "drive.tif", {}, SurfaceOptions{});
  mosaic.add(meadow().view());
  mosaic.finish();
  expect_completed(test::read_raster(folder / "drive.tif"));
}

TEST(TerrainSurface, ADriveIsFilledAcrossTheBordersOfItsTiles) {
  // Tiles begin at multiples of 128 cells, blocks of the file at multiples of 256.
  const test::TemporaryFolder folder;
  TerrainMosaic mosaic(folder / "drive.tif", {}, SurfaceOptions{});
  test::SmallMap map(300);
  for (int row = 0; row < 300; ++row)
    for (int column = 0; column < 300; ++column)
      if ((column < 126 || column > 129) && (column < 254 || column > 257))
        map.set(column, row, 0.02F * static_cast<float>(column), 1.0F, 1);
  mosaic.add(map.view());
  mosaic.finish();
  const test::Raster raster = test::read_raster(folder / "drive.tif");
  ASSERT_EQ(raster.columns, 300);
  for (std::size_t i = 0; i < raster.bands[0].pixels.size(); ++i)
    ASSERT_NEAR(raster.bands[0].pixels[i], 0.02 * static_cast<double>(i % 300), 0.01) << i;
}

}  // namespace
}  // namespace groundgrid::geotiff
