#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "image_checks.hpp"
#include "read_png.hpp"
#include "run_program.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::test {

/// `groundgrid render` as users run it: the built program, files in, a picture out.
class Render : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path output(const std::string& name = "picture.png") const {
    return folder / name;
  }
  [[nodiscard]] ProgramRun render(const std::string& arguments) const {
    return run_program("render " + arguments + " --output " + shell_word(output()));
  }
  [[nodiscard]] rendering::Image picture() const { return read_png(output()); }

  /// The run must fail so, name this in its message and write nothing.
  static void expect_failure(const ProgramRun& run, int exit_code, const std::string& words) {
    EXPECT_EQ(run.exit_code, exit_code) << run.words;
    EXPECT_TRUE(contains(run.words, words));
    EXPECT_EQ(run.output, "");
  }

  TemporaryFolder folder;
};

}  // namespace groundgrid::test
