// The same bits on every processor, from every set of vector instructions and every compiler:
// hashes of what the core leaves of a drive whose points and poses are the same everywhere. A
// change of the method changes them. A test that fails prints the new ones to put here; `make
// check-arm` then tells whether they hold on Arm.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "support/instruction_sets.hpp"
#include "support/ray_caster.hpp"

namespace groundgrid {
namespace {

using testing::pose;
using testing::SimulatedScan;

/// FNV-1a of 64 bits.
class Hash {
 public:
  template <typename Value>
  void add(const Value& value) {
    for (const std::byte byte : std::as_bytes(std::span(&value, 1)))
      state_ = (state_ ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3U;
  }
  template <typename Value>
  void add_all(std::span<const Value> values) {
    for (const Value& value : values) add(value);
  }
  [[nodiscard]] std::string text() const {
    std::ostringstream text;
    text << std::hex << state_;
    return text.str();
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325U;
};

struct MovingScan {
  SimulatedScan points;
  Eigen::Isometry3d T_map_base_begin;
  Eigen::Isometry3d T_map_base_end;
};

struct Drive {
  Eigen::Isometry3d T_base_sensor;
  std::vector<MovingScan> scans;
};

/// Sine and cosine differ in their last bits from machine to machine, and so does what comes from
/// them. Steps of a power of two leave nothing of that.
float in_steps(float metres) { return std::round(metres * 1024.0F) / 1024.0F; }

Eigen::Isometry3d in_steps(Eigen::Isometry3d T) {
  for (double& value : T.matrix().reshaped()) value = std::round(std::ldexp(value, 30)) / 0x1p30;
  return T;
}

/// Down a street with houses, cars and a kerb at 10 m/s, turning. The map lies askew and far from
/// its origin, the sensor is tilted.
Drive street() {
  testing::Scene scene;
  scene.boxes = {{{-200.0, 9.0, -1.0}, {200.0, 20.0, 8.0}, false},
                 {{-200.0, -30.0, -1.0}, {200.0, -12.0, 6.0}, false},
                 {{-200.0, 5.0, -1.0}, {200.0, 9.0, 0.12}, true},
                 {{8.0, 2.9, -1.0}, {12.2, 4.7, 1.5}, false},
                 {{-6.0, -5.5, -1.0}, {-1.5, -3.5, 2.2}, false},
                 {{25.0, -1.0, -1.0}, {25.5, -0.5, 1.8}, false}};
  Eigen::Isometry3d T_map_street = pose(4612.3, -879.6, 312.9, 37.0);
  T_map_street.rotate(Eigen::AngleAxisd(0.05, Eigen::Vector3d(0.6, 0.8, 0.0)));
  Drive drive{pose(0.3, -0.1, 1.7, -8.0), {}};
  drive.T_base_sensor.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d(0.8, -0.6, 0.0)));
  for (int i = 0; i < 4; ++i) {
    const Eigen::Isometry3d begin = pose(i, 0.1 * i, 0.0, 2.0 * i);
    const Eigen::Isometry3d end = pose(i + 1, 0.1 * (i + 1), 0.0, 2.0 * (i + 1));
    SimulatedScan scan =
        testing::cast_scan(scene, {}, begin, end, drive.T_base_sensor, static_cast<unsigned>(i));
    for (SimulatedScan::Record& record : scan.records)
      for (float* value : {&record.x, &record.y, &record.z}) *value = in_steps(*value);
    drive.scans.push_back(
        {std::move(scan), in_steps(T_map_street * begin), in_steps(T_map_street * end)});
  }
  drive.T_base_sensor = in_steps(drive.T_base_sensor);
  return drive;
}

const Drive& the_drive() {
  static const Drive drive = street();
  return drive;
}

struct Bits {
  std::string labels;
  std::string heights;
  std::string terrain;

  bool operator==(const Bits&) const = default;
};

void PrintTo(const Bits& bits, std::ostream* out) {
  *out << "{\"" << bits.labels << "\", \"" << bits.heights << "\", \"" << bits.terrain << "\"}";
}

/// Collects the answers to every scan and, in the end, the map.
class Answers {
 public:
  explicit Answers(const Config& config) : grid_(config) {}

