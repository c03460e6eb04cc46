#include "program/scan_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "groundgrid/ground_grid.hpp"
#include "program/scan_reading.hpp"

namespace groundgrid::program {
namespace {

using Json = nlohmann::ordered_json;

// A sensor's ground is where many points lie at one height: this close to it, this near.
constexpr float kLevelBand_m = 0.2F;
constexpr float kLevelReach_m = 20.0F;
// Half of a scan's points nearer than this: no vehicle is so small.
constexpr double kNear_m = 0.2;

FieldSummary field_summary(const io::PointCloud& cloud, const io::PointField& field) {
  FieldSummary summary{field};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double value = io::value_at(cloud, i, field);
    if (!std::isfinite(value)) continue;
    summary.least = std::fmin(summary.least, value);
    summary.greatest = std::fmax(summary.greatest, value);
  }
  return summary;
}

// Adds what the coordinates alone tell.
void add_geometry(ScanSummary& summary, const std::vector<float>& xyz) {
  std::vector<double> ranges;
  const double reach = summary.extent_m / 2.0;
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    const auto x = static_cast<double>(xyz[i]);
    const auto y = static_cast<double>(xyz[i + 1]);
    const auto z = static_cast<double>(xyz[i + 2]);
    const double range = std::hypot(x, y, z);
    if (!std::isfinite(range)) {
      ++summary.not_finite;
    } else if (range == 0.0) {
      ++summary.at_origin;
    } else {
      ranges.push_back(range);
      const double elevation = std::asin(z / range) * 180.0 / std::numbers::pi;
      summary.least_elevation_deg = std::fmin(summary.least_elevation_deg, elevation);
      summary.greatest_elevation_deg = std::fmax(summary.greatest_elevation_deg, elevation);
      const double away = std::max(std::abs(x), std::abs(y));
      if (away >= reach) ++summary.outside_map;
      summary.extent_for_all_m = std::max(summary.extent_for_all_m, 2.0 * away);
    }
  }
  std::sort(ranges.begin(), ranges.end());
  if (ranges.empty()) return;
  summary.least_range_m = ranges.front();
  summary.median_range_m = ranges[ranges.size() / 2];
  summary.greatest_range_m = ranges.back();
}

// Upside down about its x axis, as a LiDAR is mounted under a drone or a bridge.
std::vector<float> turned_over(std::vector<float> xyz) {
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    xyz[i + 1] = -xyz[i + 1];
    xyz[i + 2] = -xyz[i + 2];
  }
  return xyz;
}

std::optional<double> height_of(const std::vector<float>& xyz) {
  return estimate_sensor_height(PointView::from_floats(xyz.data(), xyz.size() / 3, 3));
}

// Points near a level plane at that depth under the sensor.
std::size_t points_at_depth(const std::vector<float>& xyz, float depth) {
  std::size_t points = 0;
  for (std::size_t i = 0; i < xyz.size(); i += 3)
    if (std::hypot(xyz[i], xyz[i + 1]) < kLevelReach_m &&
        std::abs(xyz[i + 2] + depth) < kLevelBand_m)
      ++points;
  return points;
}

bool looks_flipped(const std::vector<float>& xyz, std::optional<double> height) {
  const std::vector<float> turned = turned_over(xyz);
  const std::optional<double> turned_height = height_of(turned);
  if (!turned_height) return false;
  const std::size_t below = height ? points_at_depth(xyz, static_cast<float>(*height)) : 0;
  // Roofs and crowns are above every scan; ground is more than they are.
  return points_at_depth(turned, static_cast<float>(*turned_height)) > 2 * below;
}

std::string_view name_of(io::CloudEncoding encoding) {
  switch (encoding) {
    case io::CloudEncoding::ascii:
      return "ascii";
    case io::CloudEncoding::binary:
      return "binary";
    case io::CloudEncoding::binary_big_endian:
      return "binary_big_endian";
    case io::CloudEncoding::binary_compressed:
      return "binary_compressed";
  }
  return "";
}

Json or_null(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

std::string format_text(const io::ScanFormat& format) {
  const std::string name = io::name_of(format);
  return format.kind == io::ScanFormat::Kind::bin
             ? fmt::format("{} ({})", name, format.layout.words())
             : name;
}

std::string field_text(const FieldSummary& summary) {
  const std::string numbers =
      summary.field.count > 1 ? fmt::format("[{}]", summary.field.count) : "";
  if (std::isnan(summary.least))
    return fmt::format("    {:<16} {}{}  no finite value\n", summary.field.name,
                       io::name_of(summary.field.type), numbers);
  return fmt::format("    {:<16} {:<8} {:.6g} to {:.6g}\n", summary.field.name,
                     fmt::format("{}{}", io::name_of(summary.field.type), numbers), summary.least,
                     summary.greatest);
}

}  // namespace

