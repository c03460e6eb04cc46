// Terrains whose figures can be worked out by hand: a plane, a step, a slope.
#include "evaluation/terrain_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "evaluation/slope.hpp"

namespace groundgrid::evaluation {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// A terrain of 10 × 10 cells of half a metre over a level reference of 20 m.
struct Terrain {
  [[nodiscard]] TerrainLayers layers() const {
    TerrainLayers layers;
    layers.lattice = lattice;
    layers.estimated_m = estimated;
    layers.reference_m = reference;
    layers.density = density;
    layers.deviation_m = deviation;
    layers.count = count;
    layers.path_distance_m = path_distance;
    return layers;
  }
  [[nodiscard]] TerrainFigures figures(OffsetUse use = OffsetUse::reported) const {
    return compare_terrain(layers(), use);
  }
  float& at(std::vector<float>& layer, int column, int row) const {
    return layer[lattice.index(column, row)];
  }

  CellLattice lattice{10, 10, 0.5, 0.5};
  std::vector<float> estimated = std::vector<float>(100, 20.0F);
  std::vector<float> reference = std::vector<float>(100, 20.0F);
  std::vector<float> density{};
  std::vector<float> deviation{};
  std::vector<float> count{};
  std::vector<float> path_distance{};
};

TEST(TerrainMetrics, JudgesStandardDeviationsByDensity) {
  Terrain terrain;
  terrain.density = std::vector<float>(100, 0.0F);
  terrain.deviation = std::vector<float>(100, 0.2F);
  // Column 0 is dense and 0.1 m off, column 1 sparse and 0.3 m off; one cell says nothing.
  for (int row = 0; row < 10; ++row) {
    terrain.at(terrain.density, 0, row) = 30.0F;
    terrain.at(terrain.estimated, 0, row) = 20.1F;
    terrain.at(terrain.density, 1, row) = 3.0F;
    terrain.at(terrain.estimated, 1, row) = 20.3F;
  }
  terrain.at(terrain.deviation, 0, 4) = kNone;
  const std::vector<GroupCalibration> groups = terrain.figures().calibration;
  ASSERT_EQ(groups.size(), 5U);
  EXPECT_EQ(groups[0].group, "dense");
  EXPECT_EQ(groups[0].figures.cells, 9U);
  EXPECT_DOUBLE_EQ(groups[0].figures.within_one, 1.0);
  EXPECT_EQ(groups[1].group, "sparse");
  EXPECT_DOUBLE_EQ(groups[1].figures.within_one, 0.0);
  EXPECT_DOUBLE_EQ(groups[1].figures.within_two, 1.0);
  // Columns 2 to 5 are within 2 m of column 1.
  EXPECT_EQ(groups[2].group, "unseen_near");
  EXPECT_EQ(groups[2].figures.cells, 40U);
  EXPECT_EQ(groups[3].group, "unseen_far");
  EXPECT_EQ(groups[3].figures.cells, 40U);
  EXPECT_EQ(groups[4].group, "all");
  EXPECT_NEAR(groups[4].figures.within_one, 89.0 / 99.0, 1e-12);
}

TEST(TerrainMetrics, WithTheOffsetTakenOutDeviationsAreJudgedWithoutIt) {
  Terrain terrain;
  terrain.deviation = std::vector<float>(100, 0.1F);
  for (float& height : terrain.estimated) height += 0.25F;
  EXPECT_DOUBLE_EQ(terrain.figures().calibration.back().figures.within_two, 0.0);
  EXPECT_DOUBLE_EQ(terrain.figures(OffsetUse::taken_out).calibration.back().figures.within_one,
                   1.0);
}

TEST(TerrainMetrics, OfAPlaneThatIsTooHigh) {
  Terrain terrain;
  for (float& height : terrain.estimated) height += 0.25F;
  const TerrainFigures figures = terrain.figures();
  EXPECT_EQ(figures.all.cells, 100U);
  EXPECT_EQ(figures.all.covered, 100U);
  EXPECT_DOUBLE_EQ(figures.all.rmse_m, 0.25);
  EXPECT_DOUBLE_EQ(figures.all.mae_m, 0.25);
  EXPECT_DOUBLE_EQ(figures.all.bias_m, 0.25);
  EXPECT_DOUBLE_EQ(figures.all.p95_m, 0.25);
  EXPECT_FALSE(figures.by_density);
  EXPECT_FALSE(figures.paper);
  EXPECT_TRUE(figures.by_path_distance.empty());
  EXPECT_TRUE(figures.by_mask.empty());
}

TEST(TerrainMetrics, OfAStepThatWasSmoothedAway) {
  // The reference steps by 0.5 m at column 5; the estimate lies in the middle everywhere.
  Terrain terrain;
  for (int row = 0; row < 10; ++row)
    for (int column = 5; column < 10; ++column) terrain.at(terrain.reference, column, row) = 20.5F;
  for (float& height : terrain.estimated) height = 20.25F;
  const TerrainFigures figures = terrain.figures();
  EXPECT_DOUBLE_EQ(figures.all.rmse_m, 0.25);
  EXPECT_DOUBLE_EQ(figures.all.bias_m, 0.0);
  // Columns 4 and 5 rise by 0.5 m over the metre between their neighbours: 50 %.
  ASSERT_EQ(figures.by_slope.size(), 5U);
  EXPECT_EQ(figures.by_slope[0].errors.cells, 80U);
  EXPECT_EQ(figures.by_slope[4].errors.cells, 20U);
  EXPECT_EQ(figures.by_slope[4].from, 50.0);
  EXPECT_TRUE(std::isinf(figures.by_slope[4].to));
}

TEST(TerrainMetrics, OfASlopeThatIsTooSteep) {
  // The reference rises by 10 %, the estimate by 12 %: 0.01 m more a cell, 0 to 0.09 m.
  Terrain terrain;
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 10; ++column) {
      terrain.at(terrain.reference, column, row) = 0.05F * static_cast<float>(column);
      terrain.at(terrain.estimated, column, row) = 0.06F * static_cast<float>(column);
    }
  }
  const TerrainFigures figures = terrain.figures();
  EXPECT_NEAR(figures.all.rmse_m, 0.01 * std::sqrt(28.5), 1e-7);  // 285 is the sum of 0² to 9².
  EXPECT_NEAR(figures.all.mae_m, 0.045, 1e-7);
  EXPECT_NEAR(figures.all.p95_m, 0.09, 1e-7);
  EXPECT_EQ(figures.by_slope[1].errors.cells, 100U);
  EXPECT_EQ(figures.by_slope[1].from, 5.0);
  EXPECT_EQ(figures.by_slope[1].to, 15.0);
}

