#include "geotiff/terrain_surface.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace groundgrid::geotiff {
namespace {

// What lies farther from a window's cells than this hardly changes them.
constexpr double kContext_m = 20.0;
// Windows have their middles on multiples of so many cells: the blocks of planes, the first four
// levels of them, are then the same ones in windows side by side, and leave no seam.
constexpr std::int64_t kSharedBlock = 135;
// Over a drive more of what stands about is seen from above: a terrace has to be this wide.
constexpr double kDriveTerraceArea_m2 = 10.0;

/// The plane through heights of cells, least squares, from the middle of the square that they are
/// in; level where they do not span one.
LocalPlane plane_through(std::span<const std::uint32_t> cells, std::span<const float> heights,
                         std::int64_t side, double resolution_m) {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  const std::int64_t middle = side / 2;
  const auto from_middle = [&](std::int64_t i) {
    return static_cast<double>(i - middle) * resolution_m;
  };
  for (const std::uint32_t cell : cells) {
    const Eigen::Vector3d place(1.0, from_middle(cell % side), from_middle(cell / side));
    products += place * place.transpose();
    sums += place * static_cast<double>(heights[cell]);
  }
  // Heights in one line leave the slope across it open: a trace of weight for none settles it.
  products(1, 1) += 1.0;
  products(2, 2) += 1.0;
  const Eigen::Vector3d plane = products.ldlt().solve(sums);
  return {plane.x(), plane.y(), plane.z()};
}

/// The multiple of kSharedBlock that is nearest to the middle of some cells.
std::int64_t shared_middle(std::int64_t first, std::int64_t end) {
  const double blocks = 0.5 * static_cast<double>(first + end) / static_cast<double>(kSharedBlock);
  return std::llround(blocks) * kSharedBlock;
}

}  // namespace

TerrainSurface::TerrainSurface(const std::optional<SurfaceOptions>& options, double resolution_m)
    : resolution_m_(resolution_m), completes_(options.has_value()) {
  if (!options) return;
  reach_ = std::llround(options->reach_m / resolution_m);
  fill_ = options->fill_m / resolution_m;
  for (std::int64_t rows = -reach_; rows <= reach_; ++rows) {
    for (std::int64_t columns = -reach_; columns <= reach_; ++columns) {
      const double distance = std::hypot(static_cast<double>(columns), static_cast<double>(rows));
      if (distance == 0.0 || distance > static_cast<double>(reach_)) continue;
      const double rise = options->step_m + options->max_slope * distance * resolution_m;
      neighbours_.push_back({columns, rows, static_cast<float>(rise)});
    }
  }
  // Near ones decide most often.
  std::sort(neighbours_.begin(), neighbours_.end(),
            [](const Neighbour& a, const Neighbour& b) { return a.rise_m < b.rise_m; });
}

CellRange TerrainSurface::window_around(const CellRange& cells) const {
  const auto context = static_cast<std::int64_t>(std::ceil(kContext_m / resolution_m_));
  const std::int64_t longer = std::max(cells.columns(), cells.rows());
  const std::int64_t half = (longer + kSharedBlock) / 2 + 1 + context;
  const std::int64_t column = shared_middle(cells.first_column, cells.end_column);
  const std::int64_t row = shared_middle(cells.first_row, cells.end_row);
  return {column - half, column + half + 1, row - half, row + half + 1};
}

void TerrainSurface::complete(HeightWindow& window) {
  const auto is_known = [](float height) { return !std::isnan(height); };
  if (std::none_of(window.heights.begin(), window.heights.end(), is_known)) return;
  if (completes_) remove_raised(window);
  fit(window);
}

bool TerrainSurface::is_raised(const HeightWindow& window, std::int64_t column,
                               std::int64_t row) const {
  const float height = window.heights[window.index(column, row)];
  if (std::isnan(height)) return false;
  return std::any_of(neighbours_.begin(), neighbours_.end(), [&](const Neighbour& to) {
    const std::int64_t x = column + to.columns;
    const std::int64_t y = row + to.rows;
    return x >= window.cells.first_column && x < window.cells.end_column &&
           y >= window.cells.first_row && y < window.cells.end_row &&
           height > window.heights[window.index(x, y)] + to.rise_m;
  });
}

void TerrainSurface::remove_raised(HeightWindow& window) const {
  std::vector<std::size_t> raised;
  for (std::int64_t row = window.cells.first_row; row < window.cells.end_row; ++row)
    for (std::int64_t column = window.cells.first_column; column < window.cells.end_column;
         ++column)
      if (is_raised(window, column, row)) raised.push_back(window.index(column, row));
  for (const std::size_t cell : raised) window.heights[cell] = std::nanf("");
}

