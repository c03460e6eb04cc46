#include "simulation/ray_caster.hpp"

#include <gtest/gtest.h>

#include "simulation/objects.hpp"

namespace groundgrid::simulation {
namespace {

Mesh unit_box() {
  Mesh mesh;
  add_box(mesh, {2.0, -1.0, -1.0}, {4.0, 1.0, 1.0}, mesh.add_surface({.label = label::kBuilding}));
  return mesh;
}

const Ray kForward{{0.0, 0.1, 0.2}, {1.0, 0.0, 0.0}};

TEST(RayCaster, FindsTheNearestFaceAndItsOutwardNormal) {
  const Mesh box = unit_box();
  const auto hit = RayCaster({&box}).cast(kForward, 0.0, 100.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance_m, 2.0, 1e-6);
  EXPECT_NEAR(hit->normal.x(), -1.0, 1e-6);
  EXPECT_EQ(box.surface(hit->triangle).label, label::kBuilding);
}

TEST(RayCaster, BeginsWhereItIsTold) {
  const Mesh box = unit_box();
  const auto hit = RayCaster({&box}).cast(kForward, 2.5, 100.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance_m, 4.0, 1e-6);
  EXPECT_NEAR(hit->normal.x(), 1.0, 1e-6);
}

TEST(RayCaster, SeesNothingBeyondItsReachOrBesideTheMesh) {
  const Mesh box = unit_box();
  const RayCaster caster({&box});
  EXPECT_FALSE(caster.cast(kForward, 0.0, 1.9));
  EXPECT_FALSE(caster.cast({{0.0, 3.0, 0.0}, {1.0, 0.0, 0.0}}, 0.0, 100.0));
}

TEST(RayCaster, SaysWhichMeshWasHit) {
  const Mesh far = unit_box();
  Mesh near;
  add_ellipsoid(near, {1.0, 0.0, 0.0}, {0.5, 0.5, 0.5}, near.add_surface({}));
  const auto hit = RayCaster({&far, &near}).cast(kForward, 0.0, 100.0);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->mesh, 1U);
  EXPECT_LT(hit->normal.x(), -0.7);
}

TEST(RayCaster, WithoutTrianglesHitsNothing) {
  const Mesh empty;
  EXPECT_FALSE(RayCaster({&empty}).cast(kForward, 0.0, 100.0));
  EXPECT_FALSE(RayCaster({}).cast(kForward, 0.0, 100.0));
}

// Volumes are told from the outside by the way their faces look.
TEST(Shapes, FaceOutward) {
  Mesh mesh;
  const std::uint32_t surface = mesh.add_surface({});
  add_box(mesh, {-1.0, -1.0, 0.0}, {1.0, 1.0, 2.0}, surface);
  add_ellipsoid(mesh, {5.0, 0.0, 1.0}, {1.0, 0.8, 0.9}, surface);
  add_cylinder(mesh, {10.0, 0.0, 0.0}, 1.0, 0.4, 2.0, 8, surface);
  const RayCaster caster({&mesh});
  for (const double x : {0.0, 5.0, 10.0})
    for (int i = 0; i < 200; ++i) {
      Random random(hash({static_cast<std::uint64_t>(i)}));
      const Eigen::Vector3d direction =
          Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
      const auto hit = caster.cast({{x, 0.0, 1.0}, direction}, 0.0, 3.0);
      ASSERT_TRUE(hit);
      EXPECT_GT(hit->normal.dot(direction), 0.0);
    }
}

}  // namespace
}  // namespace groundgrid::simulation
