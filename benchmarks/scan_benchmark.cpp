// The whole of process(), one scan an iteration: wall time, and the CPU time of all threads.
#include <benchmark/benchmark.h>

#include "drives.hpp"
#include "groundgrid/ground_grid.hpp"

namespace groundgrid::benchmarks {
namespace {

const Drive& drive_for(const benchmark::State& state) {
  return drive_of(static_cast<Kilopoints>(state.range(0)));
}

GroundGrid grid_for(const benchmark::State& state, Config config) {
  config.vehicle.sensor_height_m = 1.73;
  return GroundGrid(config, static_cast<int>(state.range(1)));
}

void describe(benchmark::State& state, std::size_t points) {
  state.SetLabel(drive_for(state).source);
  state.counters["points"] = static_cast<double>(points);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}

/// Over and over the last scan of the drive into the map that the drive has left.
void warm(benchmark::State& state, const Config& config) {
  GroundGrid grid = grid_for(state, config);
  const Drive& drive = drive_for(state);
  for (const TimedScan& scan : drive.scans) grid.process(scan.scan(), scan.T_map_lidar);
  const TimedScan& last = drive.scans.back();
  for ([[maybe_unused]] const auto iteration : state)
    benchmark::DoNotOptimize(grid.process(last.scan(), last.T_map_lidar).ground);
  describe(state, last.size());
}

/// The drive from end to end and back, so that the map scrolls with every scan.
void driving(benchmark::State& state, const Config& config) {
  GroundGrid grid = grid_for(state, config);
  const std::vector<TimedScan>& scans = drive_for(state).scans;
  const std::size_t period = 2 * (scans.size() - 1);
  std::size_t points = 0;
  std::size_t step = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    const TimedScan& scan = scans[step < scans.size() ? step : period - step];
    benchmark::DoNotOptimize(grid.process(scan.scan(), scan.T_map_lidar).ground);
    points = scan.size();
    step = (step + 1) % period;
  }
  describe(state, points);
}

/// A single scan: the map is forgotten before each.
void cold(benchmark::State& state, const Config& config) {
  GroundGrid grid = grid_for(state, config);
  const TimedScan& last = drive_for(state).scans.back();
  for ([[maybe_unused]] const auto iteration : state) {
    grid.reset();
    benchmark::DoNotOptimize(grid.process(last.scan()).ground);
  }
  describe(state, last.size());
}

using Values = std::vector<std::int64_t>;

void arguments(benchmark::internal::Benchmark* benchmark, const Values& sizes,
               const Values& threads) {
  benchmark->ArgsProduct({sizes, threads})
      ->ArgNames({"kilopoints", "threads"})
      ->UseRealTime()
      ->MeasureProcessCPUTime()
      ->Unit(benchmark::kMillisecond);
}

void every_size(benchmark::internal::Benchmark* benchmark) {
  arguments(benchmark, {k30, k60, k124, k262, k1000}, {1, 2, 4});
}

void one_size(benchmark::internal::Benchmark* benchmark) { arguments(benchmark, {k124}, {1, 2}); }

void one_thread(benchmark::internal::Benchmark* benchmark) { arguments(benchmark, {k124}, {1}); }

BENCHMARK_CAPTURE(warm, standard, Config{})->Apply(every_size);
BENCHMARK_CAPTURE(driving, standard, Config{})->Apply(one_size);
BENCHMARK_CAPTURE(cold, standard, Config{})->Apply(every_size);
BENCHMARK_CAPTURE(warm, paper, Config::paper())->Apply(one_thread);
BENCHMARK_CAPTURE(cold, paper, Config::paper())->Apply(one_thread);

}  // namespace
}  // namespace groundgrid::benchmarks
