// Paper III-A: lines of sight against a brute-force oracle, and cases made by hand.
#include "core/stages/outlier_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "core/method/line_of_sight.hpp"
#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;

constexpr RayRule kPapersRule{0.1, 1.25};

struct Interval {
  double begin = 0.0;
  double end = 1.0;
  [[nodiscard]] double length() const { return end - begin; }
};

/// Clips a ray's share between from and to by low <= coordinate <= high.
void clip(double from, double to, double low, double high, Interval& share) {
  if (from == to) {
    if (from < low || from > high) share.end = share.begin - 1.0;
    return;
  }
  const double a = (low - from) / (to - from);
  const double b = (high - from) / (to - from);
  share.begin = std::max(share.begin, std::min(a, b));
  share.end = std::min(share.end, std::max(a, b));
}

double confidence_sum(const ElevationMap& map, int column, int row) {
  double sum = 0.0;
  for (int y = std::max(row - 2, 0); y <= std::min(row + 2, map.size() - 1); ++y)
    for (int x = std::max(column - 2, 0); x <= std::min(column + 2, map.size() - 1); ++x)
      sum += static_cast<double>(map.confidence()[cell_index(map, x, y)]);
  return sum;
}

/// How much a cell hides of a ray: below 0 it does not, near 0 rounding decides.
double hides_by(const ElevationMap& map, const Point3f& sensor, const Point3f& point, int column,
                int row, const RayRule& rule) {
  const double cell = map.cell_size();
  Interval share;
  clip(static_cast<double>(sensor.x), static_cast<double>(point.x), column * cell,
       (column + 1) * cell, share);
  clip(static_cast<double>(sensor.y), static_cast<double>(point.y), row * cell, (row + 1) * cell,
       share);
  const double sensor_z = static_cast<double>(sensor.z);
  const double drop = static_cast<double>(point.z) - sensor_z;
  const double lowest = sensor_z + (drop < 0.0 ? share.end : share.begin) * drop;
  const double surface = static_cast<double>(map.height()[cell_index(map, column, row)]);
  return std::min({share.length() - 1e-9, surface - lowest - rule.tolerance_m,
                   confidence_sum(map, column, row) - rule.min_confidence});
}

bool is_inside(const ElevationMap& map, const Point3f& sensor) {
  const double extent = map.size() * map.cell_size();
  const auto x = static_cast<double>(sensor.x);
  const auto y = static_cast<double>(sensor.y);
  return x >= 0.0 && x < extent && y >= 0.0 && y < extent;
}

/// Looks at every cell of the map; nothing where rounding decides.
std::optional<bool> sees(const ElevationMap& map, const Point3f& sensor, const Point3f& point,
                         const RayRule& rule) {
  if (!is_inside(map, sensor)) return true;
  const auto own_column =
      static_cast<int>(std::floor(static_cast<double>(point.x) / map.cell_size()));
  const auto own_row = static_cast<int>(std::floor(static_cast<double>(point.y) / map.cell_size()));
  double most = -1.0;
  for (int row = 0; row < map.size(); ++row)
    for (int column = 0; column < map.size(); ++column)
      if (column != own_column || row != own_row)
        most = std::max(most, hides_by(map, sensor, point, column, row, rule));
  if (std::abs(most) < 1e-6) return std::nullopt;
  return most < 0.0;
}

TEST(LineOfSight, AgreesWithBruteForceOnRandomMapsAndRays) {
  std::mt19937 random(7);
  const auto uniform = [&random](double low, double high) {
    return static_cast<float>(std::uniform_real_distribution<double>(low, high)(random));
  };
  Config config = Config::paper();
  config.map.extent_m = 20 * config.map.resolution_m;
  int rays[2] = {0, 0};
  int undecided = 0;
  for (int round = 0; round < 60; ++round) {
    ElevationMap map = flat_map(config);
    const double extent = map.size() * map.cell_size();
    const double most_confidence = round % 2 == 0 ? 0.11 : 0.5;
    for (float& height : map.height()) height = uniform(-0.4, 0.3);
    for (float& confidence : map.confidence()) confidence = uniform(0.0, most_confidence);
    for (int ray = 0; ray < 200; ++ray) {
      // Some sensors stand outside of the map, some rays run along one row of cells.
      const Point3f sensor{uniform(-2.0, extent + 2.0), uniform(-2.0, extent + 2.0),
                           uniform(0.3, 1.9)};
      Point3f point{uniform(0.0, extent), uniform(0.0, extent), uniform(-0.8, 0.4)};
      if (ray % 10 == 0) point.y = sensor.y;
      const std::optional<bool> expected = sees(map, sensor, point, kPapersRule);
      if (!expected) {
        ++undecided;
        continue;
      }
      ++rays[*expected ? 1 : 0];
      ASSERT_EQ(has_line_of_sight(map, sensor, point, kPapersRule), *expected)
          << "from " << sensor.x << ' ' << sensor.y << ' ' << sensor.z << " to " << point.x << ' '
          << point.y << ' ' << point.z << " in round " << round;
    }
  }
  EXPECT_GT(rays[0], 2000) << "too few hidden points to tell";
  EXPECT_GT(rays[1], 2000) << "too few visible points to tell";
  EXPECT_LT(undecided, 50);
}

