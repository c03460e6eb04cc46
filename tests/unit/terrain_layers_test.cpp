#include "groundgrid/terrain_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "core/map/cell_statistics.hpp"

namespace groundgrid {
namespace {

/// A map of known cells of half a metre with its corner at (10, 20, 100).
class LayeredMap {
 public:
  explicit LayeredMap(int size, const std::function<double(double, double)>& height) : size_(size) {
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        height_.push_back(static_cast<float>(height(column, row)));
    confidence_.assign(height_.size(), 1.0F);
    statistics_.resize(height_.size());
  }

  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row * size_ + column);
  }
  void forget(int column, int row) { confidence_[cell(column, row)] = 0.01F; }
  void set_points(int column, int row, double lowest, double highest) {
    CellStatistics& points = statistics_[cell(column, row)];
    points.min = static_cast<std::int32_t>(std::lround(lowest / CellStatistics::kStep_m));
    points.max = static_cast<std::int32_t>(std::lround(highest / CellStatistics::kStep_m));
    points.count = 2;
  }

  TerrainView view() const {
    TerrainView view;
    view.size = size_;
    view.resolution_m = 0.5;
    view.min_x_m = 10.0;
    view.min_y_m = 20.0;
    view.z_origin_m = 100.0;
    view.relative_height = height_;
    view.confidence = confidence_;
    view.statistics = statistics_.data();
    return view;
  }

 private:
  int size_;
  std::vector<float> height_;
  std::vector<float> confidence_;
  std::vector<CellStatistics> statistics_;
};

LayeredMap flat_cells(int size) {
  return LayeredMap(size, [](double, double) { return 0.0; });
}

float greatest(std::span<const float> layer) {
  float most = -1.0F;
  for (const float value : layer) most = std::max(most, value);
  return most;
}

TEST(TerrainLayers, OfAnyPlaneHaveItsSlopeAndNothingElse) {
  TerrainLayers layers;
  for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(0.3, 0.0), std::pair(-0.2, 0.15),
                             std::pair(0.0, -1.0), std::pair(0.6, 0.6)}) {
    const LayeredMap map(
        15, [x = x, y = y](double column, double row) { return 0.5 * (x * column + y * row); });
    layers.update(map.view());
    const double slope = std::atan(std::hypot(x, y)) * 180.0 / std::numbers::pi;
    for (std::size_t cell = 0; cell < 225; ++cell) {
      // A corner's window has four of nine cells: less than half.
      const bool corner = cell == 0 || cell == 14 || cell == 210 || cell == 224;
      EXPECT_EQ(std::isnan(layers.slope_deg()[cell]), corner) << cell;
      if (corner) continue;
      EXPECT_NEAR(layers.slope_deg()[cell], slope, 1e-4) << cell;
      EXPECT_NEAR(layers.roughness_m()[cell], 0.0, 1e-5) << cell;
      EXPECT_NEAR(layers.step_m()[cell], 0.0, 1e-5) << cell;
    }
  }
}

TEST(TerrainLayers, AStepShowsInTheCellsOnBothSidesWithItsHeight) {
  const LayeredMap map(15, [](double column, double) { return column < 7.0 ? 0.0 : 0.15; });
  TerrainLayers layers;
  layers.update(map.view());
  EXPECT_NEAR(layers.step_m()[map.cell(5, 7)], 0.0F, 1e-6F);
  EXPECT_NEAR(layers.step_m()[map.cell(6, 7)], 0.15F, 1e-6F);
  EXPECT_NEAR(layers.step_m()[map.cell(7, 7)], 0.15F, 1e-6F);
  EXPECT_NEAR(layers.step_m()[map.cell(8, 7)], 0.0F, 1e-6F);
  // Columns of 0, 0 and 0.15 m: the plane rises 0.075 m a cell and the heights are 0.025, -0.05
  // and 0.025 m from it: sqrt((2 · 0.025² + 0.05²) / 3) = 0.05 / sqrt(2).
  EXPECT_NEAR(layers.slope_deg()[map.cell(6, 7)], std::atan(0.15) * 180.0 / std::numbers::pi, 1e-4);
  EXPECT_NEAR(layers.roughness_m()[map.cell(6, 7)], 0.05 / std::numbers::sqrt2, 1e-6);
  EXPECT_EQ(layers.traversability()[map.cell(6, 7)], Traversability::no);
  EXPECT_EQ(layers.traversability()[map.cell(5, 7)], Traversability::yes);
}

