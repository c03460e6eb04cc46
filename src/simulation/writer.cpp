#include "simulation/writer.hpp"

#include <fmt/format.h>

#include <span>
#include <string>
#include <utility>

#include "geotiff/height_file.hpp"
#include "io/output_folder.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "simulation/truth_rasters.hpp"

namespace groundgrid::simulation {
namespace {

namespace fs = std::filesystem;

// As in KITTI's car: the camera's z looks forward and its x to the right.
Eigen::Isometry3d T_camera_lidar() {
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() << 0.0, -1.0, 0.0, 0.0, 0.0, -1.0, 1.0, 0.0, 0.0;
  transform.translation() << 0.0, -0.08, -0.27;
  return transform;
}

std::string numbers_of(const Eigen::Isometry3d& transform) {
  std::string text;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      text += fmt::format("{}{:.9e}", text.empty() ? "" : " ", transform(row, column));
  return text + "\n";
}

void write_floats(const fs::path& path, std::span<const float> numbers, io::FileBatch& batch) {
  io::AtomicFile file(path);
  file.write(std::as_bytes(numbers));
  batch.add(std::move(file));
}

fs::path points_file(const fs::path& folder, std::size_t scan) {
  return folder / "velodyne" / fmt::format("{:06}.bin", scan);
}
fs::path labels_file(const fs::path& folder, std::size_t scan) {
  return folder / "labels" / fmt::format("{:06}.label", scan);
}
fs::path heights_file(const fs::path& folder, std::size_t scan) {
  return folder / "truth" / "height" / fmt::format("{:06}.f32", scan);
}

}  // namespace

std::vector<fs::path> files_of_drive(const fs::path& folder, std::size_t scans) {
  const fs::path truth = folder / "truth";
  std::vector<fs::path> files{folder / "calib.txt", folder / "poses.txt",
                              folder / "times.txt", truth / "terrain.tif",
                              truth / "kerbs.tif",  truth / "vegetation.tif"};
  for (std::size_t scan = 0; scan < scans; ++scan)
    for (const auto& file : {points_file, labels_file, heights_file})
      files.push_back(file(folder, scan));
  return files;
}

SequenceWriter::SequenceWriter(fs::path folder) : folder_(std::move(folder)) {
  for (const char* const name : {"velodyne", "labels", "truth", "truth/height"}) {
    io::make_folder(folder_ / name);
    io::remove_leftovers(folder_ / name);
  }
  io::write_text(folder_ / "calib.txt", "Tr: " + numbers_of(T_camera_lidar()));
}

void SequenceWriter::add(const Scan& scan, double time_s, const Eigen::Isometry3d& T_world_sensor) {
  const std::size_t number = true_poses_.size();
  if (true_poses_.empty()) first_place_ = scan.T_world_sensor.translation();
  const Eigen::Translation3d T_map_world(-first_place_);
  true_poses_.push_back(T_map_world * scan.T_world_sensor);
  const Eigen::Isometry3d T_map_sensor = T_map_world * T_world_sensor;
  poses_ += numbers_of(T_camera_lidar() * T_map_sensor * T_camera_lidar().inverse());
  times_ += fmt::format("{:.6e}\n", time_s);
  write_floats(points_file(folder_, number), scan.points, scans_written_);
  io::write_labels(labels_file(folder_, number), scan.labels, &scans_written_);
  write_floats(heights_file(folder_, number), scan.heights, scans_written_);
}

void SequenceWriter::finish(const World& world, TileRunner& runner) {
  scans_written_.commit();
  io::write_text(folder_ / "poses.txt", poses_);
  io::write_text(folder_ / "times.txt", times_);
  const geotiff::RasterGrid grid = grid_around(true_poses_);
  const TruthRasters rasters(world, grid, first_place_, runner);
  const fs::path truth = folder_ / "truth";
  geotiff::write_heights(truth / "terrain.tif", grid, rasters.heights());
  geotiff::write_heights(truth / "vegetation.tif", grid, rasters.under_leaves());
  geotiff::write_heights(truth / "kerbs.tif", grid, rasters.at_kerbs());
}

}  // namespace groundgrid::simulation
