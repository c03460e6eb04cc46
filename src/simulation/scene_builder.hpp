#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "simulation/objects.hpp"
#include "simulation/random.hpp"
#include "simulation/scene.hpp"

namespace groundgrid::simulation {

/// From one number to less than another, evenly: the stations of what stands in a row.
std::vector<double> every(double step_m, double from_m, double to_m);

/// A place within `length_m` of path from s on, and between two distances beside it; `side` is 1
/// left of the path, -1 right of it.
inline Station somewhere_beside(Random& random, double s, double length_m, double side,
                                Range away) {
  const double along = s + random.uniform(0.0, length_m);
  return {along, side * random.uniform(away.least_m, away.most_m)};
}

/// Puts objects beside the path of a scene.
class SceneBuilder {
 public:
  SceneBuilder(std::uint64_t seed, std::vector<Bend> bends, double length_m);

  [[nodiscard]] const Path& path() const { return *scene_.path; }
  [[nodiscard]] const std::shared_ptr<const Path>& shared_path() const { return scene_.path; }
  void set_ground(GroundFunction ground) { scene_.ground = std::move(ground); }
  void set_lane(double lane_m) { scene_.lane_m = lane_m; }
  [[nodiscard]] double height(Station station) const;

  /// A fresh source of randomness for what is placed next.
  [[nodiscard]] Random next_random() { return Random(hash({seed_, ++objects_})); }
  [[nodiscard]] std::uint16_t next_instance() { return ++instances_; }

  /// The object stands upright on the ground at the station, turned from the path's heading.
  void place(const Mesh& object, Station station, double turn = 0.0);
  void place(const Plant& plant, Station station, double turn = 0.0);
  /// The same for what stands on wheels: tilted as the ground is.
  void park(const Mesh& object, Station station, double turn);
  void add_mover(Mesh mesh, Station start, double speed_mps);

  Scene finish() { return std::move(scene_); }

 private:
  [[nodiscard]] Eigen::Isometry3d pose(Station station, double turn) const;

  std::uint64_t seed_;
  std::uint64_t objects_ = 0;
  std::uint16_t instances_ = 0;
  Scene scene_;
};

}  // namespace groundgrid::simulation
