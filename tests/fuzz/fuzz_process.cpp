// Any scans, poses and parameters: process() answers every point or throws std::invalid_argument,
// and neither threads nor the order of the points change a bit.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "groundgrid/parameters.hpp"
#include "input_bytes.hpp"
#include "require.hpp"

namespace groundgrid::fuzz {
namespace {

using Pose = Eigen::Isometry3d;

constexpr unsigned kMaxCells = 48;
constexpr std::size_t kMaxPoints = 2000;

struct Record {
  float x, y, z;
  double time;
};

struct Call {
  std::deque<std::vector<Record>> clouds;
  std::vector<SensorScan> scans;
  Pose begin;
  Pose end;
  bool within_scan = false;
};

Config any_config(InputBytes& bytes) {
  Config config = bytes.below(4) == 0 ? Config::paper() : Config{};
  config.map.resolution_m = 0.05 * (7 + bytes.below(40));  // the least map is 3 m wide
  config.map.extent_m = config.map.resolution_m * (9 + bytes.below(kMaxCells - 8));
  const unsigned changes = bytes.below(8);
  for (unsigned i = 0; i < changes; ++i) {
    const auto all = parameters();
    const Parameter& parameter = all[bytes.below(static_cast<unsigned>(all.size()))];
    // A large map would only be slow.
    if (parameter.name == "resolution_m" || parameter.name == "extent_m") continue;
    std::string value = std::to_string(bytes.number());
    const unsigned others = parameter.name == "anchor_m"            ? 1
                            : parameter.name == "ego_vehicle_box_m" ? 5
                                                                    : 0;
    for (unsigned other = 0; other < others; ++other) value += ',' + std::to_string(bytes.number());
    if (bytes.below(8) == 0) value = bytes.text(4);
    try {
      set_parameter(config, parameter.name, value);
    } catch (const std::invalid_argument&) {
      // The range has refused it.
    }
  }
  return config;
}

Pose any_pose(InputBytes& bytes) {
  Pose pose = Pose::Identity();
  if (bytes.below(4) == 0) return pose;
  for (int axis = 0; axis < 3; ++axis) pose.translation()(axis) = bytes.number();
  const double yaw = 0.1 * bytes.take<std::int8_t>();
  const double pitch = 0.02 * bytes.take<std::int8_t>();
  pose.linear() = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()))
                      .toRotationMatrix();
  if (bytes.below(16) == 0) pose.linear()(bytes.below(3), bytes.below(3)) = bytes.number();
  return pose;
}

// Points one by one, and pieces of planes, which make cells that are ground.
std::vector<Record> any_cloud(InputBytes& bytes) {
  std::vector<Record> cloud;
  const unsigned parts = bytes.below(24);
  for (unsigned part = 0; part < parts && cloud.size() < kMaxPoints; ++part) {
    const double x = bytes.number(), y = bytes.number(), z = bytes.number();
    const double time = bytes.number();
    const unsigned side = bytes.below(4) == 0 ? 1 + bytes.below(20) : 1;
    const double slope = side > 1 ? 0.05 * bytes.take<std::int8_t>() : 0.0;
    for (unsigned i = 0; i < side * side; ++i) {
      const double dx = 0.2 * (i % side), dy = 0.2 * (i / side);
      cloud.push_back({static_cast<float>(x + dx), static_cast<float>(y + dy),
                       static_cast<float>(z + slope * dx), time + 0.001 * i});
    }
  }
  return cloud;
}

SensorScan any_scan(InputBytes& bytes, const std::vector<Record>& cloud) {
  SensorScan scan;
  scan.points.data = reinterpret_cast<const std::byte*>(cloud.data());
  scan.points.count = cloud.size();
  scan.points.stride_bytes = sizeof(Record);
  const unsigned flaw = bytes.below(32);
  if (flaw == 3) scan.points.count = bytes.take<std::uint64_t>() | (std::uint64_t{1} << 40U);
  if (flaw == 0) scan.points.z_offset = bytes.take<std::uint64_t>();
  if (flaw == 1) scan.points.data = nullptr;
  if (flaw == 2) scan.points.stride_bytes = bytes.below(sizeof(Record));
  if (bytes.below(2) == 0) scan.points.time_offset = offsetof(Record, time);
  scan.points.time_type = static_cast<TimeType>(bytes.below(3));
  if (bytes.below(2) == 0) scan.T_base_sensor = any_pose(bytes);
  scan.time_begin = bytes.number();
  scan.time_end = scan.time_begin + bytes.number();
  return scan;
}

Call any_call(InputBytes& bytes) {
  Call call;
  const unsigned sensors = bytes.below(4);
  for (unsigned i = 0; i < sensors; ++i)
    call.scans.push_back(any_scan(bytes, call.clouds.emplace_back(any_cloud(bytes))));
  call.end = any_pose(bytes);
  call.within_scan = bytes.below(2) == 0;
  call.begin = bytes.below(2) == 0 ? any_pose(bytes) : call.end;
  return call;
}

