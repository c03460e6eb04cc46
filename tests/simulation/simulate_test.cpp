// Whole drives, as the program writes them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "evaluation/semantic_kitti_classes.hpp"
#include "io/hidden_file.hpp"
#include "io/output_folder.hpp"
#include "io/scan_poses.hpp"
#include "io/scan_sequence.hpp"
#include "read_raster.hpp"
#include "run_program.hpp"

namespace groundgrid::simulation {
namespace {

namespace fs = std::filesystem;
using test::read_file;
using test::TemporaryFolder;

template <typename Number>
std::vector<Number> read_numbers(const fs::path& path) {
  const std::string bytes = read_file(path);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

test::ProgramRun simulate(const fs::path& out, const std::string& arguments) {
  return test::run_program("simulate " + arguments + " " + test::shell_word(out));
}

/// All scans of one drive.
struct Points {
  std::size_t scans = 0;
  std::vector<float> records{};
  std::vector<std::uint32_t> labels{};
  std::vector<float> heights{};
  std::vector<Eigen::Vector3d> in_first{};  ///< In the frame of the first pose.

  [[nodiscard]] std::size_t size() const { return labels.size(); }
  [[nodiscard]] std::uint16_t label(std::size_t i) const {
    return static_cast<std::uint16_t>(labels[i] & 0xFFFFU);
  }
  [[nodiscard]] bool ground(std::size_t i) const {
    return evaluation::truth_of(label(i)) == evaluation::Truth::ground;
  }
  template <typename Predicate>
  [[nodiscard]] double share(const Predicate& predicate) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < size(); ++i) count += predicate(i) ? 1U : 0U;
    return static_cast<double>(count) / static_cast<double>(size());
  }
};

Points read_drive(const fs::path& out) {
  const io::ScanSequence sequence = io::find_sequences(out).front();
  const io::ScanPoses poses = io::ScanPoses::kitti(sequence.poses(), sequence.calibration());
  Points points;
  for (const io::ScanFile& scan : sequence.scans) {
    const auto records = read_numbers<float>(scan.path);
    const auto labels = read_numbers<std::uint32_t>(sequence.labels() / (scan.name + ".label"));
    const auto heights =
        read_numbers<float>(sequence.folder / "truth/height" / (scan.name + ".f32"));
    EXPECT_EQ(records.size(), 4 * labels.size());
    EXPECT_EQ(heights.size(), labels.size());
    const Eigen::Isometry3d pose = poses.pose(scan);
    for (std::size_t i = 0; i < labels.size(); ++i)
      points.in_first.push_back(pose * Eigen::Vector3f(&records[4 * i]).cast<double>());
    points.records.insert(points.records.end(), records.begin(), records.end());
    points.labels.insert(points.labels.end(), labels.begin(), labels.end());
    points.heights.insert(points.heights.end(), heights.begin(), heights.end());
    ++points.scans;
  }
  return points;
}

/// One short drive in town for all tests that only look at it.
class Town : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ASSERT_EQ(simulate(folder_->path(), "urban --scans 4 --seed 3 --threads 2").exit_code, 0);
    points_ = new Points(read_drive(folder_->path()));
  }
  static void TearDownTestSuite() {
    delete points_;
    delete folder_;
  }
  static const fs::path& folder() { return folder_->path(); }
  static const Points& points() { return *points_; }

 private:
  static inline TemporaryFolder* folder_ = nullptr;
  static inline Points* points_ = nullptr;
};

TEST_F(Town, IsASemanticKittiDatasetWithItsTruth) {
  const test::Names files = test::files_below(folder() / "sequences/00");
  EXPECT_EQ(files,
            (test::Names{"calib.txt", "labels/000000.label", "labels/000001.label",
                         "labels/000002.label", "labels/000003.label", "poses.txt", "times.txt",
                         "truth/drive.json", "truth/height/000000.f32", "truth/height/000001.f32",
                         "truth/height/000002.f32", "truth/height/000003.f32", "truth/kerbs.tif",
                         "truth/terrain.tif", "truth/vegetation.tif", "velodyne/000000.bin",
                         "velodyne/000001.bin", "velodyne/000002.bin", "velodyne/000003.bin"}));
}

