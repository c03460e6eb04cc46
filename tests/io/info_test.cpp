#include <nlohmann/json.hpp>

#include "run_program.hpp"
#include "shared_data.hpp"
#include "synthetic_dataset.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contains;
using test::ProgramRun;
using test::run_program;
using test::shell_word;

class Info : public ::testing::Test {
 protected:
  static ProgramRun info(const fs::path& input, const std::string& more = "") {
    return run_program("info " + shell_word(input) + " " + more);
  }
  static json info_json(const fs::path& input, const std::string& more = "") {
    const ProgramRun run = info(input, "--json " + more);
    EXPECT_EQ(run.exit_code, 0) << run.words;
    return json::parse(run.output);
  }

  // The synthetic scan turned upside down.
  [[nodiscard]] fs::path flipped_scan() const {
    std::vector<float> points = test::SyntheticScan().points;
    for (std::size_t i = 0; i < points.size(); i += 4) {
      points[i + 1] = -points[i + 1];
      points[i + 2] = -points[i + 2];
    }
    fs::path path = dataset.folder / "flipped.bin";
    test::write_numbers(path, points);
    return path;
  }

  test::SyntheticDataset dataset;
};

TEST_F(Info, TellsWhatIsInADataset) {
  dataset.add_sequence("00", 3);
  const json sequence = info_json(dataset.path())["sequences"][0];
  EXPECT_EQ(sequence["sequence"], "00");
  EXPECT_EQ(sequence["scans"], 3);
  EXPECT_EQ(sequence["missing_numbers"], 0);
  EXPECT_EQ(sequence["scans_with_labels"], 3);
  EXPECT_EQ(sequence["scans_read"], 1);
  EXPECT_EQ(sequence["poses"]["in_file"], 3);
  EXPECT_EQ(sequence["poses"]["scans_without"], 0);
  EXPECT_DOUBLE_EQ(sequence["poses"]["length_m"], 2.0);
  const json& scan = sequence["first_scan"];
  EXPECT_EQ(scan["format"], "kitti");
  EXPECT_EQ(scan["points"], test::SyntheticScan().size());
  EXPECT_EQ(scan["fields"][3]["name"], "intensity");
  EXPECT_EQ(scan["fields"][3]["max"], 0.5);
  EXPECT_EQ(scan["looks_flipped"], false);
  EXPECT_NEAR(scan["sensor_height_m"].get<double>(), 1.73, 0.02);
  // The nearest ring is 3 m away and 1.73 m down.
  EXPECT_NEAR(scan["range_m"]["min"].get<double>(), std::hypot(3.0, 1.73), 1e-5);
}

TEST_F(Info, SaysItInWords) {
  dataset.add_sequence("00", 3);
  const ProgramRun run = info(dataset.path());
  ASSERT_EQ(run.exit_code, 0) << run.words;
  for (const char* words : {"sequence 00: 3 scans, 000000 to 000002", "3 of 3 scans have labels",
                            "3 poses, 2.0 m driven", "LiDAR 1.73 m above the ground"})
    EXPECT_TRUE(contains(run.output, words));
  EXPECT_EQ(run.output.find('!'), std::string::npos);
}

TEST_F(Info, FindsGapsAndWhatIsMissing) {
  dataset.add_sequence("00", 5);
  fs::remove(dataset.scan_file("00", 1));
  fs::remove(dataset.label_file("00", 3));
  test::write_file(dataset.folder / "sequences/00/poses.txt",
                   "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 1\n1 0 0 0 0 1 0 0 0 0 1 90\n");
  const json sequence = info_json(dataset.path())["sequences"][0];
  EXPECT_EQ(sequence["missing_numbers"], 1);
  EXPECT_EQ(sequence["scans_with_labels"], 3);
  EXPECT_EQ(sequence["poses"]["scans_without"], 2);
  EXPECT_EQ(sequence["poses"]["jumps"], 1);
  EXPECT_EQ(sequence["poses"]["greatest_step_m"], 90.0);
}

TEST_F(Info, TellsWhatItCanBesideALoopOfLinks) {
  dataset.add_sequence("00", 1);
  for (const char* name : {"poses.txt", "labels"}) {
    fs::remove_all(dataset.folder / "sequences/00" / name);
    fs::create_symlink(name, dataset.folder / "sequences/00" / name);
  }
  const json sequence = info_json(dataset.path())["sequences"][0];
  EXPECT_EQ(sequence["scans_read"], 1);
  EXPECT_TRUE(contains(sequence["pose_problem"].get<std::string>(), "poses.txt: expected"));
}

TEST_F(Info, SaysWhyThereAreNoPoses) {
  dataset.add_sequence("00", 1);
  fs::remove(dataset.folder / "sequences/00/calib.txt");
  const json sequence = info_json(dataset.path())["sequences"][0];
  EXPECT_EQ(sequence["poses"], nullptr);
  EXPECT_TRUE(contains(sequence["pose_problem"].get<std::string>(), "calib.txt"));
}

