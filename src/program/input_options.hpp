#pragma once

#include <CLI/App.hpp>
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/scan_poses.hpp"
#include "io/scan_sequence.hpp"
#include "program/input_files.hpp"

namespace groundgrid::program {

/// The flags that say which scans are taken, in what format, with which poses and mounting.
class InputOptions {
 public:
  /// Adds the positional argument and the flags. The object must stay where it is until parsing is
  /// over.
  void add_to(CLI::App& command, const std::string& name, const std::string& description);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Empty where the sequences' own are used.
  [[nodiscard]] const std::filesystem::path& pose_file() const { return poses_; }
  /// The files that are named: those of poses, and what is given as input where that is a file.
  void add_files(InputFiles& inputs) const;
  [[nodiscard]] bool names_sequences() const { return !sequences_.empty(); }

  /// The sequences asked for. Throws io::Error where there are none, UsageError where flags do not
  /// go together.
  [[nodiscard]] std::vector<io::ScanSequence> find_sequences() const;

  /// Whether the scans of the sequence are to be taken as single ones: as asked for, or because
  /// there are no poses.
  [[nodiscard]] bool without_poses(const io::ScanSequence& sequence, bool single_scan) const {
    return single_scan || (sequence.plain() && poses_.empty());
  }

  /// The poses of a sequence; nothing for single scans. Throws io::Error where they cannot be read.
  [[nodiscard]] std::optional<io::ScanPoses> read_poses(const io::ScanSequence& sequence,
                                                        bool single_scan) const;

  /// The same, throwing io::Error also if a scan of the sequence has no pose, unless the
  /// poses are numbered and leave it out.
  [[nodiscard]] std::optional<io::ScanPoses> read_every_pose(const io::ScanSequence& sequence,
                                                             bool single_scan) const;

  /// Makes each flag that says something about poses or mounting an error together with `other`.
  void exclude_poses(CLI::Option* other);

  /// Turns the LiDAR's axes into those of a level LiDAR that looks ahead.
  [[nodiscard]] Eigen::Matrix3d R_level_lidar() const;

 private:
  std::filesystem::path path_;
  std::vector<std::string> sequences_;
  std::string format_;
  std::filesystem::path poses_;
  std::filesystem::path calibration_;
  std::vector<double> roll_pitch_yaw_deg_;
  std::vector<CLI::Option*> pose_options_;
};

}  // namespace groundgrid::program