TEST_F(Town, HasTheSharesOfRealScans) {
  const double points_a_scan =
      static_cast<double>(points().size()) / static_cast<double>(points().scans);
  EXPECT_GT(points_a_scan, 105e3);
  EXPECT_LT(points_a_scan, 130e3);
  const double ground = points().share([&](std::size_t i) { return points().ground(i); });
  EXPECT_GT(ground, 0.39);
  EXPECT_LT(ground, 0.6);
  const double leaves = points().share([&](std::size_t i) { return points().label(i) == 70; });
  EXPECT_GT(leaves, 0.08);
  EXPECT_LT(leaves, 0.3);
  const double outliers = points().share([&](std::size_t i) { return points().label(i) == 1; });
  EXPECT_GT(outliers, 0.0001);
  EXPECT_LT(outliers, 0.0015);
}

TEST_F(Town, TheFirstRingIsAboutFourMetresAway) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < points().size(); ++i)
    if (points().label(i) == 40)
      distances.push_back(
          static_cast<double>(std::hypot(points().records[4 * i], points().records[4 * i + 1])));
  auto first = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 100);
  std::nth_element(distances.begin(), first, distances.end());
  EXPECT_GT(*first, 3.6);
  EXPECT_LT(*first, 4.1);
}

TEST_F(Town, PavedGroundIsAtTheHeightOfTheSoil) {
  // At the edge of a step an error of the range is one of the height.
  const double off = points().share([&](std::size_t i) {
    const std::uint16_t label = points().label(i);
    return (label == 40 || label == 44 || label == 48) && std::abs(points().heights[i]) > 0.1F;
  });
  EXPECT_LT(off, 0.0001);
}

TEST_F(Town, SomeReflectionsLieBelowTheGround) {
  const double below = points().share(
      [&](std::size_t i) { return points().label(i) == 1 && points().heights[i] < -0.3F; });
  EXPECT_GT(below, 0.00001);
}

// As in KITTI's scans: some tens at the ends of the roof rack, and none ahead or behind as near as
// the lowest laser meets the road at the sides.
TEST_F(Town, AFewRaysMeetTheOwnVehicleAndItsRoofHidesSome) {
  std::size_t rack = 0;
  std::size_t hidden = 0;
  std::size_t beside = 0;
  for (std::size_t i = 0; i < points().size(); ++i) {
    const float x = points().records[4 * i];
    const float y = points().records[4 * i + 1];
    if (points().label(i) == 0) {
      ++rack;
      EXPECT_NEAR(std::hypot(x, y), 1.9F, 0.4F);
    } else if (std::hypot(x, y) < 4.2F) {
      ++(std::abs(y) < 0.3F ? hidden : beside);
    }
  }
  EXPECT_GT(rack, 4U * 10U);
  EXPECT_LT(rack, 4U * 80U);
  EXPECT_EQ(hidden, 0U);
  EXPECT_GT(beside, 4U * 500U);
}

// The raster is in the frame of the first pose, as the poses and the points are.
TEST_F(Town, TerrainRasterFitsTheGroundPoints) {
  const test::Raster raster = test::read_raster(folder() / "sequences/00/truth/terrain.tif");
  EXPECT_NEAR(raster.transform[1], 0.2, 1e-12);
  EXPECT_NEAR(raster.transform[5], -0.2, 1e-12);
  std::size_t compared = 0;
  double squares = 0.0;
  for (std::size_t i = 0; i < points().size(); ++i) {
    const Eigen::Vector3d& point = points().in_first[i];
    if (points().label(i) != 40 || point.head<2>().norm() > 20.0) continue;
    const auto column = static_cast<int>(std::floor((point.x() - raster.transform[0]) / 0.2));
    const auto row = static_cast<int>(std::floor((raster.transform[3] - point.y()) / 0.2));
    ASSERT_TRUE(column >= 0 && column < raster.columns && row >= 0 && row < raster.rows);
    const double error = point.z() - static_cast<double>(raster.at(1, column, row));
    ASSERT_LT(std::abs(error), 0.25);
    squares += error * error;
    ++compared;
  }
  ASSERT_GT(compared, 50000U);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(compared)), 0.02);
}

