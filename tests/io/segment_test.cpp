// `groundgrid segment` as users run it: the built program, files in, files out.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "oversized_file.hpp"
#include "run_program.hpp"
#include "sanitized.hpp"
#include "synthetic_dataset.hpp"

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
using test::shell_word;
using test::SyntheticDataset;

class Segment : public ::testing::Test {
 protected:
  [[nodiscard]] ProgramRun segment(const std::string& more = "",
                                   const std::string& before = "") const {
    return run_program(
        "segment " + shell_word(dataset.path()) + " --output " + shell_word(output()) + " " + more,
        before);
  }
  [[nodiscard]] fs::path output() const { return folder / "out"; }
  [[nodiscard]] json record() const { return json::parse(read_file(output() / "run.json")); }
  [[nodiscard]] std::string timing() const { return read_file(output() / "timing.csv"); }

  SyntheticDataset dataset;
  test::TemporaryFolder folder;
};

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
  ASSERT_EQ(segment("--preset paper --cell-size-m 0.4").exit_code, 0);
  const json run = record();
  EXPECT_EQ(run["complete"], true);
  EXPECT_EQ(run["preset"], "paper");
  EXPECT_EQ(run["config"]["cell_size_m"], 0.4);
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

TEST_F(Segment, NamesTheScanWhosePoseIsOutOfBounds) {
  dataset.add_sequence("00", 2);
  test::write_file(dataset.folder / "sequences/00/poses.txt",
                   "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 1e12\n");
  const ProgramRun run = segment();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, dataset.scan_file("00", 1).string()));
  EXPECT_EQ(segment("--keep-going").exit_code, 0);
}

TEST_F(Segment, SaysWhatToDoWithoutPoses) {
  dataset.add_sequence("00", 2);
  fs::remove(dataset.folder / "sequences/00/poses.txt");
  const ProgramRun run = segment();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "poses.txt"));
  EXPECT_TRUE(contains(run.words, "--single-scan"));
  EXPECT_EQ(segment("--single-scan").exit_code, 0);
  EXPECT_EQ(record()["single_scan"], true);
}

TEST_F(Segment, ReadsAllPosesBeforeTheFirstScan) {
  dataset.add_sequence("00", 1);
  dataset.add_sequence("01", 3);
  const fs::path poses = dataset.folder / "sequences/01/poses.txt";
  const std::string one = "1 0 0 0 0 1 0 0 0 0 1 0\n";
  for (const std::string& text : {std::string("no poses\n"), one + one}) {
    test::write_file(poses, text);
    const ProgramRun run = segment();
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_TRUE(contains(run.words, poses.string() + ", line "));
    EXPECT_FALSE(fs::exists(output()));
  }
}

TEST_F(Segment, SkipsSequencesWithoutUsablePosesIfAskedTo) {
  dataset.add_sequence("00", 2);
  dataset.add_sequence("01", 1);
  dataset.add_sequence("02", 3);
  fs::remove(dataset.folder / "sequences/00/poses.txt");
  test::write_file(dataset.folder / "sequences/02/calib.txt", "P0: 1 2 3\n");
  const ProgramRun run = segment("--keep-going");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.words, "skipped sequence 00: "));
  EXPECT_EQ(files_below(output()),
            (Names{"run.json", "sequences/01/predictions/000000.label", "timing.csv"}));
  const json written = record();
  EXPECT_EQ(written["complete"], false);
  EXPECT_EQ(written["skipped_scans"], 5);
  EXPECT_EQ(written["sequences"].size(), 1U);
  ASSERT_EQ(written["skipped_sequences"].size(), 2U);
  const json& last = written["skipped_sequences"][1];
  EXPECT_EQ(last["sequence"], "02");
  EXPECT_EQ(last["scans"], 3);
  EXPECT_TRUE(contains(last["reason"].get<std::string>(), "calib.txt"));
}

