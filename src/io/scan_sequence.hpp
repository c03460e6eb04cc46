#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace groundgrid::io {

/// One scan on disk.
struct ScanFile {
  std::string name;        ///< The file's name without its extension: "000042".
  std::size_t number = 0;  ///< 42: which line of poses.txt is its. 0 in a plain folder.
  std::filesystem::path path;
};

/// Scans that belong together, in the order of their numbers.
struct ScanSequence {
  std::string name;               ///< "00"; empty for plain .bin files outside a dataset.
  std::filesystem::path folder;   ///< The one that holds velodyne, or the plain files.
  std::vector<ScanFile> scans{};  ///< Never empty.

  /// Files or a folder of files without the layout of a dataset, hence without poses and labels.
  [[nodiscard]] bool plain() const { return name.empty(); }
  [[nodiscard]] std::filesystem::path poses() const { return folder / "poses.txt"; }
  [[nodiscard]] std::filesystem::path calibration() const { return folder / "calib.txt"; }
  [[nodiscard]] std::filesystem::path labels() const { return folder / "labels"; }
};

/// Finds the scans below `input`, which may be
///  - a dataset in KITTI odometry or SemanticKITTI layout (sequences/NN/velodyne/NNNNNN.bin),
///    its folder `sequences`, or one sequence's folder;
///  - a folder of .bin files, or one .bin file.
/// With `names`, only those sequences, in that order ("0" finds "00"). Throws Error where there is
/// nothing, a sequence of that name is missing, or a scan of a dataset has no number.
std::vector<ScanSequence> find_sequences(const std::filesystem::path& input,
                                         std::span<const std::string> names = {});

}  // namespace groundgrid::io
