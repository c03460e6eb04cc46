#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace groundgrid::testing {

/// The SemanticKITTI dataset below GROUNDGRID_DATA, or below the folder where developers keep it;
/// nothing where there is none.
std::optional<std::filesystem::path> semantic_kitti();

/// True where the absence of data is a failure: GROUNDGRID_REQUIRE_DATA is set (CI).
bool data_is_required();

/// One labelled scan: x, y, z, intensity a point.
struct RealScan {
  std::vector<float> points;
  std::vector<std::uint32_t> labels;
  Eigen::Isometry3d T_map_lidar = Eigen::Isometry3d::Identity();

  [[nodiscard]] std::size_t size() const { return points.size() / 4; }
};

/// The first scans of a sequence, at most `limit`.
std::vector<RealScan> read_scans(const std::filesystem::path& dataset, const std::string& sequence,
                                 std::size_t limit);

/// The points of the first scans of a set of other_sensors, which lies beside the dataset: x, y, z,
/// intensity each; nothing if it is not there.
std::vector<std::vector<float>> read_other_sensor(const std::filesystem::path& dataset,
                                                  const std::string& name, std::size_t limit);

}  // namespace groundgrid::testing

/// Leaves the test where there is no data: skipped, or failed where data is required.
#define GROUNDGRID_NEEDS_DATA(dataset)                                                     \
  const auto dataset = ::groundgrid::testing::semantic_kitti();                            \
  if (!(dataset).has_value()) {                                                            \
    if (::groundgrid::testing::data_is_required())                                         \
      FAIL() << "GROUNDGRID_REQUIRE_DATA is set, but there is no SemanticKITTI data; set " \
                "GROUNDGRID_DATA";                                                         \
    GTEST_SKIP() << "no SemanticKITTI data: set GROUNDGRID_DATA to the folder that holds " \
                    "semantickitti/sequences";                                             \
  }