TEST_F(Segment, SkipsScansWithoutAPoseIfAskedTo) {
  dataset.add_sequence("00", 3);
  test::write_file(dataset.folder / "sequences/00/poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  ASSERT_EQ(segment("--keep-going").exit_code, 0);
  EXPECT_EQ(record()["counts"]["scans"], 1);
  EXPECT_EQ(record()["sequences"][0]["skipped"].size(), 2U);
}

TEST_F(Segment, FailsWhereNoSequenceIsGood) {
  dataset.add_sequence("00", 2);
  fs::remove(dataset.folder / "sequences/00/poses.txt");
  const ProgramRun run = segment("--keep-going");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "all 2 were skipped"));
  EXPECT_FALSE(fs::exists(output() / "run.json"));
}

TEST_F(Segment, TakesPosesThatAreNearlyRigid) {
  dataset.add_sequence("00", 2);
  test::write_file(dataset.folder / "sequences/00/poses.txt",
                   "1 0 0 0 0 1 0 0 0 0 1 0\n1.0004 0 0 0 0 1.0004 0 0 0 0 1.0004 1\n");
  const ProgramRun run = segment();
  EXPECT_EQ(run.exit_code, 0) << run.words;
}

TEST_F(Segment, ReportsThatTheMapStartsAnew) {
  dataset.add_sequence("00", 3);
  dataset.add_sequence("01", 1);
  test::write_file(dataset.folder / "sequences/00/poses.txt",
                   "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 1\n"
                   "1 0 0 0 0 1 0 0 0 0 1 101\n");
  const ProgramRun run = segment();
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.words, dataset.scan_file("00", 2).string() + ": its pose is more than"));
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

TEST_F(Segment, StopsAtABadScanAndKeepsWhatIsFinished) {
  dataset.add_sequence("00", 3);
  ASSERT_EQ(segment("--sequence 00").exit_code, 0);
  fs::remove_all(output() / "sequences");
  fs::resize_file(dataset.scan_file("00", 1), 100);
  const ProgramRun run = segment();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, dataset.scan_file("00", 1).string()));
  // The record of the run before must not vouch for this one.
  EXPECT_EQ(files_below(output()), (Names{"sequences/00/predictions/000000.label", "timing.csv"}));
  EXPECT_TRUE(contains(timing(), "\n00,000000,"));
}

TEST_F(Segment, KeepsGoingIfAskedTo) {
  dataset.add_sequence("00", 4);
  fs::resize_file(dataset.scan_file("00", 1), 100);
  fs::resize_file(dataset.scan_file("00", 2), 0);
  const ProgramRun run = segment("--keep-going");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.words, "000001.bin"));
  EXPECT_TRUE(contains(run.words, "holds no points"));
  const json written = record();
  EXPECT_EQ(written["complete"], false);
  EXPECT_EQ(written["skipped_scans"], 2);
  EXPECT_EQ(written["counts"]["scans"], 2);
  EXPECT_EQ(written["sequences"][0]["skipped"][0]["file"], dataset.scan_file("00", 1).string());
}

TEST_F(Segment, FailsWhereNoScanIsGood) {
  dataset.add_sequence("00", 1);
  fs::resize_file(dataset.scan_file("00", 0), 7);
  EXPECT_EQ(segment("--keep-going").exit_code, 1);
  EXPECT_FALSE(fs::exists(output() / "run.json"));
}

TEST_F(Segment, RefusesAnEmptyScan) {
  dataset.add_sequence("00", 1);
  fs::resize_file(dataset.scan_file("00", 0), 0);
  const ProgramRun run = segment();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "holds no points"));
}

TEST_F(Segment, NoticesAFullDiskAndLeavesNoHalfFile) {
  dataset.add_sequence("00", 2);
  const ProgramRun run = segment("--keep-going", "trap '' XFSZ; ulimit -f 8; ");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "000000.label: expected a place to write to"));
  EXPECT_EQ(files_below(output()), (Names{"timing.csv"}));
}

TEST_F(Segment, NoticesThatStandardOutputIsFull) {
  dataset.add_sequence("00", 1);
  const ProgramRun run = run_program(
      "segment " + shell_word(dataset.path()) + " --output " + shell_word(output()) + " --json", "",
      "/dev/full");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "standard output"));
}