TEST(TerrainMetrics, CountWhatIsNotCovered) {
  Terrain terrain;
  terrain.estimated[0] = kNone;
  terrain.estimated[1] = std::numeric_limits<float>::infinity();
  terrain.reference[1] = kNone;
  terrain.reference[2] = kNone;
  const TerrainFigures figures = terrain.figures();
  EXPECT_EQ(figures.all.cells, 98U);
  EXPECT_EQ(figures.all.covered, 97U);
  EXPECT_EQ(figures.without_reference, 1U);
  EXPECT_DOUBLE_EQ(figures.all.rmse_m, 0.0);
}

TEST(TerrainMetrics, SortCellsByHowWellTheyWereSeen) {
  Terrain terrain;
  terrain.density.assign(100, 0.0F);
  terrain.density[0] = 27.0F;   // dense, in a corner
  terrain.density[1] = 26.99F;  // sparse
  terrain.density[2] = 0.5F;    // sparse, without a height
  terrain.density[3] = kNone;   // unseen
  terrain.estimated[0] = 20.5F;
  terrain.estimated[1] = 19.0F;
  terrain.estimated[2] = kNone;
  // The far corner is unseen and more than 2 m from all that was seen.
  terrain.estimated[99] = 23.0F;
  const TerrainFigures figures = terrain.figures();
  ASSERT_TRUE(figures.by_density);
  const ErrorsByDensity& groups = *figures.by_density;
  EXPECT_EQ(groups.dense.cells, 1U);
  EXPECT_DOUBLE_EQ(groups.dense.rmse_m, 0.5);
  EXPECT_EQ(groups.sparse.cells, 2U);
  EXPECT_EQ(groups.sparse.covered, 1U);
  EXPECT_DOUBLE_EQ(groups.sparse.bias_m, -1.0);
  // Seen are columns 0 to 2 of row 0. Four cells are 2 m: beside column 2 four more columns are
  // near in row 0, three in rows 1 and 2, two in row 3, none in row 4.
  EXPECT_EQ(groups.unseen_near.cells, 4U + 6U + 6U + 5U + 3U);
  EXPECT_DOUBLE_EQ(groups.unseen_near.rmse_m, 0.0);
  EXPECT_EQ(groups.unseen_far.cells, 100U - 3U - 24U);
  EXPECT_DOUBLE_EQ(groups.unseen_far.bias_m, 3.0 / 73.0);
  EXPECT_EQ(figures.all.cells, 100U);
}

