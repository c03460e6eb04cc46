#include "program/render_map.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "io/error.hpp"
#include "program/terrain_path.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;

bool lies_on(const rendering::HeightGrid& map, const rendering::MapPoint& point) {
  return point.x_m >= map.west_m && point.x_m <= map.west_m + map.width_m() &&
         point.y_m <= map.north_m && point.y_m >= map.north_m - map.height_m();
}

}  // namespace

void PathOptions::add_to(CLI::App& command) {
  CLI::Option* const path = command.add_option(
      "--path", poses_, "Poses of the drive in the terrain's frame, KITTI or TUM, to be drawn");
  command
      .add_option("--calibration", calibration_,
                  "calib.txt whose Tr makes LiDAR poses of the camera poses in --path")
      ->needs(path);
}

void PathOptions::add_files(InputFiles& inputs) const {
  for (const fs::path& file : {poses_, calibration_}) inputs.add(file);
}

std::vector<rendering::MapPoint> PathOptions::read(const rendering::HeightGrid& map) const {
  std::vector<rendering::MapPoint> path;
  if (poses_.empty()) return path;
  for (const Eigen::Vector3d& place :
       read_path(poses_, calibration_.empty() ? std::optional<fs::path>{} : calibration_))
    path.push_back({place.x(), place.y(), place.z()});
  if (std::none_of(path.begin(), path.end(),
                   [&map](const auto& point) { return lies_on(map, point); }))
    throw io::Error({.file = poses_,
                     .expected = "poses on the terrain",
                     .got = "none there",
                     .remedy = "give them in the frame of the terrain; poses.txt of a KITTI "
                               "dataset needs --calibration calib.txt"});
  return path;
}

rendering::HeightGrid grid_of(const geotiff::RasterFrame& frame, std::vector<float> heights_m) {
  const std::array<double, 6>& t = frame.transform;
  rendering::HeightGrid grid{.columns = frame.columns,
                             .rows = frame.rows,
                             .west_m = std::min(t[0], t[0] + frame.columns * t[1]),
                             .north_m = std::max(t[3], t[3] + frame.rows * t[5]),
                             .cell_width_m = std::abs(t[1]),
                             .cell_height_m = std::abs(t[5]),
                             .heights_m = std::move(heights_m)};
  const std::ptrdiff_t columns = frame.columns;
  const auto row = [&grid, columns](int index) { return grid.heights_m.begin() + index * columns; };
  if (t[1] < 0.0)
    for (int i = 0; i < grid.rows; ++i) std::reverse(row(i), row(i + 1));
  if (t[5] > 0.0)
    for (int i = 0; i < grid.rows / 2; ++i)
      std::swap_ranges(row(i), row(i + 1), row(grid.rows - 1 - i));
  return grid;
}

std::string extent_words(const rendering::HeightGrid& grid) {
  return fmt::format("{:.0f} m \u00d7 {:.0f} m, cells of {:.2g} m", grid.width_m(), grid.height_m(),
                     grid.cell_width_m);
}

}  // namespace groundgrid::program