TEST(TerrainLayers, AStepOnASlopeIsMeasuredFromTheSlope) {
  const LayeredMap map(
      15, [](double column, double) { return 0.15 * column + (column < 7.0 ? 0.0 : 0.15); });
  TerrainLayers layers;
  layers.update(map.view());
  EXPECT_NEAR(layers.step_m()[map.cell(6, 7)], 0.15F, 1e-5F);
  EXPECT_NEAR(layers.step_m()[map.cell(9, 7)], 0.0F, 1e-5F);
}

TEST(TerrainLayers, AWiderWindowLooksFarther) {
  const LayeredMap map(15, [](double column, double) { return column < 7.0 ? 0.0 : 0.15; });
  TerrainLayers narrow(1.4);  // 2.8 cells: three
  TerrainLayers wide(2.6);    // 5.2 cells: five
  narrow.update(map.view());
  wide.update(map.view());
  EXPECT_NEAR(narrow.roughness_m()[map.cell(5, 7)], 0.0F, 1e-6F);
  EXPECT_GT(wide.roughness_m()[map.cell(5, 7)], 0.03F);
}

TEST(TerrainLayers, TurnWithTheMap) {
  const auto ground = [](double x, double y) {
    return 0.1 * std::sin(0.9 * x) + 0.02 * x * y + (x + 0.5 * y > 9.0 ? 0.12 : 0.0);
  };
  const LayeredMap map(15, ground);
  const LayeredMap turned(15, [&](double x, double y) { return ground(y, 14.0 - x); });
  TerrainLayers a;
  TerrainLayers b;
  a.update(map.view());
  b.update(turned.view());
  EXPECT_GT(greatest(a.step_m()), 0.1F);
  for (int y = 1; y < 14; ++y) {
    for (int x = 1; x < 14; ++x) {
      const std::size_t here = map.cell(y, 14 - x);
      const std::size_t there = map.cell(x, y);
      EXPECT_NEAR(a.slope_deg()[here], b.slope_deg()[there], 1e-4F);
      EXPECT_NEAR(a.step_m()[here], b.step_m()[there], 1e-6F);
      EXPECT_NEAR(a.roughness_m()[here], b.roughness_m()[there], 1e-6F);
    }
  }
}

TEST(TerrainLayers, CellsWithoutSupportAreUnknownAndCountNowhere) {
  LayeredMap map(15, [](double column, double row) { return column == 7 && row == 7 ? 5.0 : 0.0; });
  map.forget(7, 7);
  TerrainLayers layers;
  layers.update(map.view());
  EXPECT_EQ(layers.traversability()[map.cell(7, 7)], Traversability::unknown);
  EXPECT_TRUE(std::isnan(layers.slope_deg()[map.cell(7, 7)]));
  EXPECT_TRUE(std::isnan(layers.step_m()[map.cell(7, 7)]));
  EXPECT_TRUE(std::isnan(layers.roughness_m()[map.cell(7, 7)]));
  EXPECT_EQ(layers.traversability()[map.cell(6, 7)], Traversability::yes);
  EXPECT_NEAR(greatest(layers.step_m()), 0.0F, 1e-6F);
}

TEST(TerrainLayers, ALoneCellIsUnknown) {
  LayeredMap map = flat_cells(5);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 5; ++column)
      if (column != 2 || row != 2) map.forget(column, row);
  TerrainLayers layers;
  layers.update(map.view());
  EXPECT_EQ(layers.traversability()[map.cell(2, 2)], Traversability::unknown);
}