ScanSummary summary_of(const io::ScanFile& scan, const ScanSlot& slot, double extent_m) {
  const io::PointCloud& cloud = slot.cloud;
  ScanSummary summary{.file = scan,
                      .encoding = cloud.encoding,
                      .width = cloud.width,
                      .height = cloud.height,
                      .points = cloud.size(),
                      .surplus_bytes = cloud.surplus_bytes,
                      .extent_m = extent_m};
  for (const io::PointField& field : cloud.fields)
    summary.fields.push_back(field_summary(cloud, field));
  summary.viewpoint_remark = viewpoint_remark(cloud);
  std::vector<float> xyz;
  copy_coordinates(slot.points, xyz);
  add_geometry(summary, xyz);
  summary.sensor_height_m = height_of(xyz);
  summary.looks_flipped = looks_flipped(xyz, summary.sensor_height_m);
  return summary;
}

std::vector<std::string> ScanSummary::remarks() const {
  std::vector<std::string> remarks;
  const std::size_t usable = points - not_finite - at_origin;
  if (points == 0) remarks.emplace_back("The file holds no points.");
  if (points > 0 && usable == 0)
    remarks.emplace_back("No point is a measurement: all are NaN, infinite or at the origin.");
  if (surplus_bytes > 0)
    remarks.push_back(fmt::format(
        "{} bytes after the last point are left out: does the header promise too few points?",
        surplus_bytes));
  if (!viewpoint_remark.empty()) remarks.push_back(viewpoint_remark + ".");
  if (looks_flipped)
    remarks.emplace_back(
        "z looks flipped: the ground is above the LiDAR. Is it mounted upside down? Then "
        "--lidar-rpy-deg 180,0,0");
  else if (usable > 0 && !sensor_height_m)
    remarks.emplace_back(
        "No level ground is seen near the LiDAR: is z up? Give --sensor-height-m, or the "
        "mounting by --lidar-rpy-deg");
  if (usable > 0 && outside_map == usable)
    remarks.emplace_back(
        "All points are outside of the map around the LiDAR: coordinates must be metres in the "
        "LiDAR's own frame, not in a map's");
  else if (2 * outside_map > usable)
    remarks.push_back(fmt::format(
        "{} of {} points are outside of the map around the LiDAR, {} m square, and get no label: "
        "are coordinates metres? Then --extent-m {:.0f} covers all",
        outside_map, usable, extent_m, std::ceil(extent_for_all_m + 1.0)));
  if (median_range_m < kNear_m)
    remarks.push_back(fmt::format(
        "Half of the points are nearer than {:.2g} m: are coordinates metres, not kilometres?",
        median_range_m));
  return remarks;
}

std::string to_text(const ScanSummary& s) {
  const std::string shape =
      s.height > 1 ? fmt::format(", organised {} x {}", s.width, s.height) : "";
  std::string text = fmt::format("  {}: {}, {}, {} points{}\n", s.file.path.string(),
                                 format_text(s.file.format), name_of(s.encoding), s.points, shape);
  for (const FieldSummary& field : s.fields) text += field_text(field);
  if (s.not_finite > 0) text += fmt::format("    {} points are NaN or infinite\n", s.not_finite);
  if (s.at_origin > 0)
    text += fmt::format("    {} points are at the origin: rays without a return\n", s.at_origin);
  if (std::isfinite(s.median_range_m)) {
    text += fmt::format("    range {:.2f} to {:.2f} m, median {:.2f} m\n", s.least_range_m,
                        s.greatest_range_m, s.median_range_m);
    text += fmt::format("    elevation angle {:.1f} to {:.1f} degrees\n", s.least_elevation_deg,
                        s.greatest_elevation_deg);
  }
  if (s.outside_map > 0)
    text += fmt::format("    {} points are outside of the default map ({} m square)\n",
                        s.outside_map, s.extent_m);
  if (s.sensor_height_m)
    text += fmt::format("    LiDAR {:.2f} m above the ground, estimated\n", *s.sensor_height_m);
  for (const std::string& remark : s.remarks()) text += fmt::format("    ! {}\n", remark);
  return text;
}

Json to_json(const ScanSummary& s) {
  Json fields = Json::array();
  for (const FieldSummary& field : s.fields)
    fields.push_back({{"name", field.field.name},
                      {"type", io::name_of(field.field.type)},
                      {"count", field.field.count},
                      {"min", or_null(field.least)},
                      {"max", or_null(field.greatest)}});
  return {{"file", s.file.path.string()},
          {"format", io::name_of(s.file.format)},
          {"encoding", name_of(s.encoding)},
          {"points", s.points},
          {"width", s.width},
          {"height", s.height},
          {"fields", fields},
          {"not_finite", s.not_finite},
          {"at_origin", s.at_origin},
          {"range_m",
           {{"min", or_null(s.least_range_m)},
            {"median", or_null(s.median_range_m)},
            {"max", or_null(s.greatest_range_m)}}},
          {"elevation_deg",
           {{"min", or_null(s.least_elevation_deg)}, {"max", or_null(s.greatest_elevation_deg)}}},
          {"surplus_bytes", s.surplus_bytes},
          {"outside_map", s.outside_map},
          {"sensor_height_m", s.sensor_height_m ? Json(*s.sensor_height_m) : Json(nullptr)},
          {"looks_flipped", s.looks_flipped},
          {"remarks", s.remarks()}};
}

}  // namespace groundgrid::program
