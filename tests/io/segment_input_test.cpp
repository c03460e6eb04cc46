// Other layouts, poses, mountings and outputs than a KITTI dataset's.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "io/scan_file.hpp"
#include "segment_fixture.hpp"
#include "shared_data.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::files_below;
using test::Names;
using test::ProgramRun;
using test::read_file;
using test::run_program;
using test::Segment;
using test::shell_word;

class SegmentInput : public Segment {
 protected:
  [[nodiscard]] ProgramRun segment_input(const fs::path& input,
                                         const std::string& more = "") const {
    return run_program("segment " + shell_word(input) + " --output " + shell_word(output()) + " " +
                       more);
  }

  // The synthetic scan in a folder of its own, as NAME.bin.
  [[nodiscard]] fs::path plain_scan(const std::string& name) const {
    fs::path path = folder / "scans" / (name + ".bin");
    test::write_numbers(path, test::SyntheticScan().points);
    return path;
  }

  // The synthetic scan as a LiDAR that hangs upside down sees it.
  static std::vector<float> turned_over() {
    std::vector<float> points = test::SyntheticScan().points;
    for (std::size_t i = 0; i < points.size(); i += 4) {
      points[i + 1] = -points[i + 1];
      points[i + 2] = -points[i + 2];
    }
    return points;
  }

  [[nodiscard]] std::string labels(const std::string& name) const {
    return read_file(output() / (name + ".label"));
  }
};

TEST_F(SegmentInput, WritesCloudsWithLabelsAndHeights) {
  const fs::path scan = plain_scan("a");
  for (const std::string format : {"pcd", "ply"}) {
    const ProgramRun run = segment_input(scan, "--clouds " + format);
    ASSERT_EQ(run.exit_code, 0) << run.words;
    io::PointCloud cloud;
    io::read_scan(output() / ("a." + format), *io::scan_format_named(format), cloud);
    ASSERT_EQ(cloud.size(), test::SyntheticScan().size());
    ASSERT_NE(cloud.find("intensity"), nullptr);
    const io::PointField* const label = cloud.find("label");
    const io::PointField* const height = cloud.find("height_above_ground");
    ASSERT_NE(label, nullptr);
    ASSERT_NE(height, nullptr);
    const std::string bytes = labels("a");
    ASSERT_EQ(bytes.size(), cloud.size() * sizeof(std::uint32_t));
    for (std::size_t i = 0; i < cloud.size(); i += 97) {
      std::uint32_t expected = 0;
      std::memcpy(&expected, bytes.data() + i * sizeof expected, sizeof expected);
      EXPECT_EQ(io::value_at(cloud, i, *label), expected);
      EXPECT_EQ(std::isnan(io::value_at(cloud, i, *height)), expected == 0);
    }
  }
}

TEST_F(SegmentInput, OfFiveFloatsGetsALabelForEveryPointOrIsRefused) {
  const std::vector<float> four = test::SyntheticScan().points;
  std::vector<float> five;
  for (std::size_t i = 0; i < four.size() / 16 * 16; ++i) {
    five.push_back(four[i]);
    if (i % 4 == 3) five.push_back(static_cast<float>(i / 4 % 64));
  }
  const std::size_t points = five.size() / 5;
  ASSERT_EQ(five.size() % 4, 0U) << "or its size tells";
  test::write_numbers(folder / "scans/a.bin", five);
  const ProgramRun run = segment_input(folder / "scans/a.bin");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(labels("a").size(), 4 * points);
  EXPECT_TRUE(contains(run.words, "read as nuscenes (x y z intensity ring, 32-bit floats)"));
  EXPECT_TRUE(contains(run_program("info " + shell_word(folder / "scans")).output,
                       "nuscenes (x y z intensity ring, 32-bit floats), binary"));
  test::write_numbers(folder / "scans/0.bin", four);
  const ProgramRun mixed = segment_input(folder / "scans");
  EXPECT_EQ(mixed.exit_code, 1);
  EXPECT_TRUE(contains(mixed.words, "a.bin: expected points of x y z intensity, 32-bit floats"));
}

TEST_F(SegmentInput, TakesALayoutByItsLetters) {
  const fs::path scan = plain_scan("a");
  ASSERT_EQ(segment_input(scan, "--format xyz_").exit_code, 0);
  EXPECT_EQ(labels("a").size(), 4 * test::SyntheticScan().size());
  const ProgramRun wrong = segment_input(scan, "--format xyq");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.words, "expected kitti, nuscenes, pcd, ply, text or the letters"));
}

