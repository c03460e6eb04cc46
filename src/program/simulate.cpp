#include "program/simulate.hpp"

#include <spdlog/spdlog.h>

#include <CLI/Validators.hpp>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "io/atomic_file.hpp"
#include "program/interrupt.hpp"
#include "program/json_text.hpp"
#include "program/progress_bar.hpp"
#include "program/version.hpp"
#include "simulation/scene.hpp"
#include "simulation/simulation.hpp"
#include "simulation/version.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using simulation::Motion;

struct SimulateOptions {
  fs::path output;
  std::string sequence = "00";
  std::string sensor = "hdl-64e";
  double height_m = 0.0;
  simulation::DriveOptions drive;
};

fs::path sequence_folder(const SimulateOptions& options) {
  return options.output / "sequences" / options.sequence;
}

// Written last, it marks a whole drive.
void write_record(const SimulateOptions& options, std::size_t points) {
  const nlohmann::ordered_json json{
      {"program", "groundgrid"},
      {"version", version()},
      {"command", "simulate"},
      {"simulated", true},
      {"simulation_version", simulation::kSimulationVersion},
      {"scene", options.drive.scene},
      {"sensor", options.sensor},
      {"sensor_height_m", options.drive.sensor.T_base_sensor.translation().z()},
      {"scans", options.drive.scans},
      {"seed", options.drive.seed},
      {"motion", options.drive.motion == Motion::corrected ? "corrected" : "distorted"},
      {"pose_noise_m", options.drive.pose_noise_m},
      {"pose_drift_m", options.drive.pose_drift_m},
      {"points", points}};
  io::write_text(sequence_folder(options) / "truth" / "drive.json", to_text(json));
}

void simulate(SimulateOptions& options) {
  options.drive.sensor = simulation::make_sensor(options.sensor);
  if (options.height_m > 0.0)
    options.drive.sensor.T_base_sensor.translation().z() = options.height_m;
  ProgressBar progress(options.drive.scans);
  const auto begin = std::chrono::steady_clock::now();
  std::size_t points = 0;
  simulation::simulate_drive(options.drive, sequence_folder(options), [&](std::size_t in_scan) {
    check_interrupt();
    points += in_scan;
    progress.advance();
  });
  write_record(options, points);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  spdlog::info("{} scans with {} points on average in {:.1f} s are in {}", options.drive.scans,
               points / options.drive.scans, seconds.count(), sequence_folder(options).string());
}

void add_errors(CLI::App& command, simulation::DriveOptions& drive) {
  command
      .add_option("--motion", drive.motion,
                  "corrected: all points in the frame of the scan's middle; distorted: as the "
                  "moving sensor saw them [corrected]")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Motion>{
          {"corrected", Motion::corrected}, {"distorted", Motion::distorted}}));
  command
      .add_option("--pose-noise", drive.pose_noise_m,
                  "Standard deviation of each pose's error, metres [0]")
      ->check(CLI::Range(0.0, 10.0));
  command
      .add_option("--pose-drift", drive.pose_drift_m,
                  "Standard deviation of the drift over a metre driven, metres [0]")
      ->check(CLI::Range(0.0, 1.0));
}

}  // namespace

void add_simulate(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "simulate", "Simulate a drive with exact labels and terrain, in SemanticKITTI layout");
  const auto options = std::make_shared<SimulateOptions>();
  command->add_option("SCENE", options->drive.scene, "What to drive through")
      ->required()
      ->check(CLI::IsMember(simulation::scene_names()));
  command->add_option("OUT", options->output, "Folder of the dataset")->required();
  command->add_option("--sensor", options->sensor, "The LiDAR [hdl-64e]")
      ->check(CLI::IsMember(simulation::sensor_names()));
  command
      ->add_option("--sensor-height-m", options->height_m,
                   "Its height over the ground instead of its usual one")
      ->check(CLI::Range(0.2, 5.0));
  command->add_option("--scans", options->drive.scans, "How many [200]")
      ->check(CLI::Range(1, 100000));
  command->add_option("--seed", options->drive.seed, "Of the world and all noise [1]");
  command->add_option("--sequence", options->sequence, "Name of the sequence [00]");
  command
      ->add_option("--threads", options->drive.threads,
                   "0: one for each core; changes no bit of the result [0]")
      ->check(CLI::Range(0, 1024));
  add_errors(*command, options->drive);
  command->callback([options] { simulate(*options); });
}

}  // namespace groundgrid::program
