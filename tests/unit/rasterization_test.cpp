// Paper III-B: points into cells, and the cells' moments.
#include "core/stages/rasterization.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

TEST(Rasterize, GivesCountMeanVarianceMinimumAndMaximum) {
  const ElevationMap map = flat_map(metre_grid(11));
  PointsInCells points(map);
  points.add(3, 4, {1.0, 2.0, 4.0, 5.0});
  points.add(10, 10, {-0.5});
  const ScanGrid& grid = points.grid();
  const CellStatistics& cell = grid.statistics[cell_index(map, 3, 4)];
  EXPECT_EQ(cell.count, 4U);
  EXPECT_DOUBLE_EQ(cell.mean_m(), 3.0);         // (1 + 2 + 4 + 5) / 4
  EXPECT_NEAR(cell.variance_m2(), 2.5, 1e-12);  // (4 + 1 + 1 + 4) / 4
  EXPECT_EQ(cell.min, 10000);                   // steps of 0.1 mm
  EXPECT_EQ(cell.max, 50000);
  EXPECT_EQ(grid.occupied, (std::vector<std::uint32_t>{3 + 4 * 11, 10 + 10 * 11}));
  EXPECT_EQ(grid.statistics[cell_index(map, 10, 10)].min, -5000);
  EXPECT_EQ(grid.statistics[cell_index(map, 10, 10)].max, -5000);
  EXPECT_EQ(grid.statistics[cell_index(map, 0, 0)].count, 0U);
}

TEST(Rasterize, AgreesWithWelfordsMethod) {
  std::mt19937 random(11);
  std::normal_distribution<double> height(-37.0, 0.02);
  const ElevationMap map = flat_map(metre_grid(11));
  PointsInCells points(map);
  double mean = 0.0;
  double squares = 0.0;
  for (int n = 1; n <= 5000; ++n) {
    const double z = std::round(height(random) * 1e4) / 1e4;
    points.add(5, 5, {z});
    const double delta = z - mean;
    mean += delta / n;
    squares += delta * (z - mean);
  }
  const CellStatistics& cell = points.grid().statistics[cell_index(map, 5, 5)];
  EXPECT_NEAR(cell.mean_m(), mean, 1e-9);
  EXPECT_NEAR(cell.variance_m2(), squares / 5000, 1e-9);
}

TEST(Rasterize, LeavesOutliersOutAndForgetsTheScanBefore) {
  const ElevationMap map = flat_map(metre_grid(11));
  PointsInCells points(map);
  points.add(3, 4, {1.0, 2.0});
  ScanGrid grid(map.cells());
  TileRunner runner(1);
  BinnedPoints bins = points.bins();
  bins.cell[1] |= BinnedPoints::kOutlier;
  paper::rasterize(bins, grid);
  EXPECT_EQ(grid.statistics[cell_index(map, 3, 4)].count, 1U);
  EXPECT_EQ(grid.statistics[cell_index(map, 3, 4)].max, 10000);

  PointsInCells next(map);
  next.add(5, 5, {0.0});
  paper::rasterize(next.bins(), grid);
  EXPECT_EQ(grid.statistics[cell_index(map, 3, 4)].count, 0U);
  EXPECT_EQ(grid.is_occupied[cell_index(map, 3, 4)], 0);
  EXPECT_EQ(grid.occupied.size(), 1U);
}

TEST(Rasterize, SumsOfTwoMillionPointsInOneCellDoNotOverflow) {
  const ElevationMap map = flat_map(metre_grid(11));
  BinnedPoints bins;
  bins.cell.assign(2'000'000, 60);
  bins.z.assign(2'000'000, 2'000'000);  // 200 m
  ScanGrid grid(map.cells());
  TileRunner runner(1);
  paper::rasterize(bins, grid);
  EXPECT_EQ(grid.statistics[60].count, 2'000'000U);
  EXPECT_DOUBLE_EQ(grid.statistics[60].mean_m(), 200.0);
  EXPECT_EQ(grid.statistics[60].variance_m2(), 0.0);
}

