#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "io/pose_file.hpp"
#include "io/scan_sequence.hpp"

namespace groundgrid::io {

/// The pose of the LiDAR at each scan of a sequence.
class ScanPoses {
 public:
  /// poses.txt and calib.txt of a KITTI sequence. The file holds the camera's poses P, one a line;
  /// the LiDAR's is Tr⁻¹·P·Tr, in the frame of the LiDAR at scan 0. The line with index k (from 0)
  /// belongs to the scan with the number k, whether or not all scans are on disk. Throws Error
  /// where a file cannot be read or a line is no rigid transform.
  static ScanPoses kitti(const std::filesystem::path& poses,
                         const std::filesystem::path& calibration);

  /// The poses of a dataset's sequence: as kitti() has them, or as a KITTI-360 dataset has, in a
  /// map whose z is up, with the mounting of the LiDAR in `calibration`; if there is no such
  /// folder, its poses are taken for the LiDAR's own.
  static ScanPoses of_dataset(const ScanSequence& sequence);

  /// A file of the LiDAR's own poses in the map frame, in any form of read_pose_file(). With a
  /// `calibration` file the poses are the camera's, as in kitti(); with a folder they are those of
  /// KITTI-360, as in of_dataset().
  ///
  /// Poses with times are interpolated at a scan's time if the sequence has times.txt: on a
  /// straight line, and about one axis; up to 0.1 s before the first and after the last it is that
  /// one. Poses with numbers belong to the scans of these. Otherwise a line belongs to the scan of
  /// its number if every number has a line, else to the scan of its place in order if there are as
  /// many lines as scans. Throws Error if a file cannot be read, a line is no pose, or the lines
  /// cannot be matched.
  static ScanPoses from_file(const std::filesystem::path& poses, const ScanSequence& sequence,
                             const std::optional<std::filesystem::path>& calibration = {});

  /// Poses that the file holds.
  [[nodiscard]] std::size_t size() const;

  /// The pose in the first line; the identity where there is none.
  [[nodiscard]] Eigen::Isometry3d first() const;

  /// Whether the file numbers its poses, and has none for this scan: in KITTI-360 scans while the
  /// car stands, for one, have none.
  [[nodiscard]] bool leaves_out(const ScanFile& scan) const;

  /// T_map_lidar at a scan of the sequence. Throws Error, with the file and the line that is
  /// missing, where there is none.
  [[nodiscard]] Eigen::Isometry3d pose(const ScanFile& scan) const;

 private:
  /// Which of so many lines belongs to a scan.
  enum class Line { of_its_number, of_its_place };

  ScanPoses(std::filesystem::path path, PoseList list);

  static Line matching_line(const std::filesystem::path& path, std::size_t lines,
                            const ScanSequence& sequence);
  static std::size_t index_of(const ScanFile& scan, Line line);

  void require_a_pose(const ScanSequence& sequence) const;
  void turn_into_lidar_poses(const std::filesystem::path& calibration);
  [[nodiscard]] Eigen::Isometry3d pose_at_scan_time(const ScanFile& scan) const;

  std::filesystem::path path_;
  PoseList list_;
  Line line_ = Line::of_its_number;  ///< Of the poses, or of the times where there are some.
  std::filesystem::path times_path_{};
  std::vector<double> scan_times_{};  ///< Empty where a scan has a pose of its own.
};

}  // namespace groundgrid::io
