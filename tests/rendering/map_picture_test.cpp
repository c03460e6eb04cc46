#include "rendering/map_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "image_checks.hpp"

namespace groundgrid::rendering {
namespace {

constexpr ImageSize kMapSize{640, 480};
constexpr std::uint8_t kLevel = 180;

// 3 by 2 cells of 10 m: low in the north-west, high in the south-east, one hole in the middle
// below.
HeightGrid small_grid() {
  return {.columns = 3,
          .rows = 2,
          .west_m = 100.0,
          .north_m = 20.0,
          .cell_width_m = 10.0,
          .cell_height_m = 10.0,
          .heights_m = {0.0F, 1.0F, 2.0F, 3.0F, std::nanf(""), 10.0F}};
}

TerrainPicture small_terrain() {
  TerrainPicture picture;
  picture.grid = small_grid();
  picture.shade = std::vector<std::uint8_t>(6, kLevel);
  picture.level_shade = kLevel;
  picture.heights_m = {0.0, 10.0};
  return picture;
}

// The colour in the middle of a cell, in a picture with a heading of `above` pixels.
Color cell_color(const Image& image, const Rectangle& plot, int column, int row) {
  const double scale = std::min(plot.width / 30.0, plot.height / 20.0);
  const double x = plot.middle().x + scale * (10.0 * column + 5.0 - 15.0);
  const double y = plot.middle().y + scale * (10.0 * row + 5.0 - 10.0);
  return image.at(static_cast<int>(x), static_cast<int>(y));
}

Rectangle plot_of(const ColorBar& bar) {
  return Figure(kMapSize, {.legend = {{.text = "no data"}}, .bar = bar}).plot();
}

TEST(TerrainPicture, HasTheColourOfEachHeightNorthUp) {
  const Image image = draw_terrain_from_above(small_terrain(), kMapSize);
  EXPECT_EQ(image.size, kMapSize);
  const Rectangle plot = plot_of({&height_colors(), 0.0, 10.0, "height (m)"});
  EXPECT_EQ(cell_color(image, plot, 0, 0), height_colors().at(0.0));
  EXPECT_EQ(cell_color(image, plot, 1, 0), height_colors().at(0.1));
  EXPECT_EQ(cell_color(image, plot, 2, 1), height_colors().at(1.0));
}

TEST(TerrainPicture, ShowsHolesAsNoColourOfTheBar) {
  const Image image = draw_terrain_from_above(small_terrain(), kMapSize);
  const Color hole = cell_color(image, plot_of({&height_colors(), 0.0, 10.0, "height (m)"}), 1, 1);
  EXPECT_EQ(hole.red, hole.green);
  EXPECT_EQ(hole.red, hole.blue);
  EXPECT_GT(hole.red, 190);
}

TEST(TerrainPicture, SlopesInTheShadeAreDarkerAndThoseInTheSunLighter) {
  const ValueRange range{0.0, 10.0};
  EXPECT_EQ(terrain_color(range, 5.0, 1.0), height_colors().at(0.5));
  EXPECT_LT(terrain_color(range, 5.0, 0.5).green, height_colors().at(0.5).green);
  EXPECT_GT(terrain_color(range, 5.0, 1.4).green, height_colors().at(0.5).green);
}

TEST(TerrainPicture, DrawsThePathWhereItRuns) {
  TerrainPicture picture = small_terrain();
  picture.path = {{101.0, 15.0, 0.0}, {125.0, 15.0, 0.0}};
  const Image image = draw_terrain_from_above(picture, kMapSize);
  const Rectangle plot =
      Figure(kMapSize, {.legend = {{.text = "no data"}},
                        .bar = ColorBar{&height_colors(), 0.0, 10.0, "height (m)"}})
          .plot();
  EXPECT_EQ(cell_color(image, plot, 1, 0), kPath);
  EXPECT_NE(cell_color(image, plot, 0, 1), kPath);
}

TEST(ErrorPicture, IsBlueWhereTooLowAndRedWhereTooHighAndSaysWhatIsMissing) {
  ErrorPicture picture;
  picture.errors = small_grid();
  picture.errors.heights_m = {-0.5F, 0.0F, 0.25F, 7.0F, std::nanf(""), std::nanf("")};
  picture.reference = small_grid();
  picture.reference.heights_m = {1.0F, 1.0F, 1.0F, 1.0F, 1.0F, std::nanf("")};
  picture.limit_m = 0.5;
  const Image image = draw_errors(picture, kMapSize);
  const Rectangle plot = plot_of({&error_colors(), -0.5, 0.5, "estimate \u2212 reference (m)"});
  EXPECT_EQ(cell_color(image, plot, 0, 0), error_colors().at(0.0));
  EXPECT_EQ(cell_color(image, plot, 1, 0), kWhite);
  EXPECT_EQ(cell_color(image, plot, 2, 0), error_colors().at(0.75));
  EXPECT_EQ(cell_color(image, plot, 0, 1), error_colors().at(1.0)) << "beyond the limit";
  const Color uncovered = cell_color(image, plot, 1, 1);
  const Color without_reference = cell_color(image, plot, 2, 1);
  EXPECT_EQ(uncovered.red, uncovered.blue);
  EXPECT_LT(uncovered.red, without_reference.red - 20);
}

TEST(MapSize, FollowsTheShapeOfTheMapWithinLimits) {
  EXPECT_GT(map_size(200.0, 100.0).width, map_size(100.0, 100.0).width);
  EXPECT_EQ(map_size(100.0, 100.0).width, map_size(100.0, 100.0).height);
  EXPECT_EQ(map_size(1000.0, 1.0), map_size(250.0, 100.0));
  EXPECT_EQ(map_size(1.0, 1000.0).width, map_size(1000.0, 1.0).height);
}

}  // namespace
}  // namespace groundgrid::rendering
