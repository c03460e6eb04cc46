#include "program/scan_truth.hpp"

#include "io/error.hpp"
#include "io/path_checks.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "program/label_file.hpp"

namespace groundgrid::program {

std::filesystem::path truth_file(const io::ScanSequence& sequence, const io::ScanFile& scan,
                                 const std::filesystem::path& given) {
  if (!given.empty() || sequence.plain()) return given;
  return label_file(sequence.labels(), scan);
}

void read_truth(const std::filesystem::path& file, const io::ScanFile& scan, std::size_t points,
                std::vector<std::uint32_t>& truth) {
  if (file.empty() || !io::is_there(file))
    throw io::Error({.file = file.empty() ? scan.path : file,
                     .expected = "the true labels of the scan, for --errors",
                     .got = "none",
                     .remedy = "leave --errors out or, for a picture of one scan, name them by "
                               "--truth"});
  io::read_labels(file, scan.path, points, truth);
}

}  // namespace groundgrid::program