TEST_F(Town, MasksHaveTheCellsOfTheTerrain) {
  const fs::path truth = folder() / "sequences/00/truth";
  const test::Raster terrain = test::read_raster(truth / "terrain.tif");
  for (const char* const name : {"kerbs.tif", "vegetation.tif"}) {
    const test::Raster mask = test::read_raster(truth / name);
    EXPECT_EQ(mask.transform, terrain.transform);
    int marked = 0;
    for (int row = 0; row < mask.rows; ++row)
      for (int column = 0; column < mask.columns; ++column)
        marked += mask.at(1, column, row) == 1.0F ? 1 : 0;
    EXPECT_GT(marked, mask.rows * mask.columns / 200) << name;
    EXPECT_LT(marked, mask.rows * mask.columns / 3) << name;
  }
}

TEST_F(Town, IsEvaluatedAsItIs) {
  const test::ProgramRun run = test::run_program("evaluate --json " + test::shell_word(folder()));
  ASSERT_EQ(run.exit_code, 0) << run.words;
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json["sequences"][0]["scans"], 4);
}

TEST_F(Town, SaysWhatItIs) {
  const auto json = nlohmann::json::parse(read_file(folder() / "sequences/00/truth/drive.json"));
  EXPECT_EQ(json["simulated"], true);
  EXPECT_EQ(json["scene"], "urban");
  EXPECT_EQ(json["seed"], 3);
  EXPECT_EQ(json["points"], points().size());
}

TEST_F(Town, IsTheSameForAnyNumberOfThreadsAndAnotherForAnotherSeed) {
  const TemporaryFolder one;
  const TemporaryFolder other;
  ASSERT_EQ(simulate(one.path(), "urban --scans 4 --seed 3 --threads 1").exit_code, 0);
  ASSERT_EQ(simulate(other.path(), "urban --scans 4 --seed 4").exit_code, 0);
  for (const std::string& file : test::files_below(folder()))
    EXPECT_EQ(read_file(folder() / file), read_file(one.path() / file)) << file;
  EXPECT_NE(read_file(folder() / "sequences/00/velodyne/000000.bin"),
            read_file(other.path() / "sequences/00/velodyne/000000.bin"));
}

TEST_F(Town, DistortedPointsAreThoseOfTheMovingSensor) {
  const TemporaryFolder out;
  ASSERT_EQ(simulate(out.path(), "urban --scans 4 --seed 3 --motion distorted").exit_code, 0);
  const Points distorted = read_drive(out.path());
  ASSERT_EQ(distorted.labels, points().labels);
  float most = 0.0F;
  for (std::size_t i = 0; i < points().size(); ++i)
    most = std::max(most, std::abs(distorted.records[4 * i] - points().records[4 * i]));
  // Half a scan at 10 m/s is half a metre, and what the turn adds far away.
  EXPECT_GT(most, 0.45F);
  EXPECT_LT(most, 1.5F);
}

TEST_F(Town, PoseErrorsChangeThePosesAlone) {
  const TemporaryFolder out;
  ASSERT_EQ(simulate(out.path(), "urban --scans 4 --seed 3 --pose-noise 0.05 --pose-drift 0.01")
                .exit_code,
            0);
  EXPECT_EQ(read_file(out / "sequences/00/velodyne/000003.bin"),
            read_file(folder() / "sequences/00/velodyne/000003.bin"));
  EXPECT_NE(read_file(out / "sequences/00/poses.txt"),
            read_file(folder() / "sequences/00/poses.txt"));
}

struct SceneShares {
  const char* scene;
  double least_ground;
  double most_ground;
  double least_leaves;
};

