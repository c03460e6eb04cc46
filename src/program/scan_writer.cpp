#include "program/scan_writer.hpp"

#include <fmt/format.h>

#include <system_error>

#include "io/labelled_cloud.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "program/output_folder.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;

}  // namespace

CloudOutput cloud_output_named(const std::string& name) {
  if (name == "same") return CloudOutput::same;
  if (name == "pcd") return CloudOutput::pcd;
  if (name == "ply") return CloudOutput::ply;
  return CloudOutput::none;
}

ScanWriter::ScanWriter(const fs::path& output, const io::ScanSequence& sequence, CloudOutput clouds)
    : sequence_(&sequence),
      label_folder_(sequence.plain() ? output
                                     : output / "sequences" / sequence.name / "predictions"),
      cloud_folder_(sequence.plain() ? output : output / "sequences" / sequence.name / "clouds"),
      clouds_(clouds) {}

void ScanWriter::make_folders() const {
  make_folder(label_folder_);
  if (writes_clouds()) make_folder(cloud_folder_);
}

fs::path ScanWriter::label_path(const io::ScanFile& scan) const {
  return label_folder_ / (scan.name + ".label");
}

io::ScanFormat ScanWriter::cloud_format(const io::ScanFile& scan) const {
  if (clouds_ == CloudOutput::same) return scan.format;
  return clouds_ == CloudOutput::pcd ? io::ScanFormat::pcd : io::ScanFormat::ply;
}

fs::path ScanWriter::cloud_path(const io::ScanFile& scan) const {
  return cloud_folder_ / fmt::format("{}.{}", scan.name, io::name_of(cloud_format(scan)));
}

void ScanWriter::check(const InputFiles& inputs) const {
  for (const io::ScanFile& scan : sequence_->scans) {
    inputs.keep(label_path(scan));
    if (!writes_clouds()) continue;
    const io::ScanFormat format = cloud_format(scan);
    if (format != io::ScanFormat::pcd && format != io::ScanFormat::ply)
      throw UsageError(
          fmt::format("{}: its format has no place for labels; use --clouds pcd or --clouds ply",
                      scan.path.string()));
    inputs.keep(cloud_path(scan));
  }
}

void ScanWriter::write(const io::ScanFile& scan, const ScanSlot& slot) {
  io::write_labels(label_path(scan), slot.labels, &written_);
  if (!writes_clouds()) return;
  io::write_labelled_cloud(cloud_path(scan), cloud_format(scan), slot.cloud, slot.labels,
                           slot.height_above_ground, &written_);
}

}  // namespace groundgrid::program
