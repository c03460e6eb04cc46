#include "simulation/simulation.hpp"

#include <stdexcept>

#include "simulation/writer.hpp"

namespace groundgrid::simulation {

void simulate_drive(const DriveOptions& options, const std::vector<std::filesystem::path>& folders,
                    const ScanListener& listener) {
  if (folders.size() != options.sensors.size())
    throw std::invalid_argument("a drive needs a folder for each of its sensors");
  SimulatedDrive drive(options);
  for (std::size_t sensor = 0; sensor < folders.size(); ++sensor) {
    Scanner scanner = drive.scanner(sensor);
    PoseErrors errors = drive.pose_errors(sensor);
    SequenceWriter writer(folders[sensor]);
    for (std::size_t i = 0; i < scans_of(options, sensor); ++i) {
      const Scan scan = scanner.scan(i);
      writer.add(scan, drive.time_s(sensor, i), errors.estimate(scan.T_world_sensor));
      listener(sensor, scan.labels.size());
    }
    writer.finish(drive.world(), drive.runner());
  }
}

}  // namespace groundgrid::simulation