/// Bins points given in the window frame through a sensor at its corner.
BinnedPoints bin(const ElevationMap& map, const Config& config, const std::vector<float>& xyz) {
  SensorPass pass;
  pass.points = PointView::from_floats(xyz.data(), xyz.size() / 3, 3);
  TileRunner runner(1);
  BinnedPoints bins;
  bins.resize(pass.points.count);
  bin_points(pass, {0, pass.points.count}, map, config, bins);
  return bins;
}

TEST(BinPoints, CellsAreHalfOpenAndHeightsAreTenthsOfMillimetres) {
  const Config config = metre_grid(11);
  const ElevationMap map = flat_map(config);
  const BinnedPoints bins = bin(map, config,
                                {0.0F, 0.0F, 0.5F,         //
                                 0.999F, 0.0F, -0.00014F,  //
                                 1.0F, 0.0F, -0.00016F,    //
                                 10.999F, 10.999F, 12.3456F});
  EXPECT_EQ(bins.cell, (std::vector<std::uint32_t>{0, 0, 1, 120}));
  EXPECT_EQ(bins.z, (std::vector<std::int32_t>{5000, -1, -2, 123456}));
}

TEST(BinPoints, PointsWithoutAnAnswerGetNoCell) {
  const float nan = std::nanf("");
  const float inf = std::numeric_limits<float>::infinity();
  const float huge = std::numeric_limits<float>::max();
  Config config = metre_grid(11);
  config.vehicle.min_range_m = 0.5;
  const ElevationMap map = flat_map(config);
  const BinnedPoints bins = bin(map, config, {5.0F,   5.0F,   0.0F,    // a good one
                                              -0.01F, 5.0F,   0.0F,    // outside
                                              5.0F,   11.01F, 0.0F,    //
                                              nan,    5.0F,   0.0F,    //
                                              5.0F,   nan,    0.0F,    //
                                              5.0F,   5.0F,   nan,     //
                                              inf,    5.0F,   0.0F,    //
                                              5.0F,   -inf,   0.0F,    //
                                              5.0F,   5.0F,   inf,     //
                                              huge,   -huge,  huge,    //
                                              5.0F,   5.0F,   -huge,   //
                                              0.3F,   0.3F,   0.1F});  // nearer than 0.5 m
  EXPECT_NE(bins.cell[0], BinnedPoints::kNoCell);
  for (std::size_t i = 1; i < bins.cell.size(); ++i)
    EXPECT_EQ(bins.cell[i], BinnedPoints::kNoCell) << "point " << i;
}

TEST(BinPoints, TheOwnVehiclesBoxIsInBase) {
  Config config = metre_grid(11);
  config.vehicle.ego_vehicle_box_m = {2.0, 4.0, -1.0, 1.0, 0.0, 2.0};
  const ElevationMap map = flat_map(config);
  const float xyz[] = {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 3.0F, 4.0F, 0.0F, 0.0F};
  SensorPass pass;
  pass.points = PointView::from_floats(xyz, 3, 3);
  // The sensor is 3 m in front of base and 1 m above it; base is in the middle of the map.
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  T_base_sensor.translation() << 3.0, 0.0, 1.0;
  Eigen::Isometry3d T_window_base = Eigen::Isometry3d::Identity();
  T_window_base.translation() << 3.5, 5.5, 0.0;
  pass.T_base_sensor = PointTransform(T_base_sensor);
  pass.trajectory.set_fixed(T_window_base * T_base_sensor);
  TileRunner runner(1);
  BinnedPoints bins;
  bins.resize(3);
  bin_points(pass, {0, pass.points.count}, map, config, bins);
  EXPECT_EQ(bins.cell[0], BinnedPoints::kNoCell);  // (3, 0, 1) in base: inside
  EXPECT_NE(bins.cell[1], BinnedPoints::kNoCell);  // (3, 0, 4): above
  EXPECT_NE(bins.cell[2], BinnedPoints::kNoCell);  // (7, 0, 1): in front
}

}  // namespace
}  // namespace groundgrid
