#include "program/input_options.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/Validators.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "io/error.hpp"
#include "io/path_checks.hpp"
#include "io/scan_format.hpp"
#include "program/pose_frames.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// As CLI11 asks for it: empty if there is none.
std::string format_problem(const std::string& name) {
  return io::scan_format_named(name) ? ""
                                     : fmt::format("expected {}, got {}", io::kFormatNames, name);
}

// A layout that is not what the ending of the name promises is not used without a word.
void say_guessed_layouts(const io::ScanSequence& sequence) {
  std::set<std::string> said;
  for (const io::ScanFile& scan : sequence.scans)
    if (scan.has_unusual_layout() && said.insert(io::name_of(scan.format)).second)
      spdlog::info("{}: read as {} ({}), as its numbers tell; --format says otherwise",
                   scan.path.string(), io::name_of(scan.format), scan.format.layout.words());
}

}  // namespace

void InputOptions::add_to(CLI::App& command, const std::string& name,
                          const std::string& description) {
  command.add_option(name, path_, description)->required();
  command.add_option("--sequence", sequences_, "Only these sequences of a dataset");
  command
      .add_option("--format", format_,
                  fmt::format("Take every scan as {}, whatever its name says", io::kFormatNames))
      ->check(CLI::Validator(format_problem, "FORMAT"));
  CLI::Option* const poses =
      command.add_option("--poses", poses_,
                         "Poses of the LiDAR, in the form of KITTI (12 or 16 numbers a line), "
                         "KITTI-360 (the scan's number first), TUM (time, position, quaternion) or "
                         "ASL (CSV), z up, instead of the sequence's poses.txt");
  CLI::Option* const calibration =
      command
          .add_option("--calibration", calibration_,
                      "calib.txt whose Tr makes LiDAR poses of the camera poses in --poses, or "
                      "KITTI-360's folder calibration")
          ->needs(poses);
  CLI::Option* const mounting =
      command
          .add_option(
              "--lidar-rpy-deg", roll_pitch_yaw_deg_,
              "Roll, pitch and yaw of the LiDAR on the vehicle, degrees (180,0,0: upside down)")
          ->expected(3)
          ->delimiter(',')
          ->type_name("R,P,Y");
  pose_options_ = {poses, calibration, mounting};
}

void InputOptions::exclude_poses(CLI::Option* other) {
  for (CLI::Option* option : pose_options_) other->excludes(option);
}

void InputOptions::add_files(InputFiles& inputs) const {
  for (const fs::path& file : {path_, poses_, calibration_}) inputs.add(file);
}

std::vector<io::ScanSequence> InputOptions::find_sequences() const {
  for (const double angle : roll_pitch_yaw_deg_)
    if (!std::isfinite(angle)) throw UsageError("--lidar-rpy-deg: expected three finite angles");
  auto sequences = io::find_sequences(
      path_, sequences_,
      format_.empty() ? std::optional<io::ScanFormat>{} : io::scan_format_named(format_));
  if (!poses_.empty() && sequences.size() > 1)
    throw UsageError("--poses is for one sequence; choose it with --sequence");
  for (const io::ScanSequence& sequence : sequences) say_guessed_layouts(sequence);
  return sequences;
}

std::optional<io::ScanPoses> InputOptions::read_poses(const io::ScanSequence& sequence,
                                                      bool single_scan) const {
  if (single_scan && !poses_.empty())
    throw UsageError("--single-scan uses no poses: leave out one of it and --poses");
  if (without_poses(sequence, single_scan)) return std::nullopt;
  if (!poses_.empty()) {
    io::ScanPoses poses = io::ScanPoses::from_file(
        poses_, sequence, calibration_.empty() ? std::optional<fs::path>{} : calibration_);
    warn_of_climb(poses, sequence);
    return poses;
  }
  if (!io::is_there(sequence.poses()))
    throw io::Error({.file = sequence.poses(),
                     .expected = "the poses of the sequence",
                     .got = "nothing of that name",
                     .remedy = "use --single-scan to do without poses, or --poses for others"});
  if (sequence.is_kitti_360() && !io::is_there(sequence.calibration()))
    spdlog::warn("{}: nothing of that name, so the poses are taken for the LiDAR's own",
                 sequence.calibration().string());
  return io::ScanPoses::of_dataset(sequence);
}

std::optional<io::ScanPoses> InputOptions::read_every_pose(const io::ScanSequence& sequence,
                                                           bool single_scan) const {
  std::optional<io::ScanPoses> poses = read_poses(sequence, single_scan);
  if (!poses) return poses;
  for (const io::ScanFile& scan : sequence.scans)
    if (!poses->leaves_out(scan)) (void)poses->pose(scan);
  return poses;
}

Eigen::Matrix3d InputOptions::R_level_lidar() const {
  if (roll_pitch_yaw_deg_.empty()) return Eigen::Matrix3d::Identity();
  const auto turn = [this](std::size_t i, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(roll_pitch_yaw_deg_[i] * kRadiansPerDegree, axis);
  };
  return (turn(2, Eigen::Vector3d::UnitZ()) * turn(1, Eigen::Vector3d::UnitY()) *
          turn(0, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace groundgrid::program
