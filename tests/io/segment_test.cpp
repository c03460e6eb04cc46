// What `segment` does where all is well.
#include "segment_fixture.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contains;
using test::files_below;
using test::Names;
using test::ProgramRun;
using test::read_file;
using test::run_program;
using test::Segment;
using test::shell_word;

TEST_F(Segment, WritesALabelForEveryPoint) {
  dataset.add_sequence("00", 2, false);
  const ProgramRun run = segment("--sensor-height-m 1.73");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(files_below(output()), (Names{"run.json", "sequences/00/predictions/000000.label",
                                          "sequences/00/predictions/000001.label", "timing.csv"}));
  const std::string labels = read_file(output() / "sequences/00/predictions/000001.label");
  EXPECT_EQ(labels.size(), test::SyntheticScan().size() * sizeof(std::uint32_t));
  EXPECT_EQ(run.output, "");
  EXPECT_TRUE(contains(run.words, "sensor 1.73 m above the ground, as given"));
}

TEST_F(Segment, RecordsTheRun) {
  dataset.add_sequence("00", 2);
  dataset.add_sequence("01", 1);
  ASSERT_EQ(segment("--preset paper --resolution-m 0.4").exit_code, 0);
  const json run = record();
  EXPECT_EQ(run["complete"], true);
  EXPECT_EQ(run["arguments"][0], "segment");
  EXPECT_EQ(run["arguments"].back(), "0.4");
  EXPECT_EQ(run["preset"], "paper");
  EXPECT_EQ(run["config"]["resolution_m"], 0.4);
  EXPECT_EQ(run["config"]["sensor_height_m"], nullptr);
  EXPECT_EQ(run["input"], dataset.path().string());
  EXPECT_EQ(run["counts"]["scans"], 3);
  EXPECT_EQ(run["counts"]["points"], 3 * test::SyntheticScan().size());
  EXPECT_EQ(run["sequences"][0]["counts"]["scans"], 2);
  EXPECT_EQ(run["sequences"][1]["sequence"], "01");
  EXPECT_EQ(run["sequences"][0]["sensor_height"]["estimated"], true);
}

TEST_F(Segment, PrintsTheRecordAsJsonAlone) {
  dataset.add_sequence("00", 1);
  const ProgramRun run = segment("--json");
  ASSERT_EQ(run.exit_code, 0);
  EXPECT_EQ(json::parse(run.output), record());
}

TEST_F(Segment, TakesSequencesOneAfterAnother) {
  dataset.add_sequence("00", 2);
  dataset.add_sequence("01", 1);
  ASSERT_EQ(segment("--sequence 01").exit_code, 0);
  ASSERT_EQ(segment("--sequence 00").exit_code, 0);
  EXPECT_EQ(files_below(output()).size(), 5U);
  EXPECT_TRUE(contains(timing(), "sequence,scan,points,milliseconds\n00,000000,"));
  EXPECT_TRUE(contains(timing(), "\n00,000001,"));
  EXPECT_TRUE(contains(timing(), "\n01,000000,"));
  EXPECT_EQ(record()["sequences"].size(), 1U);
}

TEST_F(Segment, GivesTheSameBytesAgain) {
  dataset.add_sequence("00", 3);
  ASSERT_EQ(segment().exit_code, 0);
  const fs::path label_file = output() / "sequences/00/predictions/000002.label";
  const std::string labels = read_file(label_file);
  ASSERT_EQ(segment("--threads 2").exit_code, 0);
  EXPECT_EQ(read_file(label_file), labels);
}

TEST_F(Segment, TakesScansWhoseNumbersHaveGaps) {
  dataset.add_sequence("00", 4);
  fs::remove(dataset.scan_file("00", 0));
  fs::remove(dataset.scan_file("00", 2));
  ASSERT_EQ(segment().exit_code, 0);
  EXPECT_EQ(record()["counts"]["scans"], 2);
}

TEST_F(Segment, ReportsThatTheMapStartsAnew) {
  dataset.add_sequence("00", 3);
  dataset.add_sequence("01", 1);
  test::write_file(dataset.folder / "sequences/00/poses.txt",
                   "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 1\n"
                   "1 0 0 0 0 1 0 0 0 0 1 101\n");
  const ProgramRun run = segment();
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.words, dataset.scan_file("00", 2).string() + ": the map starts anew"));
  EXPECT_FALSE(contains(run.words, dataset.scan_file("00", 1).string()));
  EXPECT_EQ(record()["sequences"][0]["map_restarts"], 1);
  EXPECT_EQ(record()["sequences"][1]["map_restarts"], 0);
}

TEST_F(Segment, SaysWhereNoScanShowsTheSensorHeight) {
  std::vector<float> wall;
  for (int column = 0; column < 100; ++column)
    for (int row = 0; row < 20; ++row)
      for (const double value : {-5.0 + 0.1 * column, 6.0, -1.4 + 0.15 * row, 0.5})
        wall.push_back(static_cast<float>(value));
  dataset.add_sequence("00", 2);
  for (const std::size_t scan : {0U, 1U}) test::write_numbers(dataset.scan_file("00", scan), wall);
  const ProgramRun run = segment();
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.words, "sensor height not found: no flat ground in any scan"));
  EXPECT_EQ(record()["sequences"][0]["sensor_height"], nullptr);
}

TEST_F(Segment, TakesPlainFilesAsSingleScans) {
  dataset.add_sequence("00", 2);
  const auto plain = [&](const fs::path& input) {
    return run_program("segment " + shell_word(input) + " --output " + shell_word(output()));
  };
  const ProgramRun file = plain(dataset.scan_file("00", 1));
  ASSERT_EQ(file.exit_code, 0) << file.words;
  EXPECT_EQ(files_below(output()), (Names{"000001.label", "run.json", "timing.csv"}));
  EXPECT_TRUE(contains(file.words, "single scan"));
  EXPECT_EQ(record()["single_scan"], true);
  ASSERT_EQ(plain(dataset.folder / "sequences/00/velodyne").exit_code, 0);
  EXPECT_EQ(files_below(output()),
            (Names{"000000.label", "000001.label", "run.json", "timing.csv"}));
}

}  // namespace
}  // namespace groundgrid::program
