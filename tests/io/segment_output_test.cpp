// The folder that is written to: other runs in it, what killed ones left, inputs that lie in it.
#include "io/hidden_file.hpp"
#include "io/output_folder.hpp"
#include "segment_fixture.hpp"

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

TEST_F(Segment, RefusesAFolderThatAnotherRunWritesTo) {
  dataset.add_sequence("00", 1);
  ASSERT_EQ(segment().exit_code, 0);
  const Names before = files_below(output());
  const std::string record_before = read_file(output() / "run.json");
  {
    const io::FolderLock other(output());
    const ProgramRun run = segment();
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_TRUE(contains(run.words, output().string() +
                                        ": expected a folder that no other run writes to, got one "
                                        "that is in use"));
  }
  EXPECT_EQ(files_below(output()), before);
  EXPECT_EQ(read_file(output() / "run.json"), record_before);
  EXPECT_EQ(segment().exit_code, 0);
}

TEST_F(Segment, RemovesWhatAKilledRunLeft) {
  dataset.add_sequence("00", 1);
  ASSERT_EQ(segment("--clouds pcd --terrain").exit_code, 0);
  const Names whole = files_below(output());
  for (const char* const below : {"", "sequences/00/predictions", "sequences/00/clouds"})
    test::write_file(output() / below / io::hidden_name(), "half");
  test::write_file(output() / ".groundgrid.lock", "");
  const ProgramRun run = segment("--clouds pcd --terrain");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.words, "predictions: removed 1 unfinished file of runs that were"));
  EXPECT_EQ(files_below(output()), whole);
}

// One of them may be done before the other one begins.
TEST_F(Segment, TwoAtOnceLeaveOneWholeAnswer) {
  dataset.add_sequence("00", 6);
  ASSERT_EQ(segment("--clouds pcd --terrain").exit_code, 0);
  const Names whole = files_below(output());
  const std::string command = shell_word(GROUNDGRID_EXECUTABLE) + " segment " +
                              shell_word(dataset.path()) + " --clouds pcd --terrain --output ";
  for (int pair = 0; pair < 5; ++pair) {
    const fs::path both = folder / std::to_string(pair);
    const ProgramRun run =
        run_program("segment " + shell_word(dataset.path()) + " --clouds pcd --terrain --output " +
                        shell_word(both),
                    command + shell_word(both) + " 2>" + shell_word(folder / "words") +
                        " & trap 'wait; exit $result' EXIT; result=0; ");
    const std::string words = run.words + read_file(folder / "words");
    EXPECT_EQ(files_below(both), whole) << words;
    for (const std::string& name : whole) {
      if (name == "run.json" || name == "timing.csv") continue;
      EXPECT_EQ(read_file(both / name), read_file(output() / name)) << name;
    }
    EXPECT_TRUE(nlohmann::json::parse(read_file(both / "run.json"))["complete"]);
  }
}

/// An input with a second name that is that of an output.
class SegmentOverInput : public Segment, public ::testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    dataset.add_sequence("00", 2);
    dataset.add_sequence("01", 1);
    fs::create_directories(output() / "sequences/00/predictions");
    fs::create_directories(output() / "sequences/00/clouds");
  }

  void expect_refused(const fs::path& input, const std::string& more) {
    const std::string before = read_file(input);
    ASSERT_NE(before, "");
    fs::create_hard_link(input, output() / GetParam());
    const Names files = files_below(folder.path());
    const ProgramRun run = segment("--clouds pcd --terrain --terrain-layers " + more);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(contains(run.words, input.string() + ": would be overwritten as " +
                                        (output() / GetParam()).string()));
    EXPECT_EQ(files_below(folder.path()), files);
    EXPECT_EQ(read_file(output() / GetParam()), before);
  }
};

TEST_P(SegmentOverInput, KeepsPoses) {
  const fs::path poses = folder / "my_poses.txt";
  fs::copy_file(dataset.folder / "sequences/00/poses.txt", poses);
  expect_refused(poses, "--sequence 00 --poses " + shell_word(poses));
}

TEST_P(SegmentOverInput, KeepsACalibration) {
  const fs::path poses = folder / "my_poses.txt";
  const fs::path calibration = folder / "my_calib.txt";
  fs::copy_file(dataset.folder / "sequences/00/poses.txt", poses);
  fs::copy_file(dataset.folder / "sequences/00/calib.txt", calibration);
  expect_refused(calibration, "--sequence 00 --poses " + shell_word(poses) + " --calibration " +
                                  shell_word(calibration));
}

TEST_P(SegmentOverInput, KeepsAParameterFile) {
  const fs::path config = folder / "config.toml";
  test::write_file(config, "max_step_m = 0.1\n");
  expect_refused(config, "--config " + shell_word(config));
}

TEST_P(SegmentOverInput, KeepsAnyScan) { expect_refused(dataset.scan_file("01", 0), ""); }

TEST_P(SegmentOverInput, KeepsThePosesOfADataset) {
  expect_refused(dataset.folder / "sequences/01/poses.txt", "");
}

TEST_P(SegmentOverInput, KeepsTrueLabels) { expect_refused(dataset.label_file("00", 1), ""); }

INSTANTIATE_TEST_SUITE_P(Outputs, SegmentOverInput,
                         ::testing::Values("run.json", "timing.csv", "sequences/00/terrain.tif",
                                           "sequences/00/terrain_layers.tif",
                                           "sequences/00/clouds/000001.pcd",
                                           "sequences/00/predictions/000000.label"));

TEST_F(Segment, KeepsPosesThatAreNamedAsItsRecord) {
  dataset.add_sequence("00", 1);
  const fs::path poses = output() / "run.json";
  test::write_file(poses, "1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(segment("--poses " + shell_word(poses)).exit_code, 2);
  EXPECT_EQ(files_below(output()), (Names{"run.json"}));
}

}  // namespace
}  // namespace groundgrid::program