class EveryScene : public ::testing::TestWithParam<SceneShares> {};
INSTANTIATE_TEST_SUITE_P(Simulate, EveryScene,
                         ::testing::Values(SceneShares{"hill", 0.3, 0.8, 0.15},
                                           SceneShares{"motorway", 0.6, 0.95, 0.01},
                                           SceneShares{"village", 0.3, 0.7, 0.03},
                                           SceneShares{"offroad", 0.5, 0.95, 0.02}),
                         [](const auto& shares) { return std::string(shares.param.scene); });

// Sparse points and a vehicle in the soil would show here.
TEST_P(EveryScene, HasGroundWhereTheSoilIs) {
  const TemporaryFolder out;
  ASSERT_EQ(simulate(out.path(), std::string(GetParam().scene) + " --scans 3").exit_code, 0);
  const Points points = read_drive(out.path());
  EXPECT_GT(points.size(), 3U * 90000U);
  const double ground = points.share([&](std::size_t i) { return points.ground(i); });
  EXPECT_GT(ground, GetParam().least_ground);
  EXPECT_LT(ground, GetParam().most_ground);
  EXPECT_GT(points.share([&](std::size_t i) { return points.label(i) == 70; }),
            GetParam().least_leaves);
  const double off_soil = points.share([&](std::size_t i) {
    return points.ground(i) && (points.heights[i] < -0.15F || points.heights[i] > 0.5F);
  });
  EXPECT_LT(off_soil, 0.001);
}

class EverySensor : public ::testing::TestWithParam<std::pair<const char*, std::size_t>> {};
INSTANTIATE_TEST_SUITE_P(Simulate, EverySensor,
                         ::testing::Values(std::pair{"hdl-32e", std::size_t{18000}},
                                           std::pair{"vlp-16", std::size_t{12000}},
                                           std::pair{"os1-128", std::size_t{60000}},
                                           std::pair{"rosette", std::size_t{8000}}));

TEST_P(EverySensor, SeesTheTown) {
  const auto& [name, least_points] = GetParam();
  const TemporaryFolder out;
  ASSERT_EQ(simulate(out.path(), std::string("urban --scans 2 --sensor ") + name).exit_code, 0);
  const Points points = read_drive(out.path());
  EXPECT_GT(points.size(), 2 * least_points);
  EXPECT_GT(points.share([&](std::size_t i) { return points.ground(i); }), 0.1);
}

// The same drive, seen by two sensors: what both say of the road is the same.
TEST(Simulate, PutsEachSensorIntoASequenceOfItsOwn) {
  const TemporaryFolder out;
  test::write_file(out / "low.toml",
                   "like = \"vlp-16\"\nroll_deg = 180\nx_m = 1.0\nheight_m = 1.4\n");
  ASSERT_EQ(simulate(out / "drive", "offroad --scans 2 --sensor hdl-32e --sensor " +
                                        test::shell_word(out / "low.toml"))
                .exit_code,
            0);
  const auto record = [&](const char* sequence) {
    return nlohmann::json::parse(
        read_file(out / "drive/sequences" / sequence / "truth/drive.json"));
  };
  EXPECT_EQ(record("00")["sensor"], "hdl-32e");
  EXPECT_EQ(record("00")["scans"], 2);
  EXPECT_EQ(record("01")["sensor"], "low");
  // It turns half as fast.
  EXPECT_EQ(record("01")["scans"], 1);
  EXPECT_EQ(record("01")["T_base_sensor"][0][3], 1.0);
  EXPECT_EQ(record("01")["T_base_sensor"][2][3], 1.4);
  EXPECT_NEAR(record("01")["T_base_sensor"][2][2].get<double>(), -1.0, 1e-12);
  // Upside down, in an upright frame: the ground is still below.
  const io::ScanSequence second = io::find_sequences(out / "drive").at(1);
  const io::ScanPoses poses = io::ScanPoses::kitti(second.poses(), second.calibration());
  EXPECT_NEAR(poses.pose(second.scans.front()).linear()(2, 2), -1.0, 1e-6);
}