  void take(const MovingScan& scan, bool corrected) {
    SensorScan view{scan.points.view()};
    view.T_base_sensor = the_drive().T_base_sensor;
    view.time_end = 0.1;
    if (corrected)
      add(grid_.process({.scans = {&view, 1},
                         .T_map_base = scan.T_map_base_end,
                         .T_map_base_begin = scan.T_map_base_begin}));
    else
      add(grid_.process(view, scan.T_map_base_end));
  }
  void take_alone(const MovingScan& scan) {
    grid_.reset();
    add(grid_.process(SensorScan{scan.points.view()}));
  }

  [[nodiscard]] Bits bits() const {
    Hash hash;
    const TerrainView terrain = grid_.terrain();
    hash.add_all(terrain.relative_height);
    hash.add_all(terrain.confidence);
    hash.add_all(grid_.standard_deviation());
    for (const CellStatistics& cell : statistics_of(terrain)) {
      hash.add(cell.sum);
      hash.add(cell.sum_squares);
      hash.add(cell.min);
      hash.add(cell.max);
      hash.add(cell.count);
    }
    return {labels_.text(), heights_.text(), hash.text()};
  }

 private:
  void add(const ScanResult& result) {
    // A lone label, or no height, would make the hashes say little.
    EXPECT_GT(result.ground, 1000U);
    EXPECT_GT(result.obstacle, 1000U);
    labels_.add_all(result.labels);
    heights_.add_all(result.height_above_ground);
  }

  GroundGrid grid_;
  Hash labels_;
  Hash heights_;
};

Bits bits_of_drive(const Config& config, bool corrected = false) {
  Answers answers(config);
  for (const MovingScan& scan : the_drive().scans) answers.take(scan, corrected);
  return answers.bits();
}

class SameBits : public testing::OnInstructionSet {};

TEST(SameInput, PointsAndPosesOfTheDrive) {
  Hash points;
  Hash poses;
  for (const MovingScan& scan : the_drive().scans) {
    for (const SimulatedScan::Record& record : scan.points.records) {
      points.add(record.x);
      points.add(record.y);
      points.add(record.z);
      points.add(record.time);
    }
    for (const double value : scan.T_map_base_begin.matrix().reshaped()) poses.add(value);
    for (const double value : scan.T_map_base_end.matrix().reshaped()) poses.add(value);
  }
  EXPECT_EQ(points.text(), "6c3a5b7644952636");
  EXPECT_EQ(poses.text(), "a81e3c71945aaacd");
}

TEST_P(SameBits, Default) {
  EXPECT_EQ(bits_of_drive(Config{}),
            (Bits{"6b72dc10bbc84b1", "94b2b8c7fa7df000", "66302964024c61a2"}));
}

TEST_P(SameBits, Paper) {
  EXPECT_EQ(bits_of_drive(Config::paper()),
            (Bits{"187f10cbac7c2369", "1d277bf4a03ca018", "5ad0017d84c99252"}));
}

TEST_P(SameBits, WithSteps) {
  Config config;
  config.labels.max_step_m = 0.08;
  EXPECT_EQ(bits_of_drive(config),
            (Bits{"9eb68c9811462ec3", "94b2b8c7fa7df000", "66302964024c61a2"}));
}

TEST_P(SameBits, MotionCorrected) {
  EXPECT_EQ(bits_of_drive(Config{}, true),
            (Bits{"3a420eb440e368e8", "65592d22a72cd01c", "7b32cc1998bbd3b8"}));
}

TEST_P(SameBits, LoneScansOfUnknownHeight) {
  Answers answers(Config{});
  for (const MovingScan& scan : the_drive().scans) answers.take_alone(scan);
  EXPECT_EQ(answers.bits(), (Bits{"738cf6acef03f5ff", "d979797a6739a956", "5148caaa02514fd1"}));
}

INSTANTIATE_TEST_SUITE_P(With, SameBits, testing::all_instruction_sets(), testing::name_of);

}  // namespace
}  // namespace groundgrid
