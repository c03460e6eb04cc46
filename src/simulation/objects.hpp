#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "simulation/mesh.hpp"
#include "simulation/random.hpp"

namespace groundgrid::simulation {

/// SemanticKITTI classes.
namespace label {
inline constexpr std::uint16_t kUnlabeled = 0, kOutlier = 1, kCar = 10, kBicycle = 11, kTruck = 18,
                               kPerson = 30, kBicyclist = 31, kRoad = 40, kParking = 44,
                               kSidewalk = 48, kOtherGround = 49, kBuilding = 50, kFence = 51,
                               kOtherStructure = 52, kLaneMarking = 60, kVegetation = 70,
                               kTrunk = 71, kTerrain = 72, kPole = 80, kTrafficSign = 81,
                               kOtherObject = 99, kMovingCar = 252, kMovingBicyclist = 253,
                               kMovingPerson = 254, kMovingTruck = 258;
}  // namespace label

/// @name Shapes
/// Added to a mesh in its own frame, closed, with a surface that the mesh has.
/// @{
void add_box(Mesh& mesh, const Eigen::Vector3d& least, const Eigen::Vector3d& greatest,
             std::uint32_t surface);

/// An outline in x and z (anticlockwise with x to the right and z up, star-shaped about its mean),
/// drawn out along y; the face above outline edge k has surfaces[k], the two ends have `ends`.
void add_profile(Mesh& mesh, const std::vector<Eigen::Vector2d>& outline, double least_y,
                 double greatest_y, const std::vector<std::uint32_t>& surfaces, std::uint32_t ends);

/// Upright, with `sides` sides, from the middle of its base; its top may have another radius.
void add_cylinder(Mesh& mesh, const Eigen::Vector3d& base, double radius_m, double top_radius_m,
                  double height_m, int sides, std::uint32_t surface);

void add_ellipsoid(Mesh& mesh, const Eigen::Vector3d& centre, const Eigen::Vector3d& radii,
                   std::uint32_t surface);
/// @}

/// @name Objects
/// Each a mesh of its own with z = 0 on the ground and x forward or along.
/// @{
Mesh make_car(Random random, std::uint16_t label, std::uint16_t instance);
Mesh make_lorry(Random random, std::uint16_t label, std::uint16_t instance);
Mesh make_person(Random random, std::uint16_t label, std::uint16_t instance);
Mesh make_cyclist(Random random, std::uint16_t label, std::uint16_t instance);
Mesh make_pole(double height_m, double radius_m);
Mesh make_sign(Random random);
Mesh make_bin(Random random);
Mesh make_rock(Random random);
/// From x = 0 to `length_m`, y = -depth_m to 0; its foot lies 3 m under z = 0, for slopes.
Mesh make_building(Random random, double length_m, double depth_m, double height_m);
/// Along x, `depth_m` thick about y = 0, standing `foot_m` deep in the ground.
Mesh make_wall(double length_m, double depth_m, double height_m, double foot_m,
               std::uint16_t label);
/// @}

/// What grows: wood that stops rays, and leaves as volumes in which they return somewhere.
struct Plant {
  Mesh wood{};
  Mesh leaves{};
};
/// The crown begins at `clearance_m`, and is `radius_m` wide.
Plant make_tree(Random random, double clearance_m, double radius_m, double height_m);
Plant make_conifer(Random random, double clearance_m, double radius_m, double height_m);
Plant make_bush(Random random, double radius_m, double height_m);
Plant make_hedge(double length_m, double depth_m, double height_m);

/// The limits of a random size.
struct Range {
  double least_m = 0.0;
  double most_m = 0.0;
};
/// @name Plants of random sizes
/// @{
Plant make_tree(Random random, Range clearance, Range radius, Range height);
Plant make_conifer(Random random, Range clearance, Range radius, Range height);
Plant make_bush(Random random, Range radius, Range height);
/// @}

}  // namespace groundgrid::simulation
