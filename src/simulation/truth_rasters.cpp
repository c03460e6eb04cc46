#include "simulation/truth_rasters.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace groundgrid::simulation {
namespace {

constexpr double kCell_m = 0.2;
constexpr double kBesides_m = 80.0;
constexpr double kAtKerb_m = 0.3;
constexpr double kStepWidth_m = 0.3;
constexpr double kStepHeight_m = 0.05;
constexpr double kSlopeWidth_m = 1.0;

double slope(const Terrain& terrain, const Eigen::Vector2d& place, double width_m) {
  const double half = width_m / 2.0;
  const auto rise = [&](const Eigen::Vector2d& offset) {
    return (terrain.height(place + offset) - terrain.height(place - offset)) / width_m;
  };
  return std::hypot(rise({half, 0.0}), rise({0.0, half}));
}

}  // namespace

geotiff::RasterGrid grid_around(std::span<const Eigen::Isometry3d> poses) {
  Eigen::Vector2d least = poses.front().translation().head<2>();
  Eigen::Vector2d greatest = least;
  for (const Eigen::Isometry3d& pose : poses) {
    least = least.cwiseMin(pose.translation().head<2>());
    greatest = greatest.cwiseMax(pose.translation().head<2>());
  }
  const auto outward = [](double value) { return std::ceil((value + kBesides_m) / kCell_m); };
  const double west = -outward(-least.x());
  const double south = -outward(-least.y());
  return {west * kCell_m, south * kCell_m, kCell_m,
          static_cast<std::int64_t>(outward(greatest.x()) - west),
          static_cast<std::int64_t>(outward(greatest.y()) - south)};
}

TruthRasters::TruthRasters(const World& world, const geotiff::RasterGrid& grid,
                           Eigen::Vector3d origin, TileRunner& runner)
    : world_(&world), grid_(grid), origin_(std::move(origin)), runner_(&runner) {}

template <typename Function>
std::vector<float> TruthRasters::for_each_cell(const Function& value) const {
  const auto columns = static_cast<std::size_t>(grid_.columns);
  std::vector<float> values(columns * static_cast<std::size_t>(grid_.rows));
  runner_->parallel_for_tiles(static_cast<std::size_t>(grid_.rows), [&](std::size_t row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const Eigen::Vector2d middle(
          grid_.min_x_m + (static_cast<double>(column) + 0.5) * grid_.resolution_m,
          grid_.min_y_m + (static_cast<double>(row) + 0.5) * grid_.resolution_m);
      values[row * columns + column] = value(middle + origin_.head<2>());
    }
  });
  return values;
}

std::vector<float> TruthRasters::heights() const {
  return for_each_cell([&](const Eigen::Vector2d& place) {
    return static_cast<float>(world_->terrain().height(place) - origin_.z());
  });
}

std::vector<float> TruthRasters::under_leaves() const {
  return for_each_cell(
      [&](const Eigen::Vector2d& place) { return world_->is_under_leaves(place) ? 1.0F : 0.0F; });
}

bool TruthRasters::is_step(const Eigen::Vector2d& place) const {
  const Terrain& terrain = world_->terrain();
  const double steep = slope(terrain, place, kStepWidth_m);
  return steep * kStepWidth_m > kStepHeight_m &&
         (steep - slope(terrain, place, kSlopeWidth_m)) * kStepWidth_m > kStepHeight_m;
}

std::vector<float> TruthRasters::at_kerbs() const {
  const std::vector<float> steps =
      for_each_cell([&](const Eigen::Vector2d& place) { return is_step(place) ? 1.0F : 0.0F; });
  std::vector<float> near(steps.size());
  const auto reach = static_cast<std::int64_t>(kAtKerb_m / grid_.resolution_m);
  for (std::int64_t row = 0; row < grid_.rows; ++row)
    for (std::int64_t column = 0; column < grid_.columns; ++column) {
      if (steps[static_cast<std::size_t>(row * grid_.columns + column)] < 0.5F) continue;
      for (std::int64_t y = std::max<std::int64_t>(row - reach, 0);
           y <= std::min(row + reach, grid_.rows - 1); ++y)
        for (std::int64_t x = std::max<std::int64_t>(column - reach, 0);
             x <= std::min(column + reach, grid_.columns - 1); ++x)
          near[static_cast<std::size_t>(y * grid_.columns + x)] = 1.0F;
    }
  return near;
}

}  // namespace groundgrid::simulation
