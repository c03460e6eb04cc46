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
  EXPECT_GE(dense["coverage"].get<double>(), 0.965);
  EXPECT_LE(dense["rmse_m"].get<double>(), GetParam().greatest_dense_m);
}

// The comments hold what was measured. The terrain of so short a drive is mostly what a single
// place shows: twenty scans, two seconds.
INSTANTIATE_TEST_SUITE_P(
    Simulated, Accuracy,
    ::testing::Values(Drive{"urban", "hdl-64e", 93.6, 0.22},     // 93.87, 0.209
                      Drive{"urban", "vlp-16", 90.5, 0.37},      // 90.77, 0.350
                      Drive{"hill", "hdl-64e", 96.0, 0.22},      // 96.23, 0.210
                      Drive{"hill", "vlp-16", 95.1, 0.40},       // 95.38, 0.380
                      Drive{"motorway", "hdl-64e", 97.5, 0.07},  // 97.70, 0.067
                      Drive{"motorway", "vlp-16", 95.0, 0.15},   // 95.23, 0.139
                      Drive{"village", "hdl-64e", 93.8, 0.33},   // 94.01, 0.312
                      Drive{"village", "vlp-16", 86.5, 0.48},    // 86.70, 0.461
                      Drive{"offroad", "hdl-64e", 94.0, 0.06},   // 94.28, 0.056
                      Drive{"offroad", "vlp-16", 93.2, 0.05}));  // 93.47, 0.048

}  // namespace
}  // namespace groundgrid