TEST_F(SegmentInput, TakesItsOwnCloudsAgain) {
  ASSERT_EQ(segment_input(plain_scan("a"), "--clouds pcd").exit_code, 0);
  const std::string first = labels("a");
  fs::create_directories(folder / "again");
  fs::rename(output() / "a.pcd", folder / "again/b.pcd");
  const ProgramRun run = segment_input(folder / "again/b.pcd", "--clouds same");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(labels("b"), first);
  EXPECT_EQ(read_file(output() / "b.pcd"), read_file(folder / "again/b.pcd"));
}

TEST_F(SegmentInput, SaysThatABinHasNoPlaceForLabels) {
  const ProgramRun run = segment_input(plain_scan("a"), "--clouds same");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(run.words, "a.bin"));
  EXPECT_TRUE(contains(run.words, "--clouds pcd"));
}

TEST_F(SegmentInput, NeverOverwritesItsInput) {
  ASSERT_EQ(segment_input(plain_scan("a"), "--clouds pcd").exit_code, 0);
  const std::string before = read_file(output() / "a.pcd");
  const ProgramRun run = segment_input(output() / "a.pcd", "--clouds same");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(run.words, "would be overwritten"));
  EXPECT_EQ(read_file(output() / "a.pcd"), before);
}

TEST_F(SegmentInput, TakesAListOfScans) {
  const fs::path a = plain_scan("a");
  const fs::path b = plain_scan("b");
  test::write_file(folder / "scans/list.txt", "b.bin\n# a comment\n\n" + a.string() + "\n");
  const ProgramRun run = segment_input(folder / "scans/list.txt");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(files_below(output()), (Names{"a.label", "b.label", "run.json", "timing.csv"}));
}

TEST_F(SegmentInput, AFormatCanBeForced) {
  const fs::path scan = plain_scan("a");
  fs::rename(scan, folder / "scans/a.dat");
  EXPECT_EQ(segment_input(folder / "scans/a.dat").exit_code, 1);
  const ProgramRun run = segment_input(folder / "scans/a.dat", "--format kitti");
  EXPECT_EQ(run.exit_code, 0) << run.words;
}

TEST_F(SegmentInput, TakesPosesFromAFile) {
  (void)plain_scan("000000");
  (void)plain_scan("000001");
  test::write_file(folder / "tum.txt",
                   "# time x y z qx qy qz qw\n10.0 0 0 0 0 0 0 1\n10.1 1 0 0 0 0 0 1\n");
  test::write_file(folder / "kitti.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n");
  std::string with_kitti;
  for (const std::string poses : {"kitti.txt", "tum.txt"}) {
    const ProgramRun run = segment_input(folder / "scans", "--poses " + shell_word(folder / poses));
    ASSERT_EQ(run.exit_code, 0) << run.words;
    EXPECT_FALSE(record()["single_scan"].get<bool>());
    EXPECT_EQ(record()["poses"], (folder / poses).string());
    if (with_kitti.empty()) with_kitti = labels("000001");
    EXPECT_EQ(labels("000001"), with_kitti);
  }
}

TEST_F(SegmentInput, PosesAreForOneSequenceAndNotForSingleScans) {
  dataset.add_sequence("00", 1);
  dataset.add_sequence("01", 1);
  const std::string poses =
      "--poses " + shell_word(dataset.folder / "sequences/00/poses.txt") + " ";
  EXPECT_EQ(segment(poses).exit_code, 2);
  EXPECT_EQ(segment(poses + "--sequence 00 --single-scan").exit_code, 2);
  EXPECT_EQ(segment(poses + "--sequence 00").exit_code, 0);
}

TEST_F(SegmentInput, CalibrationMakesLidarPosesOfCameraPoses) {
  dataset.add_sequence("00", 2);
  ASSERT_EQ(segment().exit_code, 0);
  const fs::path file = output() / "sequences/00/predictions/000001.label";
  const std::string with_own_poses = read_file(file);
  const fs::path sequence = dataset.folder / "sequences/00";
  ASSERT_EQ(segment("--poses " + shell_word(sequence / "poses.txt") + " --calibration " +
                    shell_word(sequence / "calib.txt"))
                .exit_code,
            0);
  EXPECT_EQ(read_file(file), with_own_poses);
}

TEST_F(SegmentInput, AnUpsideDownLidarGivesTheSameLabels) {
  ASSERT_EQ(segment_input(plain_scan("a")).exit_code, 0);
  test::write_numbers(folder / "scans/b.bin", turned_over());
  const ProgramRun run = segment_input(folder / "scans/b.bin", "--lidar-rpy-deg 180,0,0");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(labels("b"), labels("a"));
}

