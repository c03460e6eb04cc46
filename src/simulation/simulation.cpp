#include "simulation/simulation.hpp"

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
  PoseErrors(const DriveOptions& options, double metres_per_scan)
      : options_(options), metres_per_scan_(metres_per_scan) {}

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

}  // namespace

void simulate_drive(const DriveOptions& options, const std::filesystem::path& folder,
                    const ScanListener& listener) {
  const double metres_per_scan = scene_speed_mps(options.scene) / options.sensor.rate_hz;
  const double length = static_cast<double>(options.scans) * metres_per_scan;
  const Scene scene = make_scene(options.scene, options.seed, length);
  TileRunner runner(options.threads);
  const Terrain terrain(*scene.path, length, scene.ground, runner);
  const Drive drive(scene, terrain, options.seed);
  World world(scene, terrain);
  Scanner scanner(world, drive, options.sensor, options.motion, options.seed, runner);
  PoseErrors errors(options, metres_per_scan);
  SequenceWriter writer(folder);
  for (std::size_t i = 0; i < options.scans; ++i) {
    const Scan scan = scanner.scan(i);
    writer.add(scan, static_cast<double>(i) / options.sensor.rate_hz,
               errors.estimate(scan.T_world_sensor, i));
    listener(scan.labels.size());
  }
  writer.finish(terrain);
}

}  // namespace groundgrid::simulation
