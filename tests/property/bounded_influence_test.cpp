// What a few returns can do: a ghost, or a small cluster of them, anywhere around the sensor and as
// deep or high as it may be, leaves the labels of points that are farther away as they are.
//
// Not to the last one: the surface is fitted to all cells, and one cell less moves it by a fraction
// of a millimetre. A point within that of its threshold changes sides; a small patch on the verge
// of being a terrace, or of being wide enough to be believed, changes as a whole. The bounds below
// say how rare and how small both are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "support/drive.hpp"
#include "support/real_data.hpp"

namespace groundgrid {
namespace {

using testing::DriveScan;

constexpr double kFar_m = 3.0;

struct Cluster {
  std::vector<float> points;  ///< x, y, z, intensity a point, in the sensor's frame.
};

/// Some returns around one place: 3 to 58 m away, 30 m below to 30 m above the sensor.
class Ghosts {
 public:
  explicit Ghosts(unsigned seed) : random_(seed) {}

  Cluster next(int most_returns) {
    const double range = between(3.0, 58.0);
    const double azimuth = between(-std::numbers::pi, std::numbers::pi);
    const double z = between(-30.0, 30.0);
    const double spread = most_returns == 1 ? 0.0 : between(0.05, 0.4);
    const int returns = std::uniform_int_distribution(1, most_returns)(random_);
    Cluster cluster;
    for (int i = 0; i < returns; ++i) {
      const auto around = [&](double middle) {
        return static_cast<float>(middle + spread * std::normal_distribution()(random_));
      };
      cluster.points.insert(
          cluster.points.end(),
          {around(range * std::cos(azimuth)), around(range * std::sin(azimuth)), around(z), 0.0F});
    }
    return cluster;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution(low, high)(random_);
  }

  std::mt19937 random_;
};

using Labels = std::vector<std::vector<Label>>;

/// The labels of every scan of a drive, or of every scan by itself.
Labels labels_of(const std::vector<DriveScan>& scans, bool single, const Cluster& ghosts) {
  GroundGrid grid;
  Labels labels;
  for (const DriveScan& scan : scans) {
    DriveScan with_ghosts = scan;
    with_ghosts.points.insert(with_ghosts.points.end(), ghosts.points.begin(), ghosts.points.end());
    if (single) grid.reset();
    const ScanResult result = grid.process(with_ghosts.scan(), scan.T_map_base);
    labels.emplace_back(result.labels.begin(), result.labels.end()).resize(scan.size());
  }
  return labels;
}

/// How many labels differ of points that are far from every ghost.
std::size_t count_changed(const std::vector<DriveScan>& scans, const Labels& before,
                          const Labels& after, const Cluster& ghosts) {
  const auto is_near = [&](const float* point) {
    for (std::size_t i = 0; i < ghosts.points.size(); i += 4)
      if (std::hypot(static_cast<double>(point[0] - ghosts.points[i]),
                     static_cast<double>(point[1] - ghosts.points[i + 1])) < kFar_m)
        return true;
    return false;
  };
  std::size_t changed = 0;
  for (std::size_t s = 0; s < scans.size(); ++s)
    for (std::size_t i = 0; i < before[s].size(); ++i)
      if (before[s][i] != after[s][i] && !is_near(scans[s].points.data() + 4 * i)) ++changed;
  return changed;
}

/// Of all labels of a trial the greatest share that changed, and of all trials the share in which
/// any did.
struct Influence {
  double worst_share = 0.0;
  int trials = 0;
  int trials_with_any = 0;

  void try_out(const std::vector<DriveScan>& scans, bool single, int most_returns, Ghosts& ghosts,
               int times) {
    const Labels before = labels_of(scans, single, {});
    std::size_t labels = 0;
    for (const std::vector<Label>& of_scan : before) labels += of_scan.size();
    for (int i = 0; i < times; ++i) {
      const Cluster cluster = ghosts.next(most_returns);
      const std::size_t changed =
          count_changed(scans, before, labels_of(scans, single, cluster), cluster);
      worst_share =
          std::max(worst_share, static_cast<double>(changed) / static_cast<double>(labels));
      ++trials;
      if (changed > 0) ++trials_with_any;
    }
  }
  [[nodiscard]] double share_with_any() const {
    return static_cast<double>(trials_with_any) / trials;
  }
};

/// The first scans of every real sensor that there is data of, each by itself.
std::vector<DriveScan> scans_of_all_sensors(const std::filesystem::path& dataset) {
  std::vector<DriveScan> scans;
  for (const std::string sequence : {"00", "01", "03", "06", "09"})
    for (testing::RealScan& real : testing::read_scans(dataset, sequence, 1))
      scans.push_back({std::move(real.points), 4, Eigen::Isometry3d::Identity(), std::nullopt});
  for (const std::string name : {"nuscenes", "front_sector", "argoverse2"})
    for (std::vector<float>& points : testing::read_other_sensor(dataset, name, 2))
      scans.push_back({std::move(points), 4, Eigen::Isometry3d::Identity(), std::nullopt});
  return scans;
}

Influence on_single_scans(const std::vector<DriveScan>& scans, int most_returns) {
  Influence influence;
  Ghosts ghosts(17);
  for (const DriveScan& scan : scans) influence.try_out({scan}, true, most_returns, ghosts, 12);
  return influence;
}

TEST(BoundedInfluence, AGhostChangesNoLabelFarFromIt) {
  GROUNDGRID_NEEDS_DATA(dataset)
  const std::vector<DriveScan> scans = scans_of_all_sensors(*dataset);
  ASSERT_GE(scans.size(), 11U) << "other_sensors is missing beside semantickitti";
  const Influence influence = on_single_scans(scans, 1);
  EXPECT_LE(influence.share_with_any(), 0.05);
  EXPECT_LE(influence.worst_share, 0.001);
}

TEST(BoundedInfluence, ASmallClusterOfGhostsChangesNoLabelFarFromIt) {
  GROUNDGRID_NEEDS_DATA(dataset)
  const Influence influence = on_single_scans(scans_of_all_sensors(*dataset), 50);
  EXPECT_LE(influence.share_with_any(), 0.12);
  EXPECT_LE(influence.worst_share, 0.005);
}

TEST(BoundedInfluence, WhatStaysAtOnePlaceOfTheSensorsFrameDoesNotSpreadOverADrive) {
  GROUNDGRID_NEEDS_DATA(dataset)
  Influence influence;
  Ghosts ghosts(23);
  for (const std::string sequence : {"00", "03", "09"}) {
    std::vector<DriveScan> drive;
    for (testing::RealScan& real : testing::read_scans(*dataset, sequence, 5))
      drive.push_back({std::move(real.points), 4, real.T_map_lidar, std::nullopt});
    influence.try_out(drive, false, 1, ghosts, 4);
    influence.try_out(drive, false, 50, ghosts, 4);
  }
  EXPECT_LE(influence.share_with_any(), 0.35);
  EXPECT_LE(influence.worst_share, 0.005);
}

}  // namespace
}  // namespace groundgrid