// Whether the view is that of the records. With other offsets the points are not the records, and
// cannot be turned round by turning the records.
bool shows_records(const PointView& view) {
  return view.stride_bytes == sizeof(Record) && view.z_offset == offsetof(Record, z);
}

// The same call with the points of every sensor from the last to the first.
Call turned_round(const Call& call) {
  Call turned = call;
  for (std::size_t i = 0; i < turned.clouds.size(); ++i) {
    PointView& view = turned.scans[i].points;
    if (shows_records(view)) std::reverse(turned.clouds[i].begin(), turned.clouds[i].end());
    view.data = reinterpret_cast<const std::byte*>(turned.clouds[i].data());
  }
  return turned;
}

ScanResult process(GroundGrid& grid, const Call& call) {
  ScanRequest request{.scans = call.scans, .T_map_base = call.end};
  if (call.within_scan) request.T_map_base_begin = call.begin;
  return grid.process(request);
}

void check_result(const ScanResult& result, const Call& call) {
  std::size_t points = 0;
  for (const auto& cloud : call.clouds) points += cloud.size();
  require(result.labels.size() == points, "one label for each point");
  require(result.height_above_ground.size() == points, "one height for each point");
  std::array<std::size_t, 4> counts{};
  for (std::size_t i = 0; i < points; ++i) {
    const auto label = static_cast<std::size_t>(result.labels[i]);
    require(label < counts.size(), "a label is one of four");
    ++counts[label];
    const float height = result.height_above_ground[i];
    require(std::isnan(height) == (result.labels[i] == Label::unknown), "NaN where unknown");
    require(!std::isinf(height), "heights are finite");
  }
  const auto count_of = [&counts](Label label) { return counts[static_cast<std::size_t>(label)]; };
  require(result.ground == count_of(Label::ground), "ground is counted");
  require(result.obstacle == count_of(Label::obstacle), "obstacles are counted");
  require(result.outlier == count_of(Label::outlier), "outliers are counted");
  require(result.unknown == count_of(Label::unknown), "unknown points are counted");
  require(!result.sensor_height_m || std::isfinite(*result.sensor_height_m), "a height is finite");
}

struct Terrain {
  double min_x_m, min_y_m, z_origin_m;
  std::vector<float> height, confidence;
  bool operator==(const Terrain&) const = default;
};

Terrain terrain_of(const GroundGrid& grid) {
  const TerrainView view = grid.terrain();
  const auto cells = static_cast<std::size_t>(view.size) * static_cast<std::size_t>(view.size);
  require(view.relative_height.size() == cells && view.confidence.size() == cells &&
              (cells == 0 || view.statistics != nullptr),
          "the map has one value for each cell");
  for (const float height : view.relative_height) require(std::isfinite(height), "heights exist");
  for (const float confidence : view.confidence)
    require(confidence >= 0.0F && confidence <= 1.0F, "confidence is from 0 to 1");
  return {view.min_x_m,
          view.min_y_m,
          view.z_origin_m,
          {view.relative_height.begin(), view.relative_height.end()},
          {view.confidence.begin(), view.confidence.end()}};
}

void check_same(const ScanResult& one, const ScanResult& turned, const Call& call) {
  std::size_t first = 0;
  for (const SensorScan& scan : call.scans) {
    const std::size_t count = scan.points.count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t here = first + i;
      const std::size_t there = shows_records(scan.points) ? first + count - 1 - i : here;
      require(one.labels[here] == turned.labels[there], "labels do not depend on the order");
      const float height = one.height_above_ground[here];
      require(std::isnan(height) || height == turned.height_above_ground[there],
              "heights do not depend on the order");
    }
    first += count;
  }
  require(one.sensor_height_m == turned.sensor_height_m, "nor does the sensor's height");
}

void run(InputBytes bytes) {
  const Config config = any_config(bytes);
  GroundGrid grid(config);
  GroundGrid other(config, 2);
  const unsigned calls = 1 + bytes.below(5);
  for (unsigned i = 0; i < calls && !bytes.empty(); ++i) {
    if (bytes.below(8) == 0) {
      grid.reset();
      other.reset();
      require(grid.terrain().size == 0, "reset() forgets the map");
    }
    const Call call = any_call(bytes);
    const Terrain before = terrain_of(grid);
    ScanResult result;
    try {
      result = process(grid, call);
    } catch (const std::invalid_argument&) {
      require(terrain_of(grid) == before, "a refused call leaves the map as it was");
      continue;
    }
    check_result(result, call);
    check_same(result, process(other, turned_round(call)), call);
    require(terrain_of(grid) == terrain_of(other), "the map does not depend on threads or order");
  }
}

}  // namespace
}  // namespace groundgrid::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  groundgrid::fuzz::run(groundgrid::fuzz::InputBytes({data, size}));
  return 0;
}
