// The whole of process(), one scan an iteration.
#include <benchmark/benchmark.h>

#include "drives.hpp"
#include "groundgrid/ground_grid.hpp"

namespace groundgrid::benchmarks {
namespace {

Config config_for(const benchmark::State& state, Config config) {
  config.sensor_height_m = 1.73;
  config.threads = static_cast<int>(state.range(0));
  return config;
}

void describe(benchmark::State& state, std::size_t points) {
  state.SetLabel(drive().source);
  state.counters["points"] = static_cast<double>(points);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}

/// Over and over the last scan of the drive into the map that the drive has left.
void warm(benchmark::State& state, const Config& config) {
  GroundGrid grid(config_for(state, config));
  for (const TimedScan& scan : drive().scans) grid.process(scan.scan(), scan.T_map_lidar);
  const TimedScan& last = drive().scans.back();
  for ([[maybe_unused]] const auto iteration : state)
    benchmark::DoNotOptimize(grid.process(last.scan(), last.T_map_lidar).ground);
  describe(state, last.size());
}

/// The drive from end to end and back, so that the map scrolls with every scan.
void driving(benchmark::State& state, const Config& config) {
  GroundGrid grid(config_for(state, config));
  const std::vector<TimedScan>& scans = drive().scans;
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
  GroundGrid grid(config_for(state, config));
  const TimedScan& last = drive().scans.back();
  for ([[maybe_unused]] const auto iteration : state) {
    grid.reset();
    benchmark::DoNotOptimize(grid.process(last.scan()).ground);
  }
  describe(state, last.size());
}

// Wall time: with several threads the caller's own CPU time would tell half of it.
BENCHMARK_CAPTURE(warm, standard, Config{})
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(driving, standard, Config{})
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cold, standard, Config{})
    ->Arg(1)
    ->ArgName("threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(warm, paper, Config::paper())
    ->Arg(1)
    ->ArgName("threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cold, paper, Config::paper())
    ->Arg(1)
    ->ArgName("threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace groundgrid::benchmarks
