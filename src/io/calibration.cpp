#include "io/calibration.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/number_list.hpp"

namespace groundgrid::io {
namespace {

bool names_lidar_mounting(std::string_view word) {
  return word == "Tr" || word == "Tr_velo_cam" || word == "Tr_velo_to_cam";
}

}  // namespace

Eigen::Isometry3d read_lidar_calibration(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  const std::vector<std::string_view> lines = split_lines(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = lines[i];
    const auto name_end = line.find_first_of(": \t");
    if (name_end == std::string_view::npos || !names_lidar_mounting(line.substr(0, name_end)))
      continue;
    try {
      return parse_rigid_transform(line.substr(name_end + (line[name_end] == ':' ? 1U : 0U)));
    } catch (const std::invalid_argument& problem) {
      throw Error({.file = path,
                   .line = i + 1,
                   .expected = "the twelve numbers of a rigid transform after Tr",
                   .got = problem.what(),
                   .remedy = "use --single-scan to do without poses"});
    }
  }
  throw Error({.file = path,
               .expected = "a line 'Tr:' with the mounting of the LiDAR",
               .got = "none",
               .remedy = "add it (KITTI's calibration archive has it), or use --single-scan to do "
                         "without poses"});
}

}  // namespace groundgrid::io
