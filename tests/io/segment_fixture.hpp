#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "run_program.hpp"
#include "synthetic_dataset.hpp"

namespace groundgrid::test {

/// `groundgrid segment` as users run it: the built program, files in, files out.
class Segment : public ::testing::Test {
 protected:
  [[nodiscard]] ProgramRun segment(const std::string& more = "",
                                   const std::string& before = "") const {
    return run_program(
        "segment " + shell_word(dataset.path()) + " --output " + shell_word(output()) + " " + more,
        before);
  }
  [[nodiscard]] std::filesystem::path output() const { return folder / "out"; }
  [[nodiscard]] nlohmann::json record() const {
    return nlohmann::json::parse(read_file(output() / "run.json"));
  }
  [[nodiscard]] std::string timing() const { return read_file(output() / "timing.csv"); }

  SyntheticDataset dataset;
  TemporaryFolder folder;
};

}  // namespace groundgrid::test