TEST(TerrainMetrics, WhereNothingWasSeenAllIsFar) {
  Terrain terrain;
  terrain.density.assign(100, kNone);
  const TerrainFigures figures = terrain.figures();
  EXPECT_EQ(figures.by_density->unseen_far.cells, 100U);
  EXPECT_FALSE(figures.offset.of_dense);
}

TEST(TerrainMetrics, ThePapersSelectionHasTwentySevenPointsAMetreSquared) {
  // 27 points per m² are 6.75 in a cell of 0.25 m².
  Terrain terrain;
  terrain.count.assign(100, 6.0F);
  terrain.count[5] = 7.0F;
  terrain.count[6] = 1000.0F;
  terrain.count[7] = kNone;
  terrain.estimated[5] = 20.125F;
  terrain.estimated[6] = kNone;
  const TerrainFigures figures = terrain.figures();
  ASSERT_TRUE(figures.paper);
  EXPECT_EQ(figures.paper->cells, 2U);
  EXPECT_EQ(figures.paper->covered, 1U);
  EXPECT_DOUBLE_EQ(figures.paper->rmse_m, 0.125);
}

TEST(TerrainMetrics, TheOffsetIsTheMedianOfDenseCells) {
  Terrain terrain;
  terrain.density.assign(100, 1.0F);
  terrain.density[0] = terrain.density[1] = terrain.density[2] = 30.0F;
  for (float& height : terrain.estimated) height = 25.0F;
  terrain.estimated[0] = 20.25F;
  terrain.estimated[1] = 20.5F;
  terrain.estimated[2] = 29.0F;
  const TerrainFigures reported = terrain.figures();
  EXPECT_DOUBLE_EQ(reported.offset.median_m, 0.5);
  EXPECT_EQ(reported.offset.cells, 3U);
  EXPECT_TRUE(reported.offset.of_dense);
  EXPECT_FALSE(reported.offset.taken_out);
  EXPECT_DOUBLE_EQ(reported.by_density->sparse.bias_m, 5.0);
  const TerrainFigures taken_out = terrain.figures(OffsetUse::taken_out);
  EXPECT_DOUBLE_EQ(taken_out.offset.median_m, 0.5);
  EXPECT_TRUE(taken_out.offset.taken_out);
  EXPECT_DOUBLE_EQ(taken_out.by_density->sparse.bias_m, 4.5);
}

TEST(TerrainMetrics, WithoutDensityTheOffsetIsThatOfAllCells) {
  Terrain terrain;
  for (float& height : terrain.estimated) height -= 1.5F;
  const TerrainFigures figures = terrain.figures(OffsetUse::taken_out);
  EXPECT_DOUBLE_EQ(figures.offset.median_m, -1.5);
  EXPECT_EQ(figures.offset.cells, 100U);
  EXPECT_FALSE(figures.offset.of_dense);
  EXPECT_DOUBLE_EQ(figures.all.rmse_m, 0.0);
}

