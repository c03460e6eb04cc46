#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "groundgrid/config.hpp"
#include "io/point_cloud.hpp"
#include "io/scan_sequence.hpp"
#include "program/scan_slot.hpp"

namespace groundgrid::program {

inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// One field of a scan and the least and greatest finite value in it; NaN where there is none.
struct FieldSummary {
  io::PointField field;
  double least = kNoNumber;
  double greatest = kNoNumber;
};

/// What is in one scan.
struct ScanSummary {
  io::ScanFile file;
  io::CloudEncoding encoding{};
  std::size_t width = 0;
  std::size_t height = 1;
  std::vector<FieldSummary> fields{};
  std::size_t points = 0;
  std::size_t not_finite = 0;  ///< NaN or infinite x, y or z.
  std::size_t at_origin = 0;   ///< x = y = z = 0: rays that came back to no answer.
  /// Of the points that are left: distance from the LiDAR in metres, angle over the horizontal in
  /// degrees. NaN where there are none.
  double least_range_m = kNoNumber;
  double median_range_m = kNoNumber;
  double greatest_range_m = kNoNumber;
  double least_elevation_deg = kNoNumber;
  double greatest_elevation_deg = kNoNumber;
  std::string viewpoint_remark{};  ///< As viewpoint_remark() has it.
  std::size_t surplus_bytes = 0;   ///< After the last point of a binary file.
  std::size_t outside_map = 0;     ///< Beyond a map of `extent_m`.
  double extent_m = 0.0;           ///< Side of the map, metres.
  double extent_for_all_m = 0.0;   ///< Side of the least map around the LiDAR that has all points.
  /// As estimate_sensor_height() finds it.
  std::optional<double> sensor_height_m{};
  /// The level ground lies above the LiDAR, and it would be below if y and z changed sign.
  bool looks_flipped = false;

  /// What deserves a look, a sentence each.
  [[nodiscard]] std::vector<std::string> remarks() const;
};

/// Of a scan that was read, its points as the slot's view has them, for a map of that side.
ScanSummary summary_of(const io::ScanFile& scan, const ScanSlot& slot,
                       double extent_m = Config{}.map.extent_m);

/// For people, indented lines.
std::string to_text(const ScanSummary& summary);
nlohmann::ordered_json to_json(const ScanSummary& summary);

}  // namespace groundgrid::program
