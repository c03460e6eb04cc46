// One scan, of which nothing is known but its points: which of them are ground, how high is the
// LiDAR above the ground, and how far ahead is the first obstacle?
//
//   single_scan [SCAN.bin]     x, y, z, intensity as 32-bit floats, as KITTI has them

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <groundgrid/adapters/span.hpp>
#include <groundgrid/ground_grid.hpp>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

struct Point {
  float x, y, z, intensity;
};

std::vector<Point> read_scan(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw std::runtime_error("cannot open " + path);
  const auto bytes = static_cast<std::size_t>(file.tellg());
  if (bytes == 0 || bytes % sizeof(Point) != 0)
    throw std::runtime_error(path + " is no KITTI scan");
  std::vector<Point> points(bytes / sizeof(Point));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(points.data()), static_cast<std::streamsize>(bytes));
  if (!file) throw std::runtime_error("cannot read " + path);
  return points;
}

// What 64 beams, 1.73 m above level ground, see of it and of a car 12 m ahead.
std::vector<Point> synthetic_scan() {
  constexpr double kHeight_m = 1.73, kCar_m = 12.0, kCarHalfWidth_m = 0.9, kCarTop_m = 1.5;
  std::vector<Point> points;
  for (int beam = 0; beam < 64; ++beam)
    for (int step = 0; step < 2000; ++step) {
      const double down = 0.03 + 0.006 * beam, azimuth = std::numbers::pi / 1000.0 * step;
      const double x = std::cos(azimuth), y = std::sin(azimuth), z = -std::tan(down);
      double distance = -kHeight_m / z;
      const double to_car = kCar_m / x;
      if (x > 0.0 && to_car < distance && std::abs(to_car * y) < kCarHalfWidth_m &&
          to_car * z < kCarTop_m - kHeight_m)
        distance = to_car;
      points.push_back({static_cast<float>(distance * x), static_cast<float>(distance * y),
                        static_cast<float>(distance * z), 0.5F});
    }
  return points;
}

int main(int argc, char** argv) try {
  const std::vector<Point> points = argc > 1 ? read_scan(argv[1]) : synthetic_scan();

  groundgrid::SensorScan scan;
  scan.points = groundgrid::view_of(points);  // nothing is copied

  groundgrid::GroundGrid grid;
  const groundgrid::ScanResult result = grid.process(scan);

  const double percent = 100.0 / static_cast<double>(points.size());
  std::printf("%zu points: %.1f %% ground, %.1f %% obstacle, %.1f %% outlier, %.1f %% unknown\n",
              points.size(), percent * static_cast<double>(result.ground),
              percent * static_cast<double>(result.obstacle),
              percent * static_cast<double>(result.outlier),
              percent * static_cast<double>(result.unknown));
  if (result.sensor_height_m)
    std::printf("the LiDAR is %.2f m above the ground\n", *result.sensor_height_m);

  float nearest_m = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (result.labels[i] == groundgrid::Label::obstacle && points[i].x > 3.0F &&
        std::abs(points[i].y) < 1.0F)
      nearest_m = std::min(nearest_m, points[i].x);
  std::printf("the way ahead is free for %.1f m\n", static_cast<double>(nearest_m));
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