TEST(TerrainMetrics, WithoutCoveredCellsThereIsNoOffset) {
  Terrain terrain;
  terrain.estimated.assign(100, kNone);
  const TerrainFigures figures = terrain.figures(OffsetUse::taken_out);
  EXPECT_EQ(figures.offset.cells, 0U);
  EXPECT_FALSE(figures.offset.taken_out);
  EXPECT_EQ(figures.all.coverage(), 0.0);
}

TEST(TerrainMetrics, SortByDistanceFromThePath) {
  Terrain terrain;
  terrain.path_distance.assign(100, 45.0F);
  terrain.path_distance[0] = 0.0F;
  terrain.path_distance[1] = 4.99F;
  terrain.path_distance[2] = 5.0F;
  terrain.path_distance[3] = 19.0F;
  terrain.path_distance[4] = 20.0F;
  std::vector<std::uint64_t> cells;
  std::vector<double> begins;
  for (const TerrainBin& bin : terrain.figures().by_path_distance) {
    cells.push_back(bin.errors.cells);
    begins.push_back(bin.from);
  }
  EXPECT_EQ(begins, (std::vector<double>{0.0, 5.0, 10.0, 20.0, 40.0}));
  EXPECT_EQ(cells, (std::vector<std::uint64_t>{2, 1, 1, 1, 95}));
}

TEST(TerrainMetrics, TakeMasksAsTheyAre) {
  Terrain terrain;
  std::vector<float> kerb(100, 0.0F);
  kerb[3] = 1.0F;
  kerb[4] = -255.0F;
  kerb[5] = kNone;
  terrain.estimated[3] = 20.25F;
  TerrainLayers layers = terrain.layers();
  layers.masks.push_back({"kerb", kerb});
  const TerrainFigures figures = compare_terrain(layers, OffsetUse::reported);
  ASSERT_EQ(figures.by_mask.size(), 1U);
  EXPECT_EQ(figures.by_mask[0].name, "kerb");
  EXPECT_EQ(figures.by_mask[0].errors.cells, 2U);
  EXPECT_DOUBLE_EQ(figures.by_mask[0].errors.bias_m, 0.125);
}

TEST(TerrainMetrics, RefuseLayersOfAnotherSize) {
  const Terrain whole;
  const std::vector<float> short_layer(99);
  const auto refuses = [&](auto change) {
    TerrainLayers layers = whole.layers();
    change(layers);
    EXPECT_THROW((void)compare_terrain(layers, OffsetUse::reported), std::invalid_argument);
  };
  refuses([&](TerrainLayers& layers) { layers.estimated_m = short_layer; });
  refuses([&](TerrainLayers& layers) { layers.reference_m = short_layer; });
  refuses([&](TerrainLayers& layers) { layers.density = short_layer; });
  refuses([&](TerrainLayers& layers) { layers.count = short_layer; });
  refuses([&](TerrainLayers& layers) { layers.path_distance_m = short_layer; });
  refuses([&](TerrainLayers& layers) { layers.masks.push_back({"kerb", short_layer}); });
}

TEST(Slope, IsTheSteepestRise) {
  // 3 along x and 4 along y per metre, on cells of 0.5 m × 2 m.
  const CellLattice lattice{3, 3, 0.5, 2.0};
  std::vector<float> heights;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      heights.push_back(1.5F * static_cast<float>(column) - 8.0F * static_cast<float>(row));
  for (const float percent : slope_percent(heights, lattice)) EXPECT_FLOAT_EQ(percent, 500.0F);
}

TEST(Slope, LooksToOneSideAtHoles) {
  const CellLattice lattice{4, 2, 1.0, 1.0};
  const std::vector<float> heights{0.0F, 0.5F, kNone, 9.0F,  //
                                   0.0F, 0.5F, kNone, 9.0F};
  const std::vector<float> slope = slope_percent(heights, lattice);
  EXPECT_FLOAT_EQ(slope[0], 50.0F);
  EXPECT_FLOAT_EQ(slope[1], 50.0F);
  EXPECT_TRUE(std::isnan(slope[2]));
  EXPECT_TRUE(std::isnan(slope[3])) << "neither neighbour along x has a height";
}

}  // namespace
}  // namespace groundgrid::evaluation
