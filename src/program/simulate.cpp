#include "program/simulate.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "io/atomic_file.hpp"
#include "program/input_files.hpp"
#include "program/interrupt.hpp"
#include "program/json_text.hpp"
#include "program/output_folder.hpp"
#include "program/progress_bar.hpp"
#include "program/usage_error.hpp"
#include "program/version.hpp"
#include "simulation/scene.hpp"
#include "simulation/sensor_file.hpp"
#include "simulation/simulation.hpp"
#include "simulation/version.hpp"
#include "simulation/writer.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using simulation::Motion;

struct SimulateOptions {
  fs::path output;
  std::string sequence = "00";
  std::vector<std::string> sensors{"hdl-64e"};
  double height_m = 0.0;
  simulation::DriveOptions drive;
};

std::string sequence_name(const SimulateOptions& options, std::size_t sensor) {
  return options.sensors.size() == 1 ? options.sequence : fmt::format("{:02}", sensor);
}

fs::path sequence_folder(const SimulateOptions& options, std::size_t sensor) {
  return options.output / "sequences" / sequence_name(options, sensor);
}

fs::path record_file(const SimulateOptions& options, std::size_t sensor) {
  return sequence_folder(options, sensor) / "truth" / "drive.json";
}

simulation::Sensor find_sensor(const std::string& name) {
  const std::vector<std::string> names = simulation::sensor_names();
  if (std::find(names.begin(), names.end(), name) != names.end())
    return simulation::make_sensor(name);
  if (fs::path(name).extension() == ".toml") return simulation::read_sensor(name);
  throw UsageError(fmt::format("--sensor: expected {} or a file that ends with .toml, got '{}'",
                               fmt::join(names, ", "), name));
}

void find_sensors(SimulateOptions& options, bool named) {
  if (options.sensors.size() > 1 && named)
    throw UsageError("--sequence is for one sensor; several become the sequences 00, 01, ...");
  for (const std::string& name : options.sensors) {
    options.drive.sensors.push_back(find_sensor(name));
    if (options.height_m > 0.0) options.drive.sensors.back().mount.height_m = options.height_m;
  }
}

std::array<std::array<double, 4>, 4> rows_of(const Eigen::Isometry3d& transform) {
  std::array<std::array<double, 4>, 4> rows{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      rows[row][column] =
          transform(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
  return rows;
}

// Written last, it marks a whole drive.
void write_record(const SimulateOptions& options, std::size_t index, std::size_t points) {
  const simulation::Sensor& sensor = options.drive.sensors[index];
  const nlohmann::ordered_json json{
      {"program", "groundgrid"},
      {"version", version()},
      {"command", "simulate"},
      {"simulated", true},
      {"simulation_version", simulation::kSimulationVersion},
      {"scene", options.drive.scene},
      {"sensor", sensor.name},
      {"sensor_height_m", sensor.mount.height_m},
      {"T_base_sensor", rows_of(sensor.T_base_sensor())},
      {"scans", simulation::scans_of(options.drive, index)},
      {"seed", options.drive.seed},
      {"motion", options.drive.motion == Motion::corrected ? "corrected" : "distorted"},
      {"pose_noise_m", options.drive.pose_noise_m},
      {"pose_drift_m", options.drive.pose_drift_m},
      {"points", points}};
  io::write_text(record_file(options, index), to_text(json));
}

// A file for --sensor may lie anywhere, and have other names too.
void check_outputs(const SimulateOptions& options) {
  InputFiles inputs;
  for (const std::string& name : options.sensors) inputs.add(name);
  for (std::size_t i = 0; i < options.sensors.size(); ++i) {
    inputs.keep(record_file(options, i));
    for (const fs::path& file : simulation::files_of_drive(sequence_folder(options, i),
                                                           simulation::scans_of(options.drive, i)))
      inputs.keep(file);
  }
}

void simulate(const SimulateOptions& options) {
  check_outputs(options);
  std::vector<fs::path> folders;
  std::list<OutputFolder> locked_folders;
  std::size_t scans = 0;
  for (std::size_t i = 0; i < options.sensors.size(); ++i) {
    folders.push_back(sequence_folder(options, i));
    locked_folders.emplace_back(folders.back());
    // That of an earlier drive must not vouch for the files of one that fails.
    remove_file(record_file(options, i));
    scans += simulation::scans_of(options.drive, i);
  }
  ProgressBar progress(scans);
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::size_t> points(folders.size());
  simulation::simulate_drive(options.drive, folders, [&](std::size_t sensor, std::size_t in_scan) {
    check_interrupt();
    points[sensor] += in_scan;
    progress.advance();
  });
  for (std::size_t i = 0; i < folders.size(); ++i) write_record(options, i, points[i]);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  spdlog::info("{} scans with {} points on average in {:.1f} s are in {}", scans,
               std::accumulate(points.begin(), points.end(), std::size_t{0}) / scans,
               seconds.count(), (options.output / "sequences").string());
}

void add_errors(CLI::App& command, simulation::DriveOptions& drive) {
  CLI::Validator motions = CLI::CheckedTransformer(std::map<std::string, Motion>{
      {"corrected", Motion::corrected}, {"distorted", Motion::distorted}});
  // Its own would show the numbers behind the names.
  motions.description("{corrected,distorted}");
  command
      .add_option("--motion", drive.motion,
                  "corrected: all points in the frame of the scan's middle; distorted: as the "
                  "moving sensor saw them [corrected]")
      ->transform(motions)
      ->type_name("TEXT");
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
  command->add_option("--sensor", options->sensors,
                      fmt::format("The LiDAR: {}, or a .toml file; once for each on the vehicle "
                                  "[hdl-64e]",
                                  fmt::join(simulation::sensor_names(), ", ")));
  command
      ->add_option("--sensor-height-m", options->height_m,
                   "Height over the ground instead of the sensor's usual one")
      ->check(CLI::Range(0.2, 5.0));
  command->add_option("--scans", options->drive.scans, "How many [200]")
      ->check(CLI::Range(1, 100000));
  command->add_option("--seed", options->drive.seed, "Of the world and all noise [1]");
  const CLI::Option* const sequence =
      command->add_option("--sequence", options->sequence, "Name of the sequence [00]");
  command
      ->add_option("--threads", options->drive.threads,
                   "0: one for each core; changes no bit of the result [0]")
      ->check(CLI::Range(0, 1024));
  add_errors(*command, options->drive);
  command->callback([options, sequence] {
    find_sensors(*options, sequence->count() > 0);
    simulate(*options);
  });
}

}  // namespace groundgrid::program