TEST_F(Info, ReadsEveryScanIfAskedTo) {
  dataset.add_sequence("00", 3);
  fs::resize_file(dataset.scan_file("00", 1), 100);
  const json sequence = info_json(dataset.path(), "--every-scan")["sequences"][0];
  EXPECT_EQ(sequence["scans_read"], 2);
  EXPECT_EQ(sequence["points_read"], 2 * test::SyntheticScan().size());
  ASSERT_EQ(sequence["unreadable"].size(), 1U);
  EXPECT_TRUE(contains(sequence["unreadable"][0].get<std::string>(), "000001.bin"));
}

TEST_F(Info, SeesThatZIsFlipped) {
  const json scan = info_json(flipped_scan())["sequences"][0]["first_scan"];
  EXPECT_EQ(scan["looks_flipped"], true);
  EXPECT_TRUE(contains(scan["remarks"][0].get<std::string>(), "--lidar-rpy-deg 180,0,0"));
  const json turned =
      info_json(flipped_scan(), "--lidar-rpy-deg 180,0,0")["sequences"][0]["first_scan"];
  EXPECT_EQ(turned["looks_flipped"], false);
}

TEST_F(Info, SeesThatCoordinatesAreNotTheLidars) {
  std::vector<float> points = test::SyntheticScan().points;
  for (std::size_t i = 0; i < points.size(); i += 4) points[i] += 450000.0F;
  test::write_numbers(dataset.folder / "far.bin", points);
  const json scan = info_json(dataset.folder / "far.bin")["sequences"][0]["first_scan"];
  EXPECT_EQ(scan["outside_map"], test::SyntheticScan().size());
  EXPECT_FALSE(scan["remarks"].empty());
}

TEST_F(Info, CountsPointsThatAreNoMeasurement) {
  test::write_numbers<float>(dataset.folder / "odd.bin",
                             {std::nanf(""), 1, 1, 0, 0, 0, 0, 0, 5, 0, -1, 0, 1, INFINITY, 1, 0});
  const json scan = info_json(dataset.folder / "odd.bin")["sequences"][0]["first_scan"];
  EXPECT_EQ(scan["not_finite"], 2);
  EXPECT_EQ(scan["at_origin"], 1);
  EXPECT_NEAR(scan["range_m"]["max"].get<double>(), std::sqrt(26.0), 1e-6);
}

TEST_F(Info, SaysThatAViewpointIsNotUsed) {
  const auto remarks_with = [&](const std::string& viewpoint) {
    test::write_file(dataset.folder / "seen.pcd",
                     "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\n" +
                         viewpoint + "POINTS 1\nDATA ascii\n5 0 -1\n");
    return info_json(dataset.folder / "seen.pcd")["sequences"][0]["first_scan"]["remarks"].dump();
  };
  const std::string words = "VIEWPOINT 0 0 1.8 1 0 0 0 is not used";
  EXPECT_TRUE(contains(remarks_with("VIEWPOINT 0 0 1.8 1 0 0 0\n"), words));
  EXPECT_FALSE(contains(remarks_with("VIEWPOINT 0 0 0 1.0 0 0 0\n"), "VIEWPOINT"));
  EXPECT_FALSE(contains(remarks_with(""), "VIEWPOINT"));
  (void)remarks_with("VIEWPOINT 0 0 1.8 1 0 0 0\n");
  const ProgramRun run = test::run_program(
      "segment " + test::shell_word(dataset.folder / "seen.pcd") +
      " --sensor-height-m 1 --output " + test::shell_word(dataset.folder / "out"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.words, words));
}

TEST_F(Info, SeesThatAHeaderPromisesTooFewPoints) {
  test::write_file(
      dataset.folder / "long.pcd",
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
      "DATA binary\n" +
          std::string(36, '\1'));
  const json scan = info_json(dataset.folder / "long.pcd")["sequences"][0]["first_scan"];
  EXPECT_EQ(scan["points"], 1);
  EXPECT_EQ(scan["surplus_bytes"], 24);
  EXPECT_TRUE(contains(scan["remarks"][0].get<std::string>(), "24 bytes after the last point"));
}

TEST_F(Info, FailsWhereNothingCanBeRead) {
  test::write_file(dataset.folder / "cut.bin", "seven b");
  const ProgramRun run = info(dataset.folder / "cut.bin");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_TRUE(contains(run.words, "cut.bin"));
}

class InfoOnRealData : public test::WithSharedData {};

TEST_F(InfoOnRealData, NoRealScanLooksFlipped) {
  for (const char* input : {"pcd", "sensors/nuscenes_HDL32_1532402927647951.pcd.bin",
                            "semantickitti", "kitti_tracking_static/velodyne"}) {
    const ProgramRun run =
        run_program("info " + shell_word(data() / input) + " --every-scan --json");
    ASSERT_EQ(run.exit_code, 0) << run.words;
    const json result = json::parse(run.output);
    for (const json& sequence : result["sequences"]) {
      EXPECT_EQ(sequence["first_scan"]["looks_flipped"], false) << sequence["first_scan"]["file"];
      EXPECT_TRUE(sequence["unreadable"].empty());
      EXPECT_EQ(sequence["scans_read"], sequence["scans"]);
    }
  }
}

}  // namespace
}  // namespace groundgrid::program
