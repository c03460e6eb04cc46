#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "temporary_folder.hpp"

namespace groundgrid::test {

/// One scan of a level street with a wall beside it, seen by a LiDAR 1.73 m above the ground.
struct SyntheticScan {
  std::vector<float> points;          ///< x y z intensity.
  std::vector<std::uint32_t> labels;  ///< 40 road, 50 building.

  SyntheticScan() {
    for (int ring = 0; ring < 40; ++ring)
      for (int step = 0; step < 720; ++step) {
        const double range = 3.0 * std::pow(1.07, ring);
        const double angle = step * std::numbers::pi / 360.0;
        add(range * std::cos(angle), range * std::sin(angle), -1.73, 40);
      }
    for (int column = 0; column < 200; ++column)
      for (int row = 0; row < 20; ++row) add(-10.0 + 0.1 * column, 6.0, -1.4 + 0.15 * row, 50);
  }

  [[nodiscard]] std::size_t size() const { return labels.size(); }

 private:
  void add(double x, double y, double z, std::uint32_t label) {
    // Nothing is seen through the wall.
    if (label == 40 && y > 6.0 && std::abs(x) < 10.0 * y / 6.0) return;
    for (const double value : {x, y, z, 0.5}) points.push_back(static_cast<float>(value));
    labels.push_back(label);
  }
};

/// A dataset in SemanticKITTI layout whose vehicle drives one metre ahead between two scans.
class SyntheticDataset {
 public:
  /// Adds a sequence with calibration, poses and, if wished, labels.
  void add_sequence(const std::string& name, std::size_t scans, bool labelled = true) const {
    const std::filesystem::path sequence = folder / "sequences" / name;
    const SyntheticScan scan;
    std::string poses;
    for (std::size_t i = 0; i < scans; ++i) {
      write_numbers(scan_file(name, i), scan.points);
      if (labelled) write_numbers(label_file(name, i), scan.labels);
      poses += "1 0 0 0 0 1 0 0 0 0 1 " + std::to_string(i) + "\n";
    }
    write_file(sequence / "poses.txt", poses);
    write_file(sequence / "calib.txt", "Tr: 0 -1 0 0 0 0 -1 -0.08 1 0 0 -0.27\n");
  }

  [[nodiscard]] std::filesystem::path path() const { return folder.path(); }

  [[nodiscard]] std::filesystem::path scan_file(const std::string& sequence,
                                                std::size_t number) const {
    return folder / "sequences" / sequence / "velodyne" / (digits(number) + ".bin");
  }
  [[nodiscard]] std::filesystem::path label_file(const std::string& sequence,
                                                 std::size_t number) const {
    return folder / "sequences" / sequence / "labels" / (digits(number) + ".label");
  }

  static std::string digits(std::size_t number) {
    std::string text = std::to_string(number);
    return std::string(6 - text.size(), '0') + text;
  }

  TemporaryFolder folder;
};

}  // namespace groundgrid::test
