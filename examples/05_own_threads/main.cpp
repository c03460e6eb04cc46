// Threads: one vehicle's map in the oneTBB arena that the rest of a program runs in, another's on a
// thread pool that is no oneTBB at all. Both give the bits that one thread gives.
//
//   own_threads

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <future>
#include <groundgrid/adapters/span.hpp>
#include <groundgrid/ground_grid.hpp>
#include <groundgrid/tbb_executor.hpp>
#include <numbers>
#include <vector>

struct Point {
  float x, y, z;
};

// What 64 beams, 1.73 m above it, see of ground that rises by 0.05 m/m.
std::vector<Point> synthetic_scan() {
  std::vector<Point> points;
  for (int beam = 0; beam < 64; ++beam)
    for (int step = 0; step < 2000; ++step) {
      const double down = 0.08 + 0.006 * beam, azimuth = std::numbers::pi / 1000.0 * step;
      const double x = std::cos(azimuth), y = std::sin(azimuth), z = -std::tan(down);
      const double distance = 1.73 / (0.05 * x - z);
      points.push_back({static_cast<float>(distance * x), static_cast<float>(distance * y),
                        static_cast<float>(distance * z)});
    }
  return points;
}

// Stands for a pool of your own: two threads, each with every other tile.
class TwoThreads final : public groundgrid::Executor {
 public:
  [[nodiscard]] int concurrency() const override { return 2; }

  void run(std::size_t tiles, groundgrid::TileTask task) override {
    const auto every_other = [=](std::size_t first) {
      for (std::size_t tile = first; tile < tiles; tile += 2) task(tile);
    };
    std::future<void> odd = std::async(std::launch::async, every_other, std::size_t{1});
    every_other(0);
    odd.get();
  }
};

std::vector<groundgrid::Label> labels_of(groundgrid::GroundGrid grid,
                                         const std::vector<Point>& points) {
  groundgrid::SensorScan scan;
  scan.points = groundgrid::view_of(points);
  const auto labels = grid.process(scan).labels;
  return {labels.begin(), labels.end()};
}

int main() try {
  const std::vector<Point> points = synthetic_scan();
  const groundgrid::Config config;
  const auto labels = labels_of(groundgrid::GroundGrid(config), points);  // this thread alone

  oneapi::tbb::task_arena arena(2, 1, oneapi::tbb::task_arena::priority::high);
  groundgrid::TbbExecutor in_arena(arena);  // outlives the object that runs in it
  const bool arena_agrees = labels_of(groundgrid::GroundGrid(config, in_arena), points) == labels;
  std::printf("an arena of %d threads: %s\n", in_arena.concurrency(),
              arena_agrees ? "the same labels" : "other labels");

  TwoThreads pool;
  const bool pool_agrees = labels_of(groundgrid::GroundGrid(config, pool), points) == labels;
  std::printf("own threads: %s\n", pool_agrees ? "the same labels" : "other labels");
  return arena_agrees && pool_agrees ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