/// A known road along x at height 0, 40 m long; the sensor stands on it 1.73 m high.
class Road : public ::testing::Test {
 protected:
  Road() : config_(Config::paper()), map_(make_map(config_)) {
    for (float& confidence : map_.confidence()) confidence = 0.5F;
  }

  static ElevationMap make_map(Config& config) {
    config.map.extent_m = 40.0;
    return flat_map(config);
  }

  bool sees(float x, float z) const {
    return has_line_of_sight(map_, sensor_, {sensor_.x + x, sensor_.y, z}, kPapersRule);
  }

  /// Sets the known height of all cells from `begin` to `end` metres ahead of the sensor.
  void set_height(float begin, float end, float height) {
    for (int row = 0; row < map_.size(); ++row)
      for (int column = 0; column < map_.size(); ++column) {
        const auto ahead = static_cast<float>((column + 0.5) * map_.cell_size()) - sensor_.x;
        if (ahead > begin && ahead < end) map_.height()[cell_index(map_, column, row)] = height;
      }
  }

  Config config_;
  ElevationMap map_;
  Point3f sensor_{10.0F, 20.0F, 1.73F};
};

TEST_F(Road, HidesAReflectionBelowIt) { EXPECT_FALSE(sees(10.0F, -1.5F)); }

TEST_F(Road, ShowsItsOwnPoints) {
  EXPECT_TRUE(sees(3.0F, 0.0F));
  EXPECT_TRUE(sees(10.0F, 0.0F));
  EXPECT_TRUE(sees(25.0F, 0.05F));
  EXPECT_TRUE(sees(25.0F, 3.0F));
}

TEST_F(Road, HidesNothingWhereItIsHardlyKnown) {
  for (float& confidence : map_.confidence()) confidence = 0.04F;  // 25 · 0.04 = 1.0 < 1.25
  EXPECT_TRUE(sees(10.0F, -1.5F));
}

TEST_F(Road, ToleratesWhatIsHiddenByLittle) {
  // The ray to 10 m ahead and 0.15 m deep dips 0.1 m under the road 0.27 m before its end:
  // (0.15 − 0.1) / (1.73 + 0.15) · 10; within the point's own cell or not, a centimetre decides.
  EXPECT_TRUE(sees(10.0F, -0.09F));
  EXPECT_FALSE(sees(10.0F, -0.3F));
}

TEST_F(Road, ADitchThatIsKnownIsSeenAboveTheLineOfItsEdge) {
  set_height(8.0F, 11.0F, -1.0F);
  // At the edge, 8 m ahead, the ray to the far side is still 1.73 − 2.23 · 8/10.5 = 0.03 m high.
  EXPECT_TRUE(sees(10.5F, -0.5F));
  // Right behind the edge it would be 1.73 − 2.73 · 8/8.8 = −0.75 m: nobody can see that.
  EXPECT_FALSE(sees(8.8F, -1.0F));
}

TEST_F(Road, AHillHidesWhatLiesBehindIt) {
  set_height(5.0F, 6.0F, 1.5F);
  EXPECT_FALSE(sees(15.0F, 0.0F));
  EXPECT_TRUE(sees(15.0F, 1.6F));
  EXPECT_TRUE(sees(4.0F, 0.0F));
}

TEST(FilterOutliers, MarksOnlyHiddenPointsWellBelowTheMap) {
  Config config;
  config.map.extent_m = 40.0;
  ElevationMap map = flat_map(config);
  for (float& confidence : map.confidence()) confidence = 0.5F;
  const float xyz[] = {10.0F, 0.0F, -3.23F,   // 1.5 m under the road
                       10.0F, 0.0F, -2.04F,   // 0.31 m under the road
                       10.0F, 0.0F, -2.02F,   // 0.29 m under it
                       99.0F, 0.0F, -3.23F};  // outside of the map
  SensorPass pass;
  pass.points = PointView::from_floats(xyz, 4, 3);
  Eigen::Isometry3d T_window_sensor = Eigen::Isometry3d::Identity();
  T_window_sensor.translation() << 10.0, 20.0, 1.73;
  pass.trajectory.set_fixed(T_window_sensor);
  TileRunner runner(1);
  BinnedPoints bins;
  bins.resize(4);
  bin_points(pass, {0, pass.points.count}, map, config, bins);
  const std::vector<std::uint32_t> cells = bins.cell;
  const auto outliers = [&] {
    bins.cell = cells;
    filter_outliers(pass, {0, 4}, map, bins);
    std::vector<bool> marked;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      marked.push_back(bins.is_outlier(i));
      EXPECT_EQ(bins.cell[i] | BinnedPoints::kOutlier, cells[i] | BinnedPoints::kOutlier);
    }
    return marked;
  };
  EXPECT_EQ(outliers(), std::vector<bool>(4, false)) << "a blank map knows nothing";
  map.mark_observed();
  EXPECT_EQ(outliers(), (std::vector<bool>{true, true, false, false}));
  for (float& confidence : map.confidence()) confidence = 0.3F;
  EXPECT_EQ(outliers(), std::vector<bool>(4, false)) << "25 · 0.3 is less than ground seen well";
}

}  // namespace
}  // namespace groundgrid