// The same street with the LiDAR upside down: y and z of its points, and its side of Tr.
TEST_F(SegmentInput, AnUpsideDownLidarGivesTheSameLabelsWithPoses) {
  dataset.add_sequence("00", 3);
  ASSERT_EQ(segment().exit_code, 0);
  const fs::path file = output() / "sequences/00/predictions/000002.label";
  const std::string upright = read_file(file);
  for (std::size_t scan = 0; scan < 3; ++scan)
    test::write_numbers(dataset.scan_file("00", scan), turned_over());
  const fs::path sequence = dataset.folder / "sequences/00";
  test::write_file(sequence / "calib.txt", "Tr: 0 1 0 0 0 0 1 -0.08 1 0 0 -0.27\n");
  const ProgramRun run = segment("--lidar-rpy-deg 180,0,0");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(read_file(file), upright);
  // Poses relative to the first LiDAR, then in a map whose z is up.
  for (const std::string poses :
       {"1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n1 0 0 2 0 1 0 0 0 0 1 0\n",
        "1 0 0 0 0 -1 0 0 0 0 -1 0\n1 0 0 1 0 -1 0 0 0 0 -1 0\n1 0 0 2 0 -1 0 0 0 0 -1 0\n"}) {
    test::write_file(folder / "poses.txt", poses);
    ASSERT_EQ(
        segment("--lidar-rpy-deg 180,0,0 --poses " + shell_word(folder / "poses.txt")).exit_code,
        0);
    EXPECT_EQ(read_file(file), upright) << poses;
  }
}

TEST_F(SegmentInput, RefusesPosesThatLayTheVehicleOnItsSide) {
  (void)plain_scan("000000");
  test::write_file(folder / "poses.txt", "1 0 0 0 0 0 -1 0 0 1 0 0\n");
  const ProgramRun run =
      segment_input(folder / "scans", "--poses " + shell_word(folder / "poses.txt"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "000000.bin: expected a pose that stands upright"));
  EXPECT_TRUE(contains(run.words, "leans by 90 degrees"));
}

TEST_F(SegmentInput, WarnsWhereACamerasPosesAreTakenForTheLidars) {
  (void)plain_scan("000000");
  (void)plain_scan("000001");
  test::write_file(folder / "poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 6\n");
  const ProgramRun run =
      segment_input(folder / "scans", "--poses " + shell_word(folder / "poses.txt"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.words, "the poses climb 6.0 m and advance 0.0 m"));
}

TEST_F(SegmentInput, AnglesOfTheLidarMayBeNegative) {
  const ProgramRun run = segment_input(plain_scan("a"), "--lidar-rpy-deg -180,0,0");
  EXPECT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(segment_input(plain_scan("a"), "--lidar-rpy-deg nan,0,0").exit_code, 2);
  EXPECT_EQ(segment_input(plain_scan("a"), "--lidar-rpy-deg 1,2").exit_code, 2);
}

TEST_F(SegmentInput, FailsIfNoPointOfAnyScanHasALabel) {
  std::vector<float> points(4 * 50, std::nanf(""));
  test::write_numbers(folder / "scans/nan.bin", points);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = i % 8 < 4 ? 1e6F : -INFINITY;
  test::write_numbers(folder / "scans/far.bin", points);
  for (const std::string name : {"nan", "far"}) {
    const ProgramRun run = segment_input(folder / "scans" / (name + ".bin"));
    EXPECT_EQ(run.exit_code, 1) << run.words;
    EXPECT_TRUE(contains(run.words, "none of its 50 points has a label"));
    EXPECT_TRUE(contains(run.words, "none in any scan, so that all labels are unknown"));
    EXPECT_EQ(labels(name), std::string(200, '\0'));
    EXPECT_FALSE(fs::exists(output() / "run.json"));
  }
  // One scan that can be labelled is something.
  (void)plain_scan("good");
  EXPECT_EQ(segment_input(folder / "scans").exit_code, 0);
}

/// The street with other coordinates.
std::vector<float> changed_street(const std::function<void(float*)>& change) {
  std::vector<float> points = test::SyntheticScan().points;
  for (std::size_t i = 0; i < points.size(); i += 4) change(&points[i]);
  return points;
}

