#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/scan_format.hpp"

namespace groundgrid::io {

/// One scan on disk.
struct ScanFile {
  std::string name;  ///< The file's name without the ending of its format: "000042".
  /// Which line of poses.txt is its: 42. In a plain sequence the number that is its name, where
  /// that of every scan is one, else `index`.
  std::size_t number = 0;
  std::filesystem::path path;
  ScanFormat format{};
  std::size_t index = 0;  ///< Its place in the sequence, from 0.
  /// The layout of a .bin file was found by its numbers, or those of a scan before it: nobody said.
  bool layout_is_guessed = false;

  /// Its numbers told another layout than the ending of its name does.
  [[nodiscard]] bool has_unusual_layout() const {
    return layout_is_guessed && format != format_by_name(path);
  }
};

/// Scans that belong together, in the order in which they were taken: that of their numbers, else
/// of their names, and in a list that of its lines.
struct ScanSequence {
  std::string name;               ///< "00"; empty for plain scans outside a dataset.
  std::filesystem::path folder;   ///< The one that holds velodyne (or velodyne_points), the plain
                                  ///< scans or the list.
  std::vector<ScanFile> scans{};  ///< Never empty.
  std::filesystem::path kitti_360{};  ///< The folder of a KITTI-360 dataset; empty for others.

  /// Files, a folder or a list of files without the layout of a dataset, hence without poses and
  /// labels of their own.
  [[nodiscard]] bool plain() const { return name.empty(); }
  [[nodiscard]] bool is_kitti_360() const { return !kitti_360.empty(); }
  [[nodiscard]] std::filesystem::path poses() const {
    return (is_kitti_360() ? kitti_360 / "data_poses" / name : folder) / "poses.txt";
  }
  /// A folder in KITTI-360.
  [[nodiscard]] std::filesystem::path calibration() const {
    return is_kitti_360() ? kitti_360 / "calibration" : folder / "calib.txt";
  }
  [[nodiscard]] std::filesystem::path times() const { return folder / "times.txt"; }
  [[nodiscard]] std::filesystem::path labels() const { return folder / "labels"; }
  /// Of simulated drives only.
  [[nodiscard]] std::filesystem::path true_heights() const { return folder / "truth" / "height"; }
};

/// Finds the scans below `input`, which may be
///  - a dataset in KITTI odometry or SemanticKITTI layout (sequences/NN/velodyne/NNNNNN.bin, or
///    scans of another format there), its folder `sequences`, or one sequence's folder;
///  - a dataset in the layout of KITTI-360 (data_3d_raw/NAME/velodyne_points/data/NNNNNNNNNN.bin,
///    poses in data_poses/NAME/poses.txt), one sequence's folder of it, or KITTI's raw data;
///  - a folder of scans, or one scan;
///  - a list: a text file (.txt or .lst) with the path of one scan a line, relative to the folder
///    of the list. Blank lines and those that begin with '#' do not count. A file of that ending
///    is always a list: `format` is then that of the scans in it.
/// With `names`, only those sequences, in that order ("0" finds "00"). The format of each scan is
/// that of its name; with `format` it is that one, for every file with the ending of any format and
/// for one that is given by its name, whatever its ending. Without it, the first .bin file whose
/// numbers tell their layout (likely_layouts()) says that of all files of its ending. An entry of a
/// folder counts by its name alone: reading it says where it is no file. Throws Error where there
/// is nothing, a folder cannot be read, a sequence of that name is missing, `input` itself or a
/// path in a list is that of no regular file, a scan of a dataset has no number, or two scans have
/// the same name or, in a dataset, number.
std::vector<ScanSequence> find_sequences(const std::filesystem::path& input,
                                         std::span<const std::string> names = {},
                                         std::optional<ScanFormat> format = {});

}  // namespace groundgrid::io
