#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "image_checks.hpp"
#include "rendering/scan_view.hpp"
#include "rendering/terrain_view.hpp"

namespace groundgrid::rendering {
namespace {

constexpr ImageSize kViewSize{600, 450};

// Pixels of a colour left and right of the middle, and the mean row of all of them.
struct Sides {
  std::size_t left = 0;
  std::size_t right = 0;
  double mean_row = 0.0;
};
Sides sides_of(const Image& image, Color color) {
  Sides sides;
  // The legend has them all, so the lowest rows do not count.
  for (int y = 0; y < image.size.height * 85 / 100; ++y)
    for (int x = 0; x < image.size.width; ++x) {
      if (!test::is_tinted(image.at(x, y), color)) continue;
      ++(x < image.size.width / 2 ? sides.left : sides.right);
      sides.mean_row += y;
    }
  sides.mean_row /= static_cast<double>(sides.left + sides.right);
  return sides;
}

// A wall 10 m to the left, and ground 20 m ahead and 8 m to the right.
struct WallAndGround {
  std::vector<float> coordinates{};
  std::vector<std::uint8_t> group{};

  WallAndGround() {
    for (int i = 0; i < 400; ++i) add(0.05F * static_cast<float>(i), 10.0F, 0.0F, 1);
    for (int i = 0; i < 400; ++i) add(20.0F, -8.0F - 0.01F * static_cast<float>(i), -1.7F, 0);
    add(std::nanf(""), 0.0F, 0.0F, 1);
  }
  void add(float x, float y, float z, std::uint8_t to) {
    coordinates.insert(coordinates.end(), {x, y, z});
    group.push_back(to);
  }
  [[nodiscard]] ScanPicture picture() const {
    return {.coordinates = coordinates,
            .group = group,
            .styles = {{"ground", kBluishGreen, 3.0}, {"obstacle", kVermilion, 3.0}}};
  }
};

TEST(ScanView, LooksAheadFromBehind) {
  const Image image =
      draw_scan_in_perspective(PerspectiveRenderer(), WallAndGround().picture(), {}, kViewSize);
  EXPECT_EQ(image.size, kViewSize);
  const Sides wall = sides_of(image, kVermilion);
  EXPECT_GT(wall.left, 50U);
  EXPECT_EQ(wall.right, 0U);
  const Sides ground = sides_of(image, kBluishGreen);
  EXPECT_GT(ground.right, 50U);
  EXPECT_EQ(ground.left, 0U);
}

TEST(ScanView, LooksBackWhereAsked) {
  const Image image = draw_scan_in_perspective(PerspectiveRenderer(), WallAndGround().picture(),
                                               {.azimuth_deg = 180.0}, kViewSize);
  EXPECT_GT(sides_of(image, kVermilion).right, 50U);
  EXPECT_EQ(sides_of(image, kVermilion).left, 0U);
}

TEST(ScanView, NeedsAGroupForEachPoint) {
  WallAndGround scan;
  scan.group.pop_back();
  EXPECT_THROW((void)draw_scan_in_perspective(PerspectiveRenderer(), scan.picture(), {}, kViewSize),
               std::invalid_argument);
}

// Level in the south, 10 m high in the north.
TerrainPicture step_terrain() {
  TerrainPicture picture;
  picture.grid = {.columns = 40, .rows = 40, .cell_width_m = 2.0, .cell_height_m = 2.0};
  for (int i = 0; i < 1600; ++i) picture.grid.heights_m.push_back(i < 800 ? 10.0F : 0.0F);
  picture.shade = std::vector<std::uint8_t>(1600, 180);
  picture.level_shade = 180;
  picture.heights_m = {0.0, 10.0};
  return picture;
}

TEST(TerrainView, LooksNorthWithTheHighGroundFarAndAbove) {
  const Image image =
      draw_terrain_in_perspective(PerspectiveRenderer(), step_terrain(), {}, 1.0, kViewSize);
  EXPECT_EQ(image.size, kViewSize);
  const auto mean_row_of = [&image](Color color) {
    double rows = 0.0;
    double count = 0.0;
    // The bar on the right has every colour.
    for (int y = 0; y < image.size.height; ++y)
      for (int x = 0; x < image.size.width * 80 / 100; ++x)
        if (image.at(x, y) == color) {
          rows += y;
          ++count;
        }
    EXPECT_GT(count, 5000.0);
    return rows / count;
  };
  EXPECT_LT(mean_row_of(height_colors().at(1.0)) + 50.0, mean_row_of(height_colors().at(0.0)));
}

TEST(TerrainView, DrawsNothingWhereThereIsNoHeight) {
  TerrainPicture picture = step_terrain();
  for (int i = 0; i < 800; ++i) picture.grid.heights_m[static_cast<std::size_t>(i)] = std::nanf("");
  const Image image =
      draw_terrain_in_perspective(PerspectiveRenderer(), picture, {}, 1.0, kViewSize);
  std::size_t high = 0;
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width * 80 / 100; ++x)
      if (image.at(x, y) == height_colors().at(1.0)) ++high;
  EXPECT_EQ(high, 0U);
}

TEST(TerrainView, ExaggeratesFlatTerrainByARoundNumber) {
  TerrainPicture picture = step_terrain();
  EXPECT_DOUBLE_EQ(fitting_exaggeration(picture), 1.0);
  picture.heights_m = {0.0, 1.0};
  EXPECT_DOUBLE_EQ(fitting_exaggeration(picture), 5.0) << "0.08 of 80 m is 6.4 m";
  picture.heights_m = {0.0, 0.0};
  EXPECT_DOUBLE_EQ(fitting_exaggeration(picture), 10.0);
}

}  // namespace
}  // namespace groundgrid::rendering
