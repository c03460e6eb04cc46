#include "core/ground_envelope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

/// A scan with one ground cell at every cell of a 41 × 41 map, cells of one metre.
class GroundEnvelopeTest : public ::testing::Test {
 protected:
  GroundEnvelopeTest() : config_(metre_grid(41)), map_(flat_map(config_)), cells_(map_.cells()) {
    config_.min_point_fraction = 0.0;
    config_.min_variance_threshold = 1.0;  // all cells are ground before the envelope looks
    config_.patch_change_distance_m = 1e6;
    config_.envelope_slope = 0.25;
    config_.envelope_step_m = 0.15;
    config_.envelope_pit_m = 0.3;
  }

  void reject(const std::function<double(int, int)>& height, const Plane& plane = {}) {
    PointsInCells points(map_);
    for (int row = 0; row < map_.size(); ++row)
      for (int column = 0; column < map_.size(); ++column)
        points.add(column, row, {height(column, row)});
    TileRunner runner(1);
    const ScanGrid& grid = points.grid();
    cells_.classify(grid, map_, SensorPositions{{{20.5F, 20.5F, 1.7F}}}, config_, runner);
    GroundEnvelope envelope(map_, runner);
    envelope.reject_raised(grid, map_, plane, config_, cells_);
  }

  bool is_ground(int column, int row) const {
    return cells_.is_ground()[cell_index(map_, column, row)] == 1;
  }

  std::size_t ground_cells() const {
    std::size_t count = 0;
    for (const std::uint8_t ground : cells_.is_ground()) count += ground;
    return count;
  }

  Config config_;
  ElevationMap map_;
  GroundCells cells_;
};

TEST_F(GroundEnvelopeTest, FlatGroundStays) {
  reject([](int, int) { return 0.0; });
  EXPECT_EQ(ground_cells(), map_.cells());
}

TEST_F(GroundEnvelopeTest, AFlatRoofIsNoGround) {
  reject([](int column, int row) {
    return column >= 10 && column < 14 && row >= 10 && row < 14 ? 1.4 : 0.0;
  });
  EXPECT_FALSE(is_ground(12, 12));
  EXPECT_TRUE(is_ground(20, 20));
  EXPECT_TRUE(is_ground(5, 12));
}

TEST_F(GroundEnvelopeTest, AKerbIsAStepOfGround) {
  reject([](int, int row) { return row >= 25 ? 0.12 : 0.0; });
  EXPECT_EQ(ground_cells(), map_.cells());
}

TEST_F(GroundEnvelopeTest, AHillsideIsGroundHoweverSteep) {
  reject([](int column, int) { return 0.6 * column; });
  // Near the edge nothing says how the trend goes on.
  for (int row = 0; row < map_.size(); ++row)
    for (int column = 6; column < map_.size() - 6; ++column)
      EXPECT_TRUE(is_ground(column, row)) << column << ' ' << row;
}

TEST_F(GroundEnvelopeTest, AShortSlopeBelowTheLimitIsGroundAndASteeperOneIsNot) {
  // A mound of 5 × 5 cells, too small to be the trend.
  const auto mound = [](double slope) {
    return [slope](int column, int row) {
      const int from_middle = std::max(std::abs(column - 20), std::abs(row - 20));
      return slope * std::max(0, 3 - from_middle);
    };
  };
  reject(mound(0.2));
  EXPECT_EQ(ground_cells(), map_.cells());
  reject(mound(0.6));
  EXPECT_FALSE(is_ground(20, 20));
  EXPECT_TRUE(is_ground(10, 20));
}

TEST_F(GroundEnvelopeTest, ASteepRoadIsMeasuredFromTheVehiclesPlane) {
  const Plane vehicle{20.5, 20.5, 0.0, 0.4, 0.0};
  reject([](int column, int) { return 0.4 * (column - 20); }, vehicle);
  EXPECT_EQ(ground_cells(), map_.cells());
}

TEST_F(GroundEnvelopeTest, AReflectionBelowTheGroundDoesNotPullItDown) {
  reject([](int column, int row) { return column == 20 && row == 20 ? -3.0 : 0.0; });
  EXPECT_TRUE(is_ground(25, 20));
  EXPECT_TRUE(is_ground(20, 28));
}

}  // namespace
}  // namespace groundgrid