TEST_F(SegmentInput, SaysOnceWhatCannotBeRightInTheFirstScan) {
  struct Wrong {
    std::function<void(float*)> change;
    std::string words;
  };
  const auto times = [](float factor) {
    return [factor](float* p) { std::for_each(p, p + 3, [=](float& c) { c *= factor; }); };
  };
  for (const auto& [change, words] :
       {Wrong{[](float* p) { p[1] = -p[1], p[2] = -p[2]; }, "z looks flipped"},
        Wrong{times(1e-3F), "Half of the points are nearer than"},
        Wrong{times(1e3F), "All points are outside of the map"},
        Wrong{times(12.0F), "get no label: are coordinates metres? Then --extent-m "}}) {
    for (const std::string name : {"0", "1"})
      test::write_numbers(folder / "scans" / (name + ".bin"), changed_street(change));
    const ProgramRun run = segment_input(folder / "scans");
    const std::size_t at = run.words.find(words);
    EXPECT_NE(at, std::string::npos) << words << "\n" << run.words;
    EXPECT_EQ(run.words.find(words, at + 1), std::string::npos) << run.words;
  }
}

TEST_F(SegmentInput, SaysNothingOfAScanThatIsRight) {
  const ProgramRun run = segment_input(plain_scan("a"));
  EXPECT_FALSE(contains(run.words, "warning")) << run.words;
}

TEST_F(SegmentInput, NeverOverwritesAScanWithItsLabels) {
  fs::rename(plain_scan("a"), folder / "scans/a.label");
  const std::string before = read_file(folder / "scans/a.label");
  const ProgramRun run = run_program("segment " + shell_word(folder / "scans/a.label") +
                                     " --format kitti --output " + shell_word(folder / "scans"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(read_file(folder / "scans/a.label"), before);
}

TEST_F(SegmentInput, TouchesNothingWhereItCannotWriteWhatIsAskedFor) {
  ASSERT_EQ(segment_input(plain_scan("a")).exit_code, 0);
  const std::string before = read_file(output() / "run.json");
  EXPECT_EQ(segment_input(plain_scan("a"), "--clouds same").exit_code, 2);
  EXPECT_EQ(read_file(output() / "run.json"), before);
}

TEST_F(SegmentInput, PassesOverScansThatAreNoFiles) {
  const fs::path scan = plain_scan("a");
  fs::create_symlink("nothing.bin", folder / "scans/b.bin");
  fs::create_symlink("c.bin", folder / "scans/c.bin");
  fs::create_directories(folder / "scans/d.bin");
  const ProgramRun run = segment_input(folder / "scans", "--keep-going");
  EXPECT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(record()["skipped_scans"], 3);
}

TEST_F(SegmentInput, KeepsTimingOfNamesWithLineEnds) {
  const fs::path scan = plain_scan("two\nlines");
  ASSERT_EQ(segment_input(scan).exit_code, 0);
  ASSERT_EQ(segment_input(scan).exit_code, 0);
  const std::string text = timing();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
}

TEST_F(SegmentInput, NamesALoopOfLinksAndAFolderThatIsNoFile) {
  fs::create_directories(folder / "scans");
  fs::create_symlink("loop.bin", folder / "scans/loop.bin");
  const ProgramRun loop = segment_input(folder / "scans/loop.bin");
  EXPECT_EQ(loop.exit_code, 1);
  EXPECT_TRUE(contains(loop.words, "loop.bin"));
  fs::remove(folder / "scans/loop.bin");
  fs::create_directories(folder / "scans/x.bin");
  const ProgramRun directory = segment_input(folder / "scans");
  EXPECT_EQ(directory.exit_code, 1);
  EXPECT_TRUE(contains(directory.words, "x.bin"));
}

class SegmentRealInput : public test::WithSharedData {};

// Points, and the share of them that is ground between these bounds.
struct RealFile {
  const char* path;
  std::size_t points;
  double least_ground, greatest_ground;
};

TEST_F(SegmentRealInput, OtherSensorsThanKittis) {
  const test::TemporaryFolder output;
  for (const RealFile& file :
       {RealFile{"pcd/kitti_city_data_1_0000000000.pcd", 119978, 0.3, 0.8},
        {"pcd/kitti_city_data_2_0000000000.pcd", 123398, 0.3, 0.8},
        {"pcd/patchwork_128beam_binary_compressed.pcd", 240000, 0.1, 0.8},
        {"sensors/nuscenes_HDL32_1532402927647951.pcd.bin", 34688, 0.2, 0.8}}) {
    const ProgramRun run = run_program("segment " + shell_word(data() / file.path) + " --output " +
                                       shell_word(output.path()) + " --json");
    ASSERT_EQ(run.exit_code, 0) << run.words;
    const auto counts = nlohmann::json::parse(run.output)["counts"];
    EXPECT_EQ(counts["points"], file.points) << file.path;
    const double ground = counts["ground"].get<double>() / static_cast<double>(file.points);
    EXPECT_GT(ground, file.least_ground) << file.path;
    EXPECT_LT(ground, file.greatest_ground) << file.path;
  }
}

}  // namespace
}  // namespace groundgrid::program
