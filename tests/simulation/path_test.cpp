#include "simulation/path.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace groundgrid::simulation {
namespace {

TEST(Path, WithoutBendsIsTheXAxis) {
  const Path path({}, 50.0, 20.0);
  EXPECT_DOUBLE_EQ(path.first(), -20.0);
  EXPECT_DOUBLE_EQ(path.last(), 70.0);
  EXPECT_NEAR((path.point({12.5, 3.0}) - Eigen::Vector2d(12.5, 3.0)).norm(), 0.0, 1e-9);
  const Station station = path.project({12.3, -4.0});
  EXPECT_NEAR(station.s, 12.3, 1e-6);
  EXPECT_NEAR(station.d, -4.0, 1e-6);
}

TEST(Path, BeginsAtTheOriginAlongX) {
  const Path path({{0.5, 80.0, 1.0}, {0.2, 30.0, 2.0}}, 100.0, 30.0);
  EXPECT_NEAR(path.heading(0.0), 0.0, 1e-12);
  EXPECT_NEAR(path.point({0.0, 0.0}).norm(), 0.0, 1e-9);
}

TEST(Path, ProjectingAPlaceBesideItGivesItsStationBack) {
  const Path path({{0.5, 150.0, 1.0}, {0.1, 60.0, 2.0}}, 200.0, 30.0);
  for (double s = -20.0; s < 220.0; s += 7.3)
    for (const double d : {-8.0, -1.5, 0.0, 3.0, 12.0}) {
      const Station station = path.project(path.point({s, d}));
      EXPECT_NEAR(station.s, s, 0.05) << s << ' ' << d;
      EXPECT_NEAR(station.d, d, 0.02) << s << ' ' << d;
    }
}

TEST(Path, ItsBeginningDoesNotDependOnItsLength) {
  const std::vector<Bend> bends{{0.4, 90.0, 0.3}};
  const Path shorter(bends, 50.0, 20.0);
  const Path longer(bends, 500.0, 20.0);
  for (double s = -20.0; s < 60.0; s += 3.1)
    EXPECT_EQ(shorter.point({s, 1.0}), longer.point({s, 1.0}));
}

}  // namespace
}  // namespace groundgrid::simulation