TEST(TerrainLayers, ObstaclesByTheExtremesOfTheLastScan) {
  LayeredMap map(9, [](double, double) { return 1.0; });
  map.set_points(1, 1, 1.0, 1.1);  // ground
  map.set_points(2, 1, 1.0, 2.5);  // 1.5 m high
  map.set_points(3, 1, 4.0, 5.0);  // a bridge
  map.set_points(4, 1, 1.0, 5.0);  // ground and a crown, or a wall
  TerrainLayers layers;
  layers.update(map.view());
  const auto obstacle = layers.obstacle_height_m();
  EXPECT_EQ(obstacle[map.cell(1, 1)], 0.0F);
  EXPECT_NEAR(obstacle[map.cell(2, 1)], 1.5F, 1e-5F);
  EXPECT_TRUE(std::isnan(obstacle[map.cell(3, 1)]));
  EXPECT_TRUE(std::isnan(obstacle[map.cell(4, 1)]));
  EXPECT_TRUE(std::isnan(obstacle[map.cell(5, 1)]));
  EXPECT_EQ(layers.traversability()[map.cell(1, 1)], Traversability::yes);
  EXPECT_EQ(layers.traversability()[map.cell(2, 1)], Traversability::no);
  EXPECT_EQ(layers.traversability()[map.cell(3, 1)], Traversability::yes);
}

/// Points in the frame of a sensor 2 m above base, which is at (12, 22, 101) and turned by 90°.
struct TurnedScan {
  std::vector<float> xyz;
  std::vector<Label> labels;

  /// At a place of the map.
  void add(double x, double y, double z, Label label) {
    for (const double value : {y - 22.0, -(x - 12.0), z - 103.0})
      xyz.push_back(static_cast<float>(value));
    labels.push_back(label);
  }
  SensorScan scan() const {
    SensorScan scan;
    scan.points = PointView::from_floats(xyz.data(), labels.size(), 3);
    scan.T_base_sensor = Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 2.0));
    return scan;
  }
  static Eigen::Isometry3d T_map_base() {
    Eigen::Isometry3d pose(Eigen::Translation3d(12.0, 22.0, 101.0));
    pose.rotate(Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitZ()));
    return pose;
  }
};

TEST(TerrainLayers, ObstaclesByPointsSeeUnderWhatHangsOver) {
  const LayeredMap map(9, [](double, double) { return 1.0; });
  TurnedScan points;
  points.add(10.75, 20.75, 101.1, Label::ground);  // cell (1, 1): ground below a crown
  points.add(10.75, 20.75, 105.0, Label::obstacle);
  points.add(11.25, 20.75, 101.0, Label::ground);  // cell (2, 1): a wall
  points.add(11.25, 20.75, 103.4, Label::obstacle);
  points.add(11.25, 20.75, 103.6, Label::obstacle);
  points.add(11.75, 20.75, 104.0, Label::obstacle);  // cell (3, 1): a bridge
  points.add(12.25, 20.75, 102.0, Label::unknown);   // cell (4, 1): the own vehicle
  points.add(12.75, 20.75, 100.0, Label::outlier);   // cell (5, 1): a reflection
  points.add(50.0, 20.75, 102.0, Label::obstacle);   // outside
  points.add(std::nan(""), 20.75, 102.0, Label::obstacle);
  TerrainLayers layers;
  const SensorScan scan = points.scan();
  layers.update(map.view(), std::span(&scan, 1), TurnedScan::T_map_base(), points.labels);
  const auto obstacle = layers.obstacle_height_m();
  EXPECT_EQ(obstacle[map.cell(1, 1)], 0.0F);
  EXPECT_NEAR(obstacle[map.cell(2, 1)], 2.4F, 1e-5F);
  for (const int column : {3, 4, 5, 6})
    EXPECT_TRUE(std::isnan(obstacle[map.cell(column, 1)])) << column;
  EXPECT_EQ(layers.traversability()[map.cell(1, 1)], Traversability::yes);
  EXPECT_EQ(layers.traversability()[map.cell(2, 1)], Traversability::no);
}

