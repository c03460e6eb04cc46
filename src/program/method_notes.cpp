#include "program/method_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace groundgrid::program {

void MethodNotes::add(const ScanResult& result) {
  if (result.map_restarted) ++map_restarts;
  // The first scans of a sequence may show no ground to find the height from.
  if (!result.sensor_height_m) return;
  const double height = *result.sensor_height_m;
  if (!sensor_heights) sensor_heights = {height, height, false};
  sensor_heights->least = std::min(sensor_heights->least, height);
  sensor_heights->greatest = std::max(sensor_heights->greatest, height);
  sensor_heights->estimated |= result.sensor_height_estimated;
}

std::string MethodNotes::sensor_words() const {
  if (!sensor_heights) return "sensor height not found: no flat ground in any scan";
  const std::string low = fmt::format("{:.2f}", sensor_heights->least);
  const std::string high = fmt::format("{:.2f}", sensor_heights->greatest);
  if (!sensor_heights->estimated)
    return fmt::format("sensor {} m above the ground, as given", high);
  if (low == high) return fmt::format("sensor {} m above the ground, estimated", high);
  return fmt::format("sensor {} to {} m above the ground, estimated scan by scan", low, high);
}

void put_notes(nlohmann::ordered_json& json, const MethodNotes& notes) {
  json["sensor_height"] = nullptr;
  if (const auto& heights = notes.sensor_heights)
    json["sensor_height"] = {
        {"min_m", heights->least}, {"max_m", heights->greatest}, {"estimated", heights->estimated}};
  json["map_restarts"] = notes.map_restarts;
  json["without_pose"] = notes.without_pose;
}

}  // namespace groundgrid::program
