// `groundgrid reproduce` as users run it: the built program on small drives.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"
#include "synthetic_dataset.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contains;
using test::ProgramRun;
using test::run_program;
using test::shell_word;

class Reproduce : public ::testing::Test {
 protected:
  Reproduce() {
    dataset.add_sequence("00", 2);
    dataset.add_sequence("10", 1);
  }

  [[nodiscard]] ProgramRun reproduce(const std::string& more = "") const {
    return run_program("reproduce " + shell_word(dataset.path()) + " " + more);
  }

  test::SyntheticDataset dataset;
  test::TemporaryFolder pages;
};

TEST_F(Reproduce, PrintsTheTableAndSaysWhatIsMissing) {
  const ProgramRun run = reproduce();
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.output, "\n GroundGrid, published   96.05 "));
  EXPECT_TRUE(contains(run.output, "\n ours, preset paper "));
  EXPECT_TRUE(contains(run.output, "\n ours, preset default "));
  EXPECT_TRUE(contains(run.output, "Not in the dataset: 01, 02, 03, 04, 05, 06, 07, 08, 09."));
  EXPECT_TRUE(contains(run.output, "00 (2 of 4541), 10 (1 of 1201)."));
  EXPECT_TRUE(contains(run.words, "preset paper, sequence 10, 1 thread: 1 scan\n"));
}

TEST_F(Reproduce, HasTheFiguresOfEvaluate) {
  const json table = json::parse(reproduce("--json").output);
  EXPECT_EQ(table["command"], "reproduce");
  const char* const presets[] = {"paper", "default"};
  for (std::size_t row = 0; row < 2; ++row) {
    const ProgramRun run =
        run_program("evaluate " + shell_word(dataset.path()) + " --json --preset " + presets[row]);
    const json figures = json::parse(run.output);
    for (const char* const figure : {"precision", "recall", "f1", "accuracy", "iou"}) {
      const json& ours = table["figures"][figure][row + 1];
      EXPECT_EQ(ours["name"], std::string("ours, preset ") + presets[row]);
      EXPECT_NEAR(ours["sequences"]["00"].get<double>(),
                  figures["sequences"][0][figure].get<double>(), 1e-12);
      EXPECT_NEAR(ours["sequences"]["10"].get<double>(),
                  figures["sequences"][1][figure].get<double>(), 1e-12);
      EXPECT_NEAR(ours["same_sequences"].get<double>(), figures["average"][figure].get<double>(),
                  1e-12);
    }
  }
  for (std::size_t row = 1; row < 3; ++row) {
    EXPECT_GT(table["times"][row]["one_thread_ms"].get<double>(), 0.0);
    EXPECT_GT(table["times"][row]["all_threads_ms"].get<double>(), 0.0);
  }
}

TEST_F(Reproduce, KeepsTheFilesOfTheDataset) {
  const fs::path poses = dataset.folder / "sequences/00/poses.txt";
  const std::string before = test::read_file(poses);
  const ProgramRun run = reproduce("--output-markdown " + shell_word(poses));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(run.words, "poses.txt: would be overwritten"));
  EXPECT_EQ(test::read_file(poses), before);
}

TEST_F(Reproduce, WritesAPage) {
  const ProgramRun run =
      reproduce("--sequence 10 --output-markdown " + shell_word(pages / "table.md"));
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(test::read_file(pages / "table.md"), "\n## Precision\n"));
  EXPECT_TRUE(contains(run.output, "Precision"));
}

TEST_F(Reproduce, NoticesBeforeTheFirstScanThatThePageCannotBeWritten) {
  const ProgramRun run = reproduce("--output-markdown " + shell_word(pages / "no/table.md"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "table.md"));
  EXPECT_FALSE(contains(run.words, "preset paper"));
}

TEST_F(Reproduce, LeavesOutWhatIsNotInTheTable) {
  dataset.add_sequence("11", 1);
  dataset.add_sequence("04", 1, false);
  const ProgramRun run = reproduce("--json");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.words, "sequence 11 is not in the paper's Table I and is left out"));
  EXPECT_TRUE(contains(run.words, "sequence 04 has no labels and is left out"));
  EXPECT_EQ(json::parse(run.output)["sequences"].size(), 2U);
  EXPECT_EQ(reproduce("--sequence 11").exit_code, 1);
}

TEST_F(Reproduce, NamesMissingLabelsBeforeTheFirstScan) {
  fs::remove(dataset.label_file("10", 0));
  const ProgramRun run = reproduce();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_TRUE(contains(run.words, dataset.label_file("10", 0).string()));
  EXPECT_FALSE(contains(run.words, "preset paper"));
}

TEST_F(Reproduce, NamesMissingPosesBeforeTheFirstScan) {
  fs::remove(dataset.folder / "sequences/10/poses.txt");
  const ProgramRun run = reproduce();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "10/poses.txt"));
  EXPECT_FALSE(contains(run.words, "preset paper"));
}

TEST_F(Reproduce, EndsInGoodOrderWhenInterrupted) {
  std::string poses;
  for (std::size_t i = 0; i < 5000; ++i) {
    poses += "1 0 0 0 0 1 0 0 0 0 1 0\n";
    if (i < 2) continue;
    fs::create_hard_link(dataset.scan_file("00", 0), dataset.scan_file("00", i));
    fs::create_hard_link(dataset.label_file("00", 0), dataset.label_file("00", i));
  }
  test::write_file(dataset.folder / "sequences/00/poses.txt", poses);
  const ProgramRun run = run_program("reproduce " + shell_word(dataset.path()) +
                                         " --output-markdown " + shell_word(pages / "table.md"),
                                     "timeout --preserve-status --signal=INT 5 ");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_TRUE(contains(run.words, "interrupted"));
  EXPECT_TRUE(test::files_below(pages.path()).empty());
}

TEST_F(Reproduce, NeedsALabelledSequenceOfTheTable) {
  const ProgramRun run =
      run_program("reproduce " + shell_word(dataset.folder / "sequences/00/velodyne"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "no labelled sequence of the paper's Table I"));
  EXPECT_EQ(run_program("reproduce /nowhere").exit_code, 1);
}

}  // namespace
}  // namespace groundgrid::program
