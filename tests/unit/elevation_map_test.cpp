// The rolling map against one that never forgets where its cells are.
#include "core/map/elevation_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace groundgrid {
namespace {

Config small_map() {
  Config config;
  config.map.resolution_m = 0.5;
  config.map.extent_m = 8.0;
  return config;
}

double height_at(const Plane& plane, double x, double y) {
  return plane.z + plane.offset + plane.slope_x * (x - plane.x) + plane.slope_y * (y - plane.y);
}

/// Heights and confidences by lattice cell, in the map frame.
class Oracle {
 public:
  struct Cell {
    double height;
    float confidence;
  };
  using Index = std::pair<long, long>;

  explicit Oracle(const ElevationMap& map)
      : x0_(map.min_x()), y0_(map.min_y()), cell_size_(map.cell_size()) {}

  Index index(const ElevationMap& map, int column, int row) const {
    return {std::lround((map.min_x() - x0_) / cell_size_) + column,
            std::lround((map.min_y() - y0_) / cell_size_) + row};
  }

  /// Forgets what has left the window and takes the plane for what has come in.
  void follow(const ElevationMap& map, const Plane& plane) {
    std::map<Index, Cell> window;
    for (int row = 0; row < map.size(); ++row) {
      for (int column = 0; column < map.size(); ++column) {
        const Index cell = index(map, column, row);
        const auto known = cells.find(cell);
        const double x = map.min_x() + (column + 0.5) * cell_size_;
        const double y = map.min_y() + (row + 0.5) * cell_size_;
        window[cell] = known == cells.end() ? Cell{height_at(plane, x, y), 0.0F} : known->second;
      }
    }
    cells = std::move(window);
  }

  std::map<Index, Cell> cells;

 private:
  double x0_;
  double y0_;
  double cell_size_;
};

void expect_equal(const ElevationMap& map, const Oracle& oracle, const char* when) {
  for (int row = 0; row < map.size(); ++row) {
    for (int column = 0; column < map.size(); ++column) {
      const auto cell = static_cast<std::size_t>(row * map.size() + column);
      const Oracle::Cell& expected = oracle.cells.at(oracle.index(map, column, row));
      ASSERT_NEAR(map.z_origin() + static_cast<double>(map.height()[cell]), expected.height, 1e-4)
          << when << ", cell " << column << ", " << row;
      ASSERT_EQ(map.confidence()[cell], expected.confidence)
          << when << ", cell " << column << ", " << row;
    }
  }
}

void scribble(ElevationMap& map, Oracle& oracle, std::mt19937& random) {
  std::uniform_real_distribution<float> height(-3.0F, 3.0F);
  std::uniform_real_distribution<float> confidence(0.1F, 1.0F);
  for (int row = 0; row < map.size(); ++row) {
    for (int column = 0; column < map.size(); ++column) {
      if (random() % 4 != 0) continue;
      const auto cell = static_cast<std::size_t>(row * map.size() + column);
      map.height()[cell] = height(random);
      map.confidence()[cell] = confidence(random);
      oracle.cells[oracle.index(map, column, row)] = {
          map.z_origin() + static_cast<double>(map.height()[cell]), map.confidence()[cell]};
    }
  }
}

void expect_centred(const ElevationMap& map, const Plane& plane) {
  const double middle = 0.5 * map.size() * map.cell_size();
  EXPECT_LE(std::abs(map.min_x() + middle - plane.x), 0.5 * map.cell_size() + 1e-9);
  EXPECT_LE(std::abs(map.min_y() + middle - plane.y), 0.5 * map.cell_size() + 1e-9);
}

/// Drives `moves` random steps of up to `step_m` and compares after each.
void drive(double step_m, double climb_m, int moves, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-step_m, step_m);
  std::uniform_real_distribution<double> climb(-climb_m, climb_m);
  std::uniform_real_distribution<double> slope(-0.2, 0.2);
  Plane plane{12.3, -45.6, 7.8, 0.1, -0.05};
  ElevationMap map(small_map());
  map.start(plane);
  Oracle oracle(map);
  oracle.follow(map, plane);
  expect_equal(map, oracle, "start");
  for (int move = 0; move < moves; ++move) {
    scribble(map, oracle, random);
    plane = {plane.x + step(random), plane.y + step(random), plane.z + climb(random),
             slope(random),          slope(random),          climb(random)};
    map.follow(plane);
    oracle.follow(map, plane);
    expect_centred(map, plane);
    ASSERT_NO_FATAL_FAILURE(expect_equal(map, oracle, ("move " + std::to_string(move)).c_str()));
  }
}

