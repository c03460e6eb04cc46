// Short simulated drives through every scene with two sensors: the default must stay as accurate
// as it is. Each least or greatest value stands just beside the measured one.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "run_program.hpp"

namespace groundgrid {
namespace {

using nlohmann::json;
using test::run_program;
using test::shell_word;

struct Drive {
  std::string scene;
  std::string sensor;
  double least_iou;         // percent
  double greatest_dense_m;  // RMSE of the terrain
};

void PrintTo(const Drive& drive, std::ostream* out) { *out << drive.scene << ' ' << drive.sensor; }

json result_of(const std::string& command) {
  const test::ProgramRun run = run_program(command + " --json");
  EXPECT_EQ(run.exit_code, 0) << run.words;
  return run.exit_code == 0 ? json::parse(run.output) : json{};
}

class Accuracy : public ::testing::TestWithParam<Drive> {
 protected:
  Accuracy() {
    const test::ProgramRun run =
        run_program("simulate " + GetParam().scene + " " + shell_word(drive.path()) +
                    " --scans 20 --seed 7 --sensor " + GetParam().sensor);
    EXPECT_EQ(run.exit_code, 0) << run.words;
  }

  test::TemporaryFolder drive;
  test::TemporaryFolder output;
};

TEST_P(Accuracy, OfLabelsAndTerrainHolds) {
  const json labels = result_of("evaluate " + shell_word(drive.path()));
  EXPECT_GE(100.0 * labels["average"]["iou"].get<double>(), GetParam().least_iou);

  ASSERT_EQ(run_program("segment " + shell_word(drive.path()) + " --terrain --output " +
                        shell_word(output.path()))
                .exit_code,
            0);
  const json terrain =
      result_of("evaluate-terrain " + shell_word(output / "sequences/00/terrain.tif") + " " +
                shell_word(drive / "sequences/00/truth/terrain.tif"));
  const json& dense = terrain["density"]["dense"];
  EXPECT_GE(dense["coverage"].get<double>(), 0.97);
  EXPECT_LE(dense["rmse_m"].get<double>(), GetParam().greatest_dense_m);
}

// The comments hold what was measured. The terrain of so short a drive is mostly what a single
// place shows: twenty scans, two seconds.
INSTANTIATE_TEST_SUITE_P(
    Simulated, Accuracy,
    ::testing::Values(Drive{"urban", "hdl-64e", 94.1, 0.20},     // 94.40, 0.192
                      Drive{"urban", "vlp-16", 89.7, 0.29},      // 89.94, 0.270
                      Drive{"hill", "hdl-64e", 95.9, 0.20},      // 96.14, 0.185
                      Drive{"hill", "vlp-16", 95.3, 0.41},       // 95.56, 0.389
                      Drive{"motorway", "hdl-64e", 97.5, 0.08},  // 97.72, 0.068
                      Drive{"motorway", "vlp-16", 94.9, 0.15},   // 95.21, 0.139
                      Drive{"village", "hdl-64e", 94.1, 0.34},   // 94.39, 0.321
                      Drive{"village", "vlp-16", 87.1, 0.59},    // 87.42, 0.562
                      Drive{"offroad", "hdl-64e", 94.0, 0.06},   // 94.24, 0.057
                      Drive{"offroad", "vlp-16", 93.1, 0.06}));  // 93.44, 0.049

}  // namespace
}  // namespace groundgrid
