#include "simulation/truth_rasters.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/objects.hpp"

namespace groundgrid::simulation {
namespace {

/// A slope of 10 % along y with a kerb of 10 cm at x = 2, under two boxes of leaves, and a fence.
class AKerb : public ::testing::Test {
 protected:
  static Ground ground(const Eigen::Vector2d& place) {
    return {(place.x() > 2.0 ? 0.1 : 0.0) + 0.1 * place.y(), 40, 0.0};
  }

  static Scene scene() {
    Scene scene{.path = std::make_shared<const Path>(std::vector<Bend>{}, 10.0, 30.0),
                .ground = ground};
    const std::uint32_t leaves =
        scene.leaves.add_surface({.label = label::kVegetation, .density = 1.0F});
    add_box(scene.leaves, {-3.0, -1.0, 2.0}, {-1.0, 1.0, 3.0}, leaves);
    add_box(scene.leaves, {-2.0, -1.0, 4.0}, {0.0, 1.0, 5.0}, leaves);
    const std::uint32_t fence = scene.leaves.add_surface({.label = label::kFence, .density = 9.0F});
    add_box(scene.leaves, {0.5, -4.0, 0.0}, {1.5, 4.0, 1.0}, fence);
    return scene;
  }

  /// 40 by 20 cells of 0.2 m about a point that is 7 m above the world's origin.
  [[nodiscard]] TruthRasters rasters() const {
    return {world_, {-4.0, -2.0, 0.2, 40, 20}, {0.0, 0.0, 7.0}, runner_};
  }
  static std::size_t cell(double x, double y) {
    return static_cast<std::size_t>((y + 2.0) / 0.2) * 40 +
           static_cast<std::size_t>((x + 4.0) / 0.2);
  }

  mutable TileRunner runner_{2};
  Scene scene_ = scene();
  Terrain terrain_{Path({}, 10.0, 30.0), 10.0, ground, runner_};
  World world_{scene_, terrain_};
};

TEST_F(AKerb, HeightsAreAboveTheOrigin) {
  const std::vector<float> heights = rasters().heights();
  ASSERT_EQ(heights.size(), 800U);
  EXPECT_NEAR(heights[cell(-3.1, 0.5)], -7.0 + 0.05, 1e-4);
  EXPECT_NEAR(heights[cell(3.3, -0.5)], -7.0 + 0.1 - 0.05, 1e-4);
}

TEST_F(AKerb, LeavesAreAboveAndFencesAreNone) {
  const TruthRasters rasters = this->rasters();
  const std::vector<float> mask = rasters.under_leaves();
  EXPECT_EQ(mask[cell(-3.3, 0.1)], 0.0F);
  EXPECT_EQ(mask[cell(-2.5, 0.1)], 1.0F);
  EXPECT_EQ(mask[cell(-0.5, 0.1)], 1.0F);
  EXPECT_EQ(mask[cell(-0.5, 1.3)], 0.0F);
  EXPECT_EQ(mask[cell(1.1, 0.1)], 0.0F);
}

TEST_F(AKerb, IsMarkedWithWhatIsNear) {
  const std::vector<float> mask = rasters().at_kerbs();
  for (const double y : {-1.9, 0.1, 1.9}) {
    EXPECT_EQ(mask[cell(1.9, y)], 1.0F);
    EXPECT_EQ(mask[cell(2.1, y)], 1.0F);
    EXPECT_EQ(mask[cell(1.3, y)], 0.0F);
    EXPECT_EQ(mask[cell(2.7, y)], 0.0F);
    EXPECT_EQ(mask[cell(-2.0, y)], 0.0F);
  }
}

}  // namespace
}  // namespace groundgrid::simulation
