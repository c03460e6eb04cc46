#include "io/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/number_list.hpp"

namespace groundgrid::io {
namespace {

// The transform in the first line that begins with one of these words, which may be followed by a
// colon. A file that has its transform alone in its only line is read without words.
Eigen::Isometry3d read_transform(const std::filesystem::path& path,
                                 std::span<const std::string_view> names,
                                 const std::string& remedy) {
  const std::string text = read_text(path);
  const std::vector<std::string_view> lines = split_lines(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string_view line = lines[i];
    const auto name_end = line.find_first_of(": \t");
    if (!names.empty()) {
      if (name_end == std::string_view::npos ||
          std::find(names.begin(), names.end(), line.substr(0, name_end)) == names.end())
        continue;
      line.remove_prefix(name_end + (line[name_end] == ':' ? 1U : 0U));
    }
    try {
      return parse_rigid_transform(line);
    } catch (const std::invalid_argument& problem) {
      throw Error({.file = path,
                   .line = i + 1,
                   .expected = fmt::format("the twelve numbers of a rigid transform{}{}",
                                           names.empty() ? "" : " after ",
                                           names.empty() ? "" : names.front()),
                   .got = problem.what(),
                   .remedy = "use --single-scan to do without poses"});
    }
  }
  throw Error({.file = path,
               .expected = names.empty()
                               ? "a line with the twelve numbers of a rigid transform"
                               : fmt::format("a line '{}:' with a mounting", names.front()),
               .got = "none",
               .remedy = remedy});
}

}  // namespace

Eigen::Isometry3d read_lidar_calibration(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 3> kNames{"Tr", "Tr_velo_cam", "Tr_velo_to_cam"};
  return read_transform(path, kNames,
                        "add it (KITTI's calibration archive has it), or use --single-scan to do "
                        "without poses");
}

Eigen::Isometry3d read_kitti_360_mounting(const std::filesystem::path& folder) {
  constexpr std::array<std::string_view, 1> kName{"image_00"};
  const std::string remedy =
      "take the folder from KITTI-360's calibration archive, or use --single-scan to do without "
      "poses";
  const Eigen::Isometry3d T_vehicle_camera =
      read_transform(folder / "calib_cam_to_pose.txt", kName, remedy);
  const Eigen::Isometry3d T_lidar_camera =
      read_transform(folder / "calib_cam_to_velo.txt", {}, remedy);
  return T_vehicle_camera * T_lidar_camera.inverse();
}

}  // namespace groundgrid::io
