// Scans that are broken, and outputs that cannot be written.
#include <unistd.h>

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

TEST_F(Segment, OutlivesTheSignalOfALimitedFileSize) {
  dataset.add_sequence("00", 2);
  const ProgramRun run = segment("", "ulimit -f 8; ");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(files_below(output()), (Names{"timing.csv"}));
}

TEST_F(Segment, NamesAFolderInPlaceOfItsRecord) {
  dataset.add_sequence("00", 1);
  test::write_file(output() / "run.json/file", "in the way");
  const ProgramRun run = segment();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "run.json: expected a file that can be replaced"));
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

TEST_F(Segment, NamesAFolderThatCannotBeWrittenTo) {
  dataset.add_sequence("00", 1);
  const ProgramRun run =
      run_program("segment " + shell_word(dataset.path()) + " --output /proc/groundgrid");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "/proc/groundgrid: expected a folder to write to"));
}

TEST_F(Segment, RefusesAFileAsOutputFolder) {
  dataset.add_sequence("00", 1);
  test::write_file(output(), "in the way");
  EXPECT_EQ(segment().exit_code, 1);
  EXPECT_EQ(read_file(output()), "in the way");
}

}  // namespace
}  // namespace groundgrid::program
