#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace groundgrid::simulation {

/// A place beside a path: how far along it, and how far to its left. Metres.
struct Station {
  double s = 0.0;
  double d = 0.0;
};

/// One swing of the heading: amplitude in radians, wave length in metres, phase in radians.
struct Bend {
  double amplitude = 0.0;
  double length_m = 1.0;
  double phase = 0.0;
};

/// The centre line of a road. It begins at the origin with heading 0 (along x) at s = 0, where it
/// is extended backward too; the heading is a sum of swings, hence bounded, so that the path never
/// meets itself. What lies at some s does not depend on how long the path is.
class Path {
 public:
  /// Covers s from -`margin_m` to `length_m` + `margin_m`, and places up to `margin_m` beside it.
  Path(std::vector<Bend> bends, double length_m, double margin_m);

  [[nodiscard]] double first() const { return -margin_m_; }
  [[nodiscard]] double last() const { return length_m_ + margin_m_; }

  [[nodiscard]] double heading(double s) const;
  [[nodiscard]] Eigen::Vector2d point(Station station) const;

  /// The station of a place; s stays within first() and last(). Where several points of the path
  /// are equally near it is one of them, which needs a place further off than the tightest radius.
  [[nodiscard]] Station project(const Eigen::Vector2d& place) const;

  /// The rectangle of all places that are covered.
  [[nodiscard]] const Eigen::Vector2d& least() const { return least_; }
  [[nodiscard]] const Eigen::Vector2d& greatest() const { return greatest_; }

 private:
  [[nodiscard]] Eigen::Vector2d centre(double s) const;
  [[nodiscard]] double nearest_sample(const Eigen::Vector2d& place) const;
  void lay_out();
  void fill_guesses();

  std::vector<Bend> bends_;
  double length_m_;
  double margin_m_;
  std::vector<Eigen::Vector2d> centres_;  ///< Every kStep metres from first().
  Eigen::Vector2d least_;
  Eigen::Vector2d greatest_;
  std::size_t guess_columns_ = 0;
  std::vector<float> guesses_;  ///< s of the centre of each square of a coarse grid.
};

}  // namespace groundgrid::simulation