TEST_F(Segment, NoticesThatNobodyReadsItsOutput) {
  dataset.add_sequence("00", 1);
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const fs::path to_closed_pipe = "/dev/fd/" + std::to_string(ends[1]);
  const ProgramRun run = run_program(
      "segment " + shell_word(dataset.path()) + " --output " + shell_word(output()) + " --json", "",
      to_closed_pipe);
  ::close(ends[1]);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "standard output: expected a place to write to"));
}

TEST_F(Segment, RefusesAFileAsOutputFolder) {
  dataset.add_sequence("00", 1);
  test::write_file(output(), "in the way");
  EXPECT_EQ(segment().exit_code, 1);
  EXPECT_EQ(read_file(output()), "in the way");
}

// Runs that the test watches from outside: many scans, all of them one file.
class LongRun : public Segment {
 protected:
  void add_scans(std::size_t scans) const {
    dataset.add_sequence("00", 1);
    std::string poses;
    for (std::size_t i = 0; i < scans; ++i) {
      if (i > 0) fs::create_symlink(dataset.scan_file("00", 0), dataset.scan_file("00", i));
      poses += "1 0 0 0 0 1 0 0 0 0 1 0\n";
    }
    test::write_file(dataset.folder / "sequences/00/poses.txt", poses);
  }

  [[nodiscard]] pid_t start() const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDERR_FILENO);
    ::execl(GROUNDGRID_EXECUTABLE, "groundgrid", "segment", dataset.path().c_str(), "--output",
            output().c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
};

#if !defined(GROUNDGRID_SANITIZED)
TEST_F(Segment, SkipsAScanThatMemoryDoesNotHold) {
  dataset.add_sequence("00", 2);
  test::make_sparse_file(dataset.scan_file("00", 0), std::uintmax_t{16} << 30U);
  const std::string little_memory = "ulimit -v 4000000; ";
  const ProgramRun run = segment("", little_memory);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, dataset.scan_file("00", 0).string()));
  ASSERT_EQ(segment("--keep-going", little_memory).exit_code, 0);
  EXPECT_EQ(record()["sequences"][0]["skipped"][0]["file"], dataset.scan_file("00", 0).string());
}

TEST_F(Segment, SaysWhichParametersMakeTheMapTooLarge) {
  dataset.add_sequence("00", 1);
  for (const std::string more : {"", " --keep-going"}) {
    const ProgramRun run =
        segment("--cell-size-m 0.04 --map-extent-m 160" + more, "ulimit -v 1000000; ");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_TRUE(contains(run.words, "4000 x 4000 cells (map_extent_m = 160, cell_size_m = 0.04)"));
    EXPECT_TRUE(contains(run.words, "about 2400 MB"));
  }
}

TEST_F(LongRun, KeepsItsMemoryFlat) {
  const auto peak_kilobytes = [this](std::size_t scans) {
    fs::remove_all(dataset.folder / "sequences");
    add_scans(scans);
    rusage usage{};
    int status = 0;
    EXPECT_GT(::wait4(start(), &status, 0, &usage), 0);
    EXPECT_EQ(status, 0);
    return usage.ru_maxrss;
  };
  const long few = peak_kilobytes(5);
  const long many = peak_kilobytes(200);
  EXPECT_LT(many, 150'000);
  EXPECT_LT(many, few + 2'000);
}
#endif

class Interrupted : public LongRun, public ::testing::WithParamInterface<int> {};

TEST_P(Interrupted, EndsInGoodOrder) {
  add_scans(5000);
  const pid_t child = start();
  while (!fs::exists(output() / "sequences/00/predictions/000002.label"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ::kill(child, GetParam());
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const Names files = files_below(output());
  EXPECT_LT(files.size(), 5000U);
  EXPECT_FALSE(fs::exists(output() / "run.json"));
  const auto bytes = test::SyntheticScan().size() * sizeof(std::uint32_t);
  for (const std::string& file : files) {
    if (file == "timing.csv") continue;
    EXPECT_EQ(fs::file_size(output() / file), bytes) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, ::testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace groundgrid::program
