#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/atomic_file.hpp"
#include "io/scan_format.hpp"
#include "io/scan_sequence.hpp"
#include "program/input_files.hpp"
#include "program/scan_slot.hpp"

namespace groundgrid::program {

/// Which point clouds `segment` writes besides the labels.
enum class CloudOutput : std::uint8_t { none, same, pcd, ply };

/// "none", "same", "pcd", "ply", as --clouds takes them.
CloudOutput cloud_output_named(const std::string& name);

/// Where the answers of one sequence go: a .label file a scan and, where wished, a cloud with all
/// fields of the input, the labels and the heights.
class ScanWriter {
 public:
  /// `output` is the folder of the whole run.
  ScanWriter(const std::filesystem::path& output, const io::ScanSequence& sequence,
             CloudOutput clouds);

  /// Throws UsageError where a scan has no cloud format to be written in again, or what is written
  /// would replace one of the inputs.
  void check(const InputFiles& inputs) const;

  /// Whether heights above the ground are written, too.
  [[nodiscard]] bool writes_clouds() const { return clouds_ != CloudOutput::none; }

  /// Makes the folders. Throws io::Error.
  void make_folders() const;

  /// Writes the files of one scan, each complete or not at all. They have their names some scans
  /// later, or once finish() is called. Throws io::Error.
  void write(const io::ScanFile& scan, const ScanSlot& slot);

  /// Gives all that is written its name. Throws io::Error.
  void finish() { written_.commit(); }

 private:
  [[nodiscard]] io::ScanFormat cloud_format(const io::ScanFile& scan) const;
  [[nodiscard]] std::filesystem::path cloud_path(const io::ScanFile& scan) const;
  [[nodiscard]] std::filesystem::path label_path(const io::ScanFile& scan) const;

  const io::ScanSequence* sequence_;
  std::filesystem::path label_folder_;
  std::filesystem::path cloud_folder_;
  CloudOutput clouds_;
  io::FileBatch written_;
};

}  // namespace groundgrid::program