TEST(ElevationMap, KeepsItsCellsOverSmallMoves) { drive(0.7, 0.3, 400, 1); }
TEST(ElevationMap, KeepsItsCellsOverMovesOfHalfAWindow) { drive(5.0, 1.0, 300, 2); }
TEST(ElevationMap, StartsAnewWhereNothingOverlaps) { drive(40.0, 1.0, 100, 3); }
TEST(ElevationMap, KeepsHeightsWhenTheZOriginMoves) { drive(0.7, 90.0, 200, 4); }

TEST(ElevationMap, FarJumpsTakeThePlaneEverywhere) {
  ElevationMap map(small_map());
  map.start({0.0, 0.0, 0.0, 0.0, 0.0});
  for (float& confidence : map.confidence()) confidence = 1.0F;
  const Plane far{1e6, -1e6, 500.0, 0.0, 0.0};
  map.follow(far);
  expect_centred(map, far);
  for (const float confidence : map.confidence()) ASSERT_EQ(confidence, 0.0F);
  for (const float height : map.height())
    ASSERT_NEAR(map.z_origin() + static_cast<double>(height), 500.0, 1e-4);
}

TEST(ElevationMap, MovesByWholeCellsOfALatticeAnchoredAtItsStart) {
  ElevationMap map(small_map());
  map.start({100.2, 200.3, 0.0, 0.0, 0.0});
  const double x0 = map.min_x();
  const double y0 = map.min_y();
  // The first pose is the centre of the middle cell: size is 17, 8.5 cells of 0.5 m to the edge.
  EXPECT_EQ(map.size(), 17);
  EXPECT_NEAR(x0, 100.2 - 4.25, 1e-9);
  map.follow({100.2 + 0.24, 200.3 - 0.24, 0.0, 0.0, 0.0});
  EXPECT_EQ(map.min_x(), x0);
  EXPECT_EQ(map.min_y(), y0);
  map.follow({100.2 + 0.26, 200.3 - 0.26, 0.0, 0.0, 0.0});
  EXPECT_NEAR(map.min_x(), x0 + 0.5, 1e-9);
  EXPECT_NEAR(map.min_y(), y0 - 0.5, 1e-9);
}

TEST(ElevationMap, StaysOnItsLatticeWhenItStartsAnew) {
  ElevationMap map(small_map());
  map.start({100.2, 200.3, 0.0, 0.0, 0.0});
  const double x0 = map.min_x();
  const double y0 = map.min_y();
  // 123.4 m are 246.8 cells, 56.3 m are 112.6: to the nearest cell.
  map.start({100.2 + 123.4, 200.3 - 56.3, 0.0, 0.0, 0.0});
  EXPECT_NEAR(map.min_x(), x0 + 247 * 0.5, 1e-9);
  EXPECT_NEAR(map.min_y(), y0 - 113 * 0.5, 1e-9);
}

TEST(ElevationMap, TheLatticeMayBeAnchoredByConfig) {
  Config config = small_map();
  config.map.anchor_m = {10.0, -20.0};
  ElevationMap map(config);
  map.start({123.4, 56.7, 0.0, 0.0, 0.0});
  // Cell centres are at anchor + k · 0.5 m, so edges are a quarter metre off.
  EXPECT_NEAR(std::remainder(map.min_x() - 10.25, 0.5), 0.0, 1e-9);
  EXPECT_NEAR(std::remainder(map.min_y() + 20.25, 0.5), 0.0, 1e-9);
}

TEST(ElevationMap, ResetForgetsTheAnchor) {
  ElevationMap map(small_map());
  map.start({0.0, 0.0, 0.0, 0.0, 0.0});
  map.reset();
  EXPECT_FALSE(map.started());
  map.start({0.2, 0.0, 0.0, 0.0, 0.0});
  EXPECT_NEAR(map.min_x(), 0.2 - 4.25, 1e-9);
}

TEST(ElevationMap, WindowOfAMapMovedByAnExactVectorIsTheSameBits) {
  const Plane here{0.25, -0.5, 1.75, 0.0, 0.0};
  const Plane there{0.25 + 512, -0.5 - 1024, 1.75 + 64, 0.0, 0.0};
  ElevationMap a(small_map());
  ElevationMap b(small_map());
  a.start(here);
  b.start(there);
  a.follow({3.625, 0.125, 1.75, 0.0, 0.0});
  b.follow({3.625 + 512, 0.125 - 1024, 1.75 + 64, 0.0, 0.0});
  EXPECT_EQ(a.window_x(3.625), b.window_x(3.625 + 512));
  EXPECT_EQ(a.window_y(0.125), b.window_y(0.125 - 1024));
  EXPECT_EQ(a.window_z(2.0), b.window_z(2.0 + 64));
  EXPECT_EQ(a.height(), b.height());
}

}  // namespace
}  // namespace groundgrid
