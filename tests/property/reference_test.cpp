// The fast stages give what the plain reference does, bit by bit: labels, heights, and what each
// scan leaves in the map. Statistics that differ point at support, confidences at the classes of
// cells, heights at the surface, labels alone at the thresholds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "support/drive.hpp"
#include "support/instruction_sets.hpp"
#include "support/real_data.hpp"

namespace groundgrid {
namespace {

using testing::DriveScan;

void expect_same_as_reference(Config config, const std::vector<DriveScan>& drive, int threads = 1) {
  GroundGrid fast(config, threads);
  config.method = Method::reference;
  GroundGrid plain(config);
  EXPECT_TRUE(
      testing::same_bits(testing::run_drive(plain, drive), testing::run_drive(fast, drive)));
  EXPECT_TRUE(std::ranges::equal(plain.standard_deviation(), fast.standard_deviation()));
}

std::vector<DriveScan> real_drive(const std::filesystem::path& dataset, const std::string& sequence,
                                  std::size_t scans) {
  std::vector<DriveScan> drive;
  for (testing::RealScan& real : testing::read_scans(dataset, sequence, scans))
    drive.push_back({std::move(real.points), 4, real.T_map_lidar, std::nullopt});
  return drive;
}

TEST(Reference, HasTheSameBitsOnRealDrives) {
  GROUNDGRID_NEEDS_DATA(dataset)
  for (const std::string sequence : {"00", "01", "03", "06", "09"}) {
    SCOPED_TRACE(sequence);
    expect_same_as_reference({}, real_drive(*dataset, sequence, 4));
  }
}

TEST(Reference, HasTheSameBitsOnOtherSensors) {
  GROUNDGRID_NEEDS_DATA(dataset)
  for (const std::string name : {"nuscenes", "front_sector", "argoverse2"}) {
    SCOPED_TRACE(name);
    std::vector<std::vector<float>> scans = testing::read_other_sensor(*dataset, name, 8);
    ASSERT_FALSE(scans.empty()) << name << " is missing beside semantickitti";
    // Places that have nothing to do with each other, as one drive: the map contradicts the scans.
    std::vector<DriveScan> drive;
    for (std::vector<float>& points : scans)
      drive.push_back({std::move(points), 4, Eigen::Isometry3d::Identity(), std::nullopt});
    expect_same_as_reference({}, drive);
  }
}

/// A cloud without any sense: rough ground, walls, holes, ghosts and values that are no numbers.
std::vector<float> random_cloud(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-70.0F, 70.0F);
  std::normal_distribution<float> rough(0.0F, 0.02F * static_cast<float>(seed % 5 + 1));
  std::vector<float> points;
  for (int i = 0; i < 30000; ++i) {
    const float near = i % 3 == 0 ? 1.0F : 0.2F;
    const float x = near * place(random);
    const float y = near * place(random);
    float z = -1.7F + 0.1F * x + 0.3F * std::sin(0.3F * y) + rough(random);
    if (i % 7 == 0) z += std::abs(place(random)) * 0.03F;
    if (i % 501 == 0) z -= std::abs(place(random)) * 0.3F;
    if (i % 997 == 0) z = std::nanf("");
    points.insert(points.end(), {x, y, z});
  }
  return points;
}

class ReferenceOn : public testing::OnInstructionSet {};

TEST_P(ReferenceOn, RandomCloudsHaveTheSameBits) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<DriveScan> drive;
    for (unsigned i = 0; i < 3; ++i)
      drive.push_back({random_cloud(3 * seed + i), 3, testing::pose(2.0 * i, 0.7 * i, 0.1, 5.0 * i),
                       std::nullopt});
    drive.push_back({{}, 3, testing::pose(6.0, 2.0, 0.1), std::nullopt});
    Config config;
    config.map.extent_m = 60.0 + 30.0 * seed;
    config.map.resolution_m = seed == 1 ? 0.5 : 0.33;
    expect_same_as_reference(config, drive, seed == 2 ? 3 : 1);
  }
}

TEST_P(ReferenceOn, ASimulatedStreetHasTheSameBits) {
  Config config;
  expect_same_as_reference(config, testing::street_drive(4));
  config.labels.max_step_m = 0.08;
  expect_same_as_reference(config, testing::street_drive(2));
}

INSTANTIATE_TEST_SUITE_P(With, ReferenceOn, testing::all_instruction_sets(), testing::name_of);

}  // namespace
}  // namespace groundgrid
