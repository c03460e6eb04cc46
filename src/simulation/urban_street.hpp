#pragma once

#include <cstdint>
#include <memory>

#include "simulation/path.hpp"
#include "simulation/relief.hpp"
#include "simulation/terrain.hpp"

namespace groundgrid::simulation::urban {

/// @name Layout, metres from the middle of the road
/// @{
inline constexpr double kLane_m = 1.4;
inline constexpr double kLanesEdge_m = 3.15;  ///< Where the parking strips begin.
inline constexpr double kKerb_m = 5.2;
inline constexpr double kPavement_m = 2.3;                   ///< Its width.
inline constexpr double kGardens_m = kKerb_m + kPavement_m;  ///< Where they begin.
inline constexpr double kSideStreet_m = 3.0;                 ///< Half its width.
inline constexpr double kFirstJunction_m = 55.0, kBetweenJunctions_m = 95.0;
inline constexpr double kLot_m = 19.0;  ///< Width of the land of a house.
inline constexpr double kDrive_m =
    2.85;  ///< From the beginning of a lot to the middle of its drive.
/// @}

/// The junction nearest to some s: where it is, and on which side its street leaves.
struct Junction {
  double s;
  double side;
};
Junction junction_near(double s);
bool is_near_junction(double s, double reach_m);

/// What lies between the pavement and a house.
struct Garden {
  enum class Kind : std::uint8_t { paved, level, bank, terrace, sunken };
  Kind kind = Kind::level;
  double rise_m = 0.0;  ///< From the pavement to the house; negative for a sunken one.
  double draw = 0.0;    ///< 0 to 1, for what else may differ.
};

/// The ground of the town.
class Street {
 public:
  Street(std::shared_ptr<const Path> path, std::uint64_t seed);

  Ground operator()(const Eigen::Vector2d& place) const;

  [[nodiscard]] bool has_parking(double s, double d) const;
  /// Of the lot at s, on the side of d.
  [[nodiscard]] Garden garden(double s, double d) const;

 private:
  [[nodiscard]] double draw(std::uint64_t what, double stretch, double d) const;
  [[nodiscard]] Ground across(Station at) const;
  [[nodiscard]] static Ground median(Station at, double before_junction_m);
  [[nodiscard]] Ground road(Station at, const Junction& junction, double into_street) const;
  [[nodiscard]] std::uint16_t road_label(Station at, double into_street) const;
  [[nodiscard]] double kerb(Station at, const Junction& junction) const;
  [[nodiscard]] Ground beside_road(Station at, const Junction& junction, double outside,
                                   double beyond_kerb) const;
  [[nodiscard]] double garden_height(Station at, double into_m) const;

  std::shared_ptr<const Path> path_;
  std::uint64_t seed_;
  Relief relief_;
};

}  // namespace groundgrid::simulation::urban