void TerrainSurface::make_room(const HeightWindow& window) {
  const std::int64_t longer = std::max(window.cells.columns(), window.cells.rows());
  const std::int64_t side = longer + (longer + 1) % 2;
  if (side != side_) {
    side_ = side;
    planes_.emplace(static_cast<int>(side), resolution_m_, runner_);
    const auto cells = static_cast<std::size_t>(side * side);
    heights_.resize(cells);
    deviations_.resize(cells);
    surface_.resize(cells);
    near_.resize(cells);
  }
  known_.clear();
  std::fill(planes_->heights().begin(), planes_->heights().end(), kUnknownHeight);
  std::fill(heights_.begin(), heights_.end(), 0.0F);
}

bool TerrainSurface::is_known(const HeightWindow& window, std::int64_t column,
                              std::int64_t row) const {
  return column >= window.cells.first_column && column < window.cells.end_column &&
         row >= window.cells.first_row && row < window.cells.end_row &&
         planes_->is_ground(static_cast<std::uint32_t>(in_square(window, column, row)));
}

/// Whether a known cell has a side that lies open. From one that has none every gap is farther than
/// from one of its neighbours.
bool TerrainSurface::is_rim(const HeightWindow& window, std::int64_t column,
                            std::int64_t row) const {
  return is_known(window, column, row) &&
         !(is_known(window, column - 1, row) && is_known(window, column + 1, row) &&
           is_known(window, column, row - 1) && is_known(window, column, row + 1));
}

/// Marks the gaps that are so near to known cells that they may be filled.
void TerrainSurface::spread_known(const HeightWindow& window) {
  std::fill(near_.begin(), near_.end(), std::uint8_t{0});
  const auto reach = static_cast<std::int64_t>(fill_);
  for (std::int64_t row = window.cells.first_row; row < window.cells.end_row; ++row) {
    for (std::int64_t column = window.cells.first_column; column < window.cells.end_column;
         ++column) {
      if (!is_rim(window, column, row)) continue;
      for (std::int64_t y = std::max(row - reach, window.cells.first_row);
           y <= std::min(row + reach, window.cells.end_row - 1); ++y) {
        const auto rows = static_cast<double>(y - row);
        const auto half = static_cast<std::int64_t>(std::sqrt(fill_ * fill_ - rows * rows));
        const std::int64_t first = std::max(column - half, window.cells.first_column);
        const std::int64_t last = std::min(column + half, window.cells.end_column - 1);
        std::uint8_t* const begin = near_.data() + in_square(window, first, y);
        std::fill(begin, begin + (last - first + 1), std::uint8_t{1});
      }
    }
  }
}

void TerrainSurface::fit(HeightWindow& window) {
  make_room(window);
  std::optional<float> base;
  const auto for_each_cell = [&](const auto& visit) {
    for (std::int64_t row = window.cells.first_row; row < window.cells.end_row; ++row)
      for (std::int64_t column = window.cells.first_column; column < window.cells.end_column;
           ++column)
        visit(window.index(column, row),
              static_cast<std::uint32_t>(in_square(window, column, row)));
  };
  for_each_cell([&](std::size_t own, std::uint32_t cell) {
    if (std::isnan(window.heights[own])) return;
    if (!base) base = window.heights[own];
    heights_[cell] = window.heights[own] - *base;
    planes_->heights()[cell] = heights_[cell];
    known_.push_back(cell);
  });
  const LocalPlane top = plane_through(known_, heights_, side_, resolution_m_);
  if (completes_)
    planes_->reject_raised(top, kDriveTerraceArea_m2);
  else
    planes_->accept_all();
  planes_->fit(heights_, top);
  planes_->evaluate(surface_);
  spread_known(window);
  for_each_cell([&](std::size_t own, std::uint32_t cell) {
    if (planes_->is_ground(cell)) return;
    heights_[cell] = surface_[cell];
    window.heights[own] = near_[cell] != 0 ? heights_[cell] + *base : std::nanf("");
  });
  planes_->standard_deviation(heights_, deviations_);
  for_each_cell([&](std::size_t own, std::uint32_t cell) {
    if (!std::isnan(window.heights[own])) window.deviations[own] = deviations_[cell];
  });
}

}  // namespace groundgrid::geotiff
