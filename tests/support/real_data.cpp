#include "support/real_data.hpp"

#include <cstdlib>

#include "io/scan_poses.hpp"
#include "io/scan_sequence.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "support/kitti_points.hpp"

namespace groundgrid::testing {
namespace {

namespace fs = std::filesystem;

fs::path data_folder() {
  // Nothing sets the environment while tests run.
  const char* folder = std::getenv("GROUNDGRID_DATA");  // NOLINT(concurrency-mt-unsafe)
  return folder != nullptr && *folder != '\0' ? folder : GROUNDGRID_DEFAULT_DATA;
}

}  // namespace

std::optional<fs::path> semantic_kitti() {
  const fs::path data = data_folder();
  for (const fs::path& dataset : {data / "semantickitti", data})
    if (fs::is_directory(dataset / "sequences")) return dataset;
  return std::nullopt;
}

bool data_is_required() {
  return std::getenv("GROUNDGRID_REQUIRE_DATA") != nullptr;  // NOLINT(concurrency-mt-unsafe)
}

std::vector<RealScan> read_scans(const fs::path& dataset, const std::string& sequence_name,
                                 std::size_t limit) {
  const std::vector<std::string> names{sequence_name};
  const io::ScanSequence sequence = io::find_sequences(dataset, names).front();
  const io::ScanPoses poses = io::ScanPoses::kitti(sequence.poses(), sequence.calibration());
  std::vector<RealScan> scans;
  for (const io::ScanFile& file : sequence.scans) {
    if (scans.size() == limit) break;
    RealScan& scan = scans.emplace_back();
    scan.points = kitti_points(file.path);
    io::read_labels(sequence.labels() / (file.name + ".label"), file.path, scan.size(),
                    scan.labels);
    scan.T_map_lidar = poses.pose(file);
  }
  return scans;
}

std::vector<std::vector<float>> read_other_sensor(const fs::path& dataset, const std::string& name,
                                                  std::size_t limit) {
  std::vector<std::vector<float>> scans;
  const fs::path set = dataset.parent_path() / "other_sensors" / name;
  if (!fs::is_directory(set)) return scans;
  const std::vector<io::ScanSequence> sequences = io::find_sequences(set, {});
  for (const io::ScanFile& file : sequences.front().scans)
    if (scans.size() < limit) scans.push_back(kitti_points(file.path));
  return scans;
}

}  // namespace groundgrid::testing
