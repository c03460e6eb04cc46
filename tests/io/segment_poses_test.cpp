// Poses that are missing, broken or too few.
#include "segment_fixture.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contains;
using test::files_below;
using test::Names;
using test::ProgramRun;
using test::Segment;

TEST_F(Segment, NamesTheScanWhosePoseIsOutOfBounds) {
  dataset.add_sequence("00", 2);
  test::write_file(dataset.folder / "sequences/00/poses.txt",
                   "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 1e12\n");
  const ProgramRun run = segment();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, dataset.scan_file("00", 1).string()));
  EXPECT_EQ(segment("--keep-going").exit_code, 0);
}

TEST_F(Segment, TakesScansThatNumberedPosesLeaveOutAsSingleOnes) {
  const test::SyntheticScan scan;
  const fs::path scans = folder / "data_3d_raw/drive/velodyne_points/data";
  for (const char* const name : {"0.bin", "1.bin", "2.bin"})
    test::write_numbers(scans / name, scan.points);
  const fs::path poses = folder / "data_poses/drive/poses.txt";
  test::write_file(poses, "0 1 0 0 0 0 1 0 0 0 0 1 0\n2 1 0 0 1 0 1 0 0 0 0 1 0\n");
  const auto run = [&](const fs::path& input, const std::string& more) {
    return test::run_program("segment " + test::shell_word(input) + " --output " +
                             test::shell_word(output()) + " --terrain " + more);
  };
  const ProgramRun dataset_run = run(folder.path(), "");
  ASSERT_EQ(dataset_run.exit_code, 0) << dataset_run.words;
  EXPECT_TRUE(contains(dataset_run.words,
                       "sequence drive: 1 scans have no pose: they are segmented as single scans"));
  EXPECT_TRUE(contains(dataset_run.words, "calibration: nothing of that name"));
  EXPECT_EQ(record()["sequences"][0]["without_pose"], 1);
  EXPECT_EQ(record()["complete"], true);
  const std::string alone = test::read_file(output() / "sequences/drive/predictions/1.label");
  EXPECT_EQ(alone.size(), 4 * scan.size());
  EXPECT_TRUE(fs::exists(output() / "sequences/drive/terrain.tif"));
  ASSERT_EQ(run(scans, "--poses " + test::shell_word(poses)).exit_code, 0);
  EXPECT_EQ(test::read_file(output() / "1.label"), alone);
  ASSERT_EQ(run(scans / "1.bin", "").exit_code, 0);
  EXPECT_EQ(test::read_file(output() / "1.label"), alone);
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

TEST_F(Segment, NamesALoopOfLinksInPlaceOfPoses) {
  dataset.add_sequence("00", 1);
  dataset.add_sequence("01", 1);
  const fs::path poses = dataset.folder / "sequences/00/poses.txt";
  fs::remove(poses);
  fs::create_symlink("poses.txt", poses);
  const ProgramRun run = segment();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, poses.string() + ": expected"));
  ASSERT_EQ(segment("--keep-going").exit_code, 0);
  EXPECT_EQ(record()["skipped_sequences"][0]["sequence"], "00");
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

}  // namespace
}  // namespace groundgrid::program