TEST(Simulate, TakesNoNameForSeveralSequences) {
  const TemporaryFolder out;
  EXPECT_EQ(simulate(out.path(), "urban --scans 1 --sequence 04 --sensor vlp-16 --sensor vlp-16")
                .exit_code,
            2);
}

TEST(Simulate, SaysWhatIsWrongWithASensorFile) {
  const TemporaryFolder out;
  test::write_file(out / "bad.toml", "like = \"vlp-16\"\ncolumns = 0\n");
  const test::ProgramRun run =
      simulate(out / "drive", "urban --scans 1 --sensor " + test::shell_word(out / "bad.toml"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(test::contains(run.words, "line 2")) << run.words;
  EXPECT_FALSE(fs::exists(out / "drive"));
}

TEST(Simulate, KeepsASensorFileThatHasTheNameOfAnOutput) {
  const TemporaryFolder out;
  for (const char* const name : {"calib.txt", "truth/drive.json", "velodyne/000001.bin"}) {
    const fs::path sensor = out / "sensor.toml";
    test::write_file(sensor, "like = \"vlp-16\"\n");
    fs::create_directories((out / "sequences/00" / name).parent_path());
    fs::create_hard_link(sensor, out / "sequences/00" / name);
    const test::Names before = test::files_below(out.path());
    const test::ProgramRun run =
        simulate(out.path(), "urban --scans 2 --sensor " + test::shell_word(sensor));
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(test::contains(run.words, "sensor.toml: would be overwritten as")) << name;
    EXPECT_EQ(test::files_below(out.path()), before);
    fs::remove(out / "sequences/00" / name);
  }
}

TEST(Simulate, RefusesASequenceThatAnotherRunWrites) {
  const TemporaryFolder out;
  test::write_file(out / "sequences/00/truth/drive.json", "that of another run");
  const io::FolderLock other(out / "sequences/00");
  const test::ProgramRun run = simulate(out.path(), "urban --scans 1 --sensor vlp-16");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(test::contains(run.words, "sequences/00: expected a folder that no other run"));
  EXPECT_EQ(read_file(out / "sequences/00/truth/drive.json"), "that of another run");
}

// It marks a whole drive, which the next one is not before its end.
TEST(Simulate, TakesAwayTheRecordOfAnEarlierDriveFirst) {
  const TemporaryFolder out;
  test::write_file(out / "sequences/00/truth/drive.json", "of an earlier drive");
  test::write_file(out / "sequences/00/velodyne/000000.bin/file", "in the way");
  EXPECT_EQ(simulate(out.path(), "urban --scans 1 --sensor vlp-16").exit_code, 1);
  EXPECT_FALSE(fs::exists(out / "sequences/00/truth/drive.json"));
}

TEST(Simulate, RemovesWhatAKilledRunLeft) {
  const TemporaryFolder out;
  const std::string flags = "urban --scans 1 --sensor vlp-16";
  ASSERT_EQ(simulate(out.path(), flags).exit_code, 0);
  const test::Names whole = test::files_below(out.path());
  for (const char* const below : {"", "velodyne", "labels", "truth", "truth/height"})
    test::write_file(out / "sequences/00" / below / io::hidden_name(), "half");
  ASSERT_EQ(simulate(out.path(), flags).exit_code, 0);
  EXPECT_EQ(test::files_below(out.path()), whole);
}

TEST(Simulate, NamesWhatItDoesNotKnow) {
  const TemporaryFolder out;
  EXPECT_EQ(simulate(out.path(), "moon").exit_code, 2);
  EXPECT_EQ(simulate(out.path(), "urban --sensor eye").exit_code, 2);
  EXPECT_EQ(simulate(out.path(), "urban --scans 0").exit_code, 2);
}

TEST(Simulate, SaysWhereItCannotWrite) {
  const TemporaryFolder folder;
  test::write_file(folder / "file", "");
  const test::ProgramRun run = simulate(folder / "file", "urban --scans 1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(test::contains(run.words, "file"));
}

}  // namespace
}  // namespace groundgrid::simulation
