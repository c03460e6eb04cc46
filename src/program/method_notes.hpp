#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "groundgrid/ground_grid.hpp"

namespace groundgrid::program {

/// The least and greatest height of the sensor over the ground that were in use, metres.
struct SensorHeights {
  double least = 0.0;
  double greatest = 0.0;
  bool estimated = false;  ///< In any of the scans.
};

/// What the method found out about a sequence besides the labels.
struct MethodNotes {
  std::optional<SensorHeights> sensor_heights{};  ///< Nothing where no scan ever had one.
  std::size_t map_restarts = 0;                   ///< Scans whose pose jumped.
  std::size_t without_pose = 0;                   ///< Scans that the poses leave out.

  void add(const ScanResult& result);

  /// "sensor 1.73 m above the ground, as given", "sensor 1.70 to 1.75 m above the ground, estimated
  /// scan by scan", "sensor height not found: no flat ground in any scan".
  [[nodiscard]] std::string sensor_words() const;
};

/// Adds `sensor_height`, null where there is none, `map_restarts` and `without_pose` to a
/// sequence's JSON.
void put_notes(nlohmann::ordered_json& json, const MethodNotes& notes);

}  // namespace groundgrid::program