TEST(TerrainLayers, AnObstacleOnUnknownGroundIsNotTraversable) {
  LayeredMap map = flat_cells(9);
  map.forget(4, 4);
  map.set_points(4, 4, 0.5, 1.0);
  TerrainLayers layers;
  layers.update(map.view());
  EXPECT_EQ(layers.traversability()[map.cell(4, 4)], Traversability::no);
}

TEST(TerrainLayers, EveryLimitCounts) {
  const LayeredMap slope(9, [](double column, double) { return 0.1 * column; });  // 11.3°
  LayeredMap rough(9, [](double column, double row) {
    return static_cast<int>(column + row) % 2 == 0 ? 0.0 : 0.04;  // steps of 0
  });
  rough.set_points(4, 4, 0.0, 0.15);
  TerrainLayers layers;
  const std::size_t middle = slope.cell(4, 4);
  const auto judged = [&](const LayeredMap& map, const TraversabilityLimits& limits) {
    layers.update(map.view(), limits);
    return layers.traversability()[middle];
  };
  EXPECT_EQ(judged(slope, {.max_slope_deg = 11.4}), Traversability::yes);
  EXPECT_EQ(judged(slope, {.max_slope_deg = 11.2}), Traversability::no);
  EXPECT_EQ(judged(rough, {.max_roughness_m = 0.021}), Traversability::yes);
  EXPECT_EQ(judged(rough, {.max_roughness_m = 0.019}), Traversability::no);
  EXPECT_EQ(judged(rough, {.min_obstacle_height_m = 0.16}), Traversability::yes);
  EXPECT_EQ(judged(rough, {.min_obstacle_height_m = 0.14}), Traversability::no);
  EXPECT_EQ(judged(slope, {.min_confidence = 1.1}), Traversability::unknown);
}

TEST(TerrainLayers, RefuseWhatDoesNotFit) {
  EXPECT_THROW(TerrainLayers(0.0), std::invalid_argument);
  EXPECT_THROW(TerrainLayers(std::nan("")), std::invalid_argument);
  EXPECT_THROW(TerrainLayers(101.0), std::invalid_argument);
  TerrainLayers layers;
  const LayeredMap map = flat_cells(5);
  TerrainView cut = map.view();
  cut.confidence = cut.confidence.first(3);
  EXPECT_THROW(layers.update(cut), std::invalid_argument);
  EXPECT_THROW(layers.update(map.view(), {.max_step_m = -0.1}), std::invalid_argument);
  EXPECT_THROW(layers.update(map.view(), {.max_slope_deg = std::nan("")}), std::invalid_argument);
  const SensorScan nowhere{.points = {.count = 1, .stride_bytes = 12}};
  EXPECT_THROW(layers.update(map.view(), std::span(&nowhere, 1), Eigen::Isometry3d::Identity(),
                             std::vector<Label>(1, Label::ground)),
               std::invalid_argument);
  TurnedScan points;
  points.add(10.0, 20.0, 100.0, Label::ground);
  const SensorScan scan = points.scan();
  EXPECT_THROW(layers.update(map.view(), std::span(&scan, 1), Eigen::Isometry3d::Identity(), {}),
               std::invalid_argument);
}

TEST(TerrainLayers, OfAnEmptyMapAreEmpty) {
  TerrainLayers layers;
  layers.update(TerrainView{});
  EXPECT_EQ(layers.size(), 0);
  EXPECT_TRUE(layers.slope_deg().empty());
  EXPECT_TRUE(layers.traversability().empty());
}

}  // namespace
}  // namespace groundgrid
