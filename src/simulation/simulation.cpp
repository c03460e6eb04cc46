#include "simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/parallel.hpp"
#include "simulation/drive.hpp"
#include "simulation/echo.hpp"
#include "simulation/scene.hpp"
#include "simulation/terrain.hpp"
#include "simulation/writer.hpp"

namespace groundgrid::simulation {
namespace {

/// What a localisation makes of the true poses.
class PoseErrors {
 public:
  PoseErrors(DriveOptions options, double metres_per_scan)
      : options_(std::move(options)), metres_per_scan_(metres_per_scan) {}

  Eigen::Isometry3d estimate(const Eigen::Isometry3d& truth, std::size_t scan) {
    if (scan == 0) return truth;
    Random random(hash({options_.seed, 4, scan}));
    drift_ += options_.pose_drift_m * metres_per_scan_ * normal_vector(random);
    return Eigen::Translation3d(drift_ + options_.pose_noise_m * normal_vector(random)) * truth;
  }

 private:
  static Eigen::Vector3d normal_vector(Random& random) {
    const double x = random.normal();
    const double y = random.normal();
    return {x, y, random.normal()};
  }

  DriveOptions options_;
  double metres_per_scan_;
  Eigen::Vector3d drift_ = Eigen::Vector3d::Zero();
};

/// Sensors of one drive have noise of their own.
std::uint64_t noise_seed(std::uint64_t seed, std::size_t sensor) {
  return sensor == 0 ? seed : hash({seed, 5, sensor});
}

}  // namespace

std::size_t scans_of(const DriveOptions& options, std::size_t sensor) {
  const double share = options.sensors[sensor].rate_hz / options.sensors.front().rate_hz;
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lround(static_cast<double>(options.scans) * share)));
}

void simulate_drive(const DriveOptions& options, const std::vector<std::filesystem::path>& folders,
                    const ScanListener& listener) {
  if (options.sensors.empty() || folders.size() != options.sensors.size())
    throw std::invalid_argument("a drive needs sensors, and a folder for each");
  const double speed = scene_speed_mps(options.scene);
  const double length =
      static_cast<double>(options.scans) * speed / options.sensors.front().rate_hz;
  const Scene scene = make_scene(options.scene, options.seed, length);
  TileRunner runner(options.threads);
  const Terrain terrain(*scene.path, length, scene.ground, runner);
  const Drive drive(scene, terrain, options.seed);
  World world(scene, terrain);
  for (std::size_t sensor = 0; sensor < folders.size(); ++sensor) {
    const double rate_hz = options.sensors[sensor].rate_hz;
    Scanner scanner(world, drive, options.sensors[sensor], options.motion,
                    noise_seed(options.seed, sensor), runner);
    PoseErrors errors(options, speed / rate_hz);
    SequenceWriter writer(folders[sensor]);
    for (std::size_t i = 0; i < scans_of(options, sensor); ++i) {
      const Scan scan = scanner.scan(i);
      writer.add(scan, static_cast<double>(i) / rate_hz, errors.estimate(scan.T_world_sensor, i));
      listener(sensor, scan.labels.size());
    }
    writer.finish(world, runner);
  }
}

}  // namespace groundgrid::simulation
