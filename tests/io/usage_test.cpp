#include <gtest/gtest.h>

#include "run_program.hpp"

namespace groundgrid::program {
namespace {

using test::contains;
using test::ProgramRun;
using test::run_program;

TEST(Usage, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(run_program("--help").exit_code, 0);
  EXPECT_EQ(run_program("--version").exit_code, 0);
  const ProgramRun help = run_program("segment --help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_TRUE(contains(help.output, "--sensor-height-m"));
  EXPECT_TRUE(contains(help.output, "--threads"));
}

class WrongUsage : public ::testing::TestWithParam<const char*> {};

TEST_P(WrongUsage, EndsWithTwoAndWordsOnStandardError) {
  const ProgramRun run = run_program(GetParam());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.output, "");
  EXPECT_NE(run.words, "");
}

INSTANTIATE_TEST_SUITE_P(
    Arguments, WrongUsage,
    ::testing::Values("", "paint", "segment", "segment /tmp", "segment /tmp --output x --colour",
                      "evaluate", "evaluate /tmp --preset best", "evaluate /tmp --json --csv",
                      "evaluate /tmp --resolution-m", "evaluate /tmp --resolution-m wide",
                      "evaluate /tmp --resolution-m ''", "evaluate /tmp --resolution-m 1e9",
                      "evaluate /tmp --threads -1", "evaluate /tmp --threads 1.5",
                      "evaluate /tmp --predictions /tmp --preset paper",
                      "evaluate /tmp --predictions /tmp --resolution-m 0.3"));

TEST(Usage, AnArrayInAParameterFileIsNoValue) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "p.toml", "extent_m = [120\n");
  const ProgramRun run =
      run_program("evaluate /tmp --config " + test::shell_word(folder / "p.toml"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(run.words, (folder / "p.toml").string()));
  EXPECT_TRUE(contains(run.words, "extent_m"));
}

TEST(Usage, AValueOutOfRangeInAParameterFileIsPlaced) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "p.toml", "# metres\nresolution_m = 1e9\n");
  const ProgramRun run =
      run_program("evaluate /tmp --config " + test::shell_word(folder / "p.toml"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(run.words, (folder / "p.toml").string() + ", line 2: "));
  EXPECT_TRUE(contains(run.words, "resolution_m"));
}

class BadInput : public ::testing::TestWithParam<const char*> {};

TEST_P(BadInput, EndsWithOneAndWordsOnStandardError) {
  const ProgramRun run = run_program(GetParam());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_TRUE(contains(run.words, "/nowhere"));
}

INSTANTIATE_TEST_SUITE_P(Arguments, BadInput,
                         ::testing::Values("segment /nowhere --output /nowhere/out",
                                           "evaluate /nowhere",
                                           "evaluate /tmp --config /nowhere/parameters.toml"));

}  // namespace
}  // namespace groundgrid::program
