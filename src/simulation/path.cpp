#include "simulation/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace groundgrid::simulation {
namespace {

constexpr double kStep_m = 0.5;
constexpr double kGuessCell_m = 2.0;
constexpr int kRefinements = 4;

Eigen::Vector2d direction(double heading) { return {std::cos(heading), std::sin(heading)}; }

}  // namespace

Path::Path(std::vector<Bend> bends, double length_m, double margin_m)
    : bends_(std::move(bends)), length_m_(length_m), margin_m_(margin_m) {
  lay_out();
  fill_guesses();
}

double Path::heading(double s) const {
  double heading = 0.0;
  for (const Bend& bend : bends_)
    heading += bend.amplitude * (std::sin(2.0 * std::numbers::pi * s / bend.length_m + bend.phase) -
                                 std::sin(bend.phase));
  return heading;
}

void Path::lay_out() {
  const auto before = static_cast<std::size_t>(std::ceil(margin_m_ / kStep_m));
  const auto after = static_cast<std::size_t>(std::ceil((length_m_ + margin_m_) / kStep_m));
  margin_m_ = static_cast<double>(before) * kStep_m;
  centres_.assign(before + after + 2, Eigen::Vector2d::Zero());
  for (std::size_t i = before; i + 1 < centres_.size(); ++i) {
    const double s = (static_cast<double>(i - before) + 0.5) * kStep_m;
    centres_[i + 1] = centres_[i] + kStep_m * direction(heading(s));
  }
  for (std::size_t i = before; i > 0; --i) {
    const double s = (static_cast<double>(i) - static_cast<double>(before) - 0.5) * kStep_m;
    centres_[i - 1] = centres_[i] - kStep_m * direction(heading(s));
  }
  least_ = greatest_ = centres_.front();
  for (const Eigen::Vector2d& centre : centres_) {
    least_ = least_.cwiseMin(centre);
    greatest_ = greatest_.cwiseMax(centre);
  }
  least_.array() -= margin_m_;
  greatest_.array() += margin_m_;
}

void Path::fill_guesses() {
  const Eigen::Vector2d size = (greatest_ - least_) / kGuessCell_m;
  guess_columns_ = static_cast<std::size_t>(std::ceil(size.x()));
  const auto rows = static_cast<std::size_t>(std::ceil(size.y()));
  guesses_.resize(guess_columns_ * rows);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < guess_columns_; ++column)
      guesses_[row * guess_columns_ + column] = static_cast<float>(
          nearest_sample(least_ + kGuessCell_m * Eigen::Vector2d(static_cast<double>(column) + 0.5,
                                                                 static_cast<double>(row) + 0.5)));
}

double Path::nearest_sample(const Eigen::Vector2d& place) const {
  constexpr std::size_t kEvery = 4;
  double best = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < centres_.size(); i += kEvery) {
    const double distance = (centres_[i] - place).squaredNorm();
    if (distance >= best) continue;
    best = distance;
    nearest = i;
  }
  return first() + static_cast<double>(nearest) * kStep_m;
}

Eigen::Vector2d Path::centre(double s) const {
  const double place =
      std::clamp((s - first()) / kStep_m, 0.0, static_cast<double>(centres_.size()) - 1.001);
  const auto index = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(index);
  return (1.0 - share) * centres_[index] + share * centres_[index + 1];
}

Eigen::Vector2d Path::point(Station station) const {
  const Eigen::Vector2d forward = direction(heading(station.s));
  return centre(station.s) + station.d * Eigen::Vector2d(-forward.y(), forward.x());
}

Station Path::project(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d cell = (place - least_) / kGuessCell_m;
  const auto clamped = [](double value, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(count) - 0.5));
  };
  double s = static_cast<double>(
      guesses_[clamped(cell.y(), guesses_.size() / guess_columns_) * guess_columns_ +
               clamped(cell.x(), guess_columns_)]);
  Station station;
  for (int i = 0; i < kRefinements; ++i) {
    const Eigen::Vector2d forward = direction(heading(s));
    const Eigen::Vector2d offset = place - centre(s);
    station = {s, forward.x() * offset.y() - forward.y() * offset.x()};
    s = std::clamp(s + std::clamp(forward.dot(offset), -2.0, 2.0), first(), last());
  }
  return station;
}

}  // namespace groundgrid::simulation
