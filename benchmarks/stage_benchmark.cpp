// Each stage alone, on one thread, with the map and the buffers as a drive leaves them.
#include <benchmark/benchmark.h>

#include <vector>

#include "core/map/elevation_map.hpp"
#include "core/parallel.hpp"
#include "core/stages/cell_limits.hpp"
#include "core/stages/cell_support.hpp"
#include "core/stages/ground_cells.hpp"
#include "core/stages/ground_elevation.hpp"
#include "core/stages/ground_surface.hpp"
#include "core/stages/outlier_filter.hpp"
#include "core/stages/rasterization.hpp"
#include "core/stages/segmentation.hpp"
#include "drives.hpp"

namespace groundgrid::benchmarks {
namespace {

/// The stages of our method in their order, each of them to be called on its own.
class Stages {
 public:
  explicit Stages(const Config& config)
      : config_(config),
        map_(config),
        grid_(map_.cells()),
        support_(map_),
        cells_(map_.cells()),
        surface_(map_, runner_),
        limits_(map_, runner_) {
    for (const TimedScan& scan : drive().scans) {
      take(scan);
      run_all();
    }
    // The map as the last scan finds it, for the stages that change it.
    take(drive().scans.back());
    map_before_ = map_;
    bin();
    filter();
    rasterise();
    find_support();
    classify();
    cells_before_ = cells_;
    reject_from_surface();
    update();
    map_updated_ = map_;
    fill_map();
    choose_limits();
  }

  void bin() { bin_points(pass_, all_points(), map_, config_, bins_); }
  void filter() { filter_outliers(pass_, all_points(), map_, bins_); }
  void rasterise() {
    clear(grid_);
    add_to_cells(bins_, all_points(), {0, static_cast<std::uint32_t>(map_.cells())}, grid_);
    list_occupied(grid_);
  }
  void bin_and_rasterise() {
    bin();
    rasterise();
  }
  void find_support() { support_.find(bins_, grid_); }
  void classify() { cells_.classify(grid_, map_, support_.is_supported(), {&sensor_, 1}, runner_); }
  void reject_from_surface() {
    surface_.withdraw_raised(grid_, plane(), cells_, map_);
    surface_.accept_lone(grid_, cells_);
  }
  void update() {
    update_elevation(grid_, cells_, config_, runner_, map_);
    map_.mark_observed();
  }
  void fill_map() { surface_.fill(grid_, plane(), config_, cells_, map_); }
  void choose_limits() { limits_.choose_by_column(bins_, grid_, map_, config_, runner_); }
  void segment_points() { segment(bins_, limits_, map_, config_, runner_, labels_, heights_); }

  void restore_map_before() { map_ = map_before_; }
  void restore_map_updated() { map_ = map_updated_; }
  void restore_before_surface() {
    map_ = map_before_;
    cells_ = cells_before_;
  }
  [[nodiscard]] std::size_t points() const { return pass_.points.count; }

 private:
  [[nodiscard]] PointRange all_points() const { return {0, pass_.points.count}; }
  [[nodiscard]] LocalPlane plane() const { return {map_.window_z(ground_.z), 0.0, 0.0}; }

  void take(const TimedScan& scan) {
    const Eigen::Vector3d position = scan.T_map_lidar.translation();
    ground_ = {position.x(), position.y(), position.z() - 1.73, 0.0, 0.0};
    map_.started() ? map_.follow(ground_) : map_.start(ground_);
    Eigen::Isometry3d T_window_sensor = scan.T_map_lidar;
    T_window_sensor.translation() << map_.window_x(position.x()), map_.window_y(position.y()),
        map_.window_z(position.z());
    pass_.points = scan.scan().points;
    pass_.trajectory.set_fixed(T_window_sensor);
    sensor_ = pass_.trajectory.end().origin();
    bins_.resize(scan.size());
    labels_.resize(scan.size());
    heights_.resize(scan.size());
  }

  void run_all() {
    bin();
    filter();
    rasterise();
    find_support();
    classify();
    reject_from_surface();
    update();
    fill_map();
    choose_limits();
    segment_points();
  }

  Config config_;
  TileRunner runner_{1};
  ElevationMap map_;
  ElevationMap map_before_{map_};
  ElevationMap map_updated_{map_};
  Plane ground_;
  ScanGrid grid_;
  CellSupport support_;
  GroundCells cells_;
  GroundCells cells_before_{cells_};
  GroundSurface surface_;
  CellLimits limits_;
  BinnedPoints bins_;
  SensorPass pass_;
  Point3f sensor_;
  std::vector<Label> labels_;
  std::vector<float> heights_;
};

using Stage = void (Stages::*)();

/// Times one stage; `prepare`, where given, puts back what it changes and is not timed.
void stage(benchmark::State& state, const Config& config, Stage run, Stage prepare) {
  Stages stages(config);
  for ([[maybe_unused]] const auto iteration : state) {
    if (prepare != nullptr) {
      state.PauseTiming();
      (stages.*prepare)();
      state.ResumeTiming();
    }
    (stages.*run)();
    benchmark::ClobberMemory();
  }
  state.SetLabel(drive().source);
  state.counters["points"] = static_cast<double>(stages.points());
}

void add(const char* name, const Config& config, Stage run, Stage prepare = nullptr) {
  benchmark::RegisterBenchmark(name, stage, config, run, prepare)->Unit(benchmark::kMillisecond);
}

const bool kRegistered = [] {
  add("stage/bin_points", Config{}, &Stages::bin);
  add("stage/filter_outliers", Config{}, &Stages::filter, &Stages::restore_map_before);
  add("stage/rasterize", Config{}, &Stages::rasterise);
  add("stage/find_support", Config{}, &Stages::find_support, &Stages::bin_and_rasterise);
  add("stage/classify", Config{}, &Stages::classify);
  add("stage/update_elevation", Config{}, &Stages::update, &Stages::restore_map_before);
  add("stage/surface/withdraw_raised", Config{}, &Stages::reject_from_surface,
      &Stages::restore_before_surface);
  add("stage/surface/fill", Config{}, &Stages::fill_map, &Stages::restore_map_updated);
  add("stage/choose_limits", Config{}, &Stages::choose_limits);
  add("stage/segment", Config{}, &Stages::segment_points);
  return true;
}();

}  // namespace
}  // namespace groundgrid::benchmarks
