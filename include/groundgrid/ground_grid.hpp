#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "groundgrid/config.hpp"
#include "groundgrid/executor.hpp"
#include "groundgrid/export.hpp"
#include "groundgrid/label.hpp"
#include "groundgrid/scan.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid {

/// What process() answers. Element i belongs to input point i; with several sensors the points
/// of the first scan come first, then those of the second, and so on. The spans live until the
/// next process() or reset() of the same object.
struct ScanResult {
  std::span<const Label> labels;
  /// Metres above the ground level that the label was chosen by: the terrain's height or, by
  /// column (Config::threshold_by_column), the mean of the ground points around, some centimetres
  /// above it. For outliers the terrain's height. NaN where the label is unknown.
  std::span<const float> height_above_ground;
  std::size_t ground = 0;
  std::size_t obstacle = 0;
  std::size_t outlier = 0;
  std::size_t unknown = 0;
  /// Height of the first sensor above the ground in use, metres; nothing where none is given and
  /// no scan so far showed the ground.
  std::optional<double> sensor_height_m;
  /// True where sensor_height_m was estimated from a scan and not given.
  bool sensor_height_estimated = false;
  /// True where the pose jumped by more than Config::pose_jump_m and the map was started anew. Not
  /// while the ground is still to be found: until then every scan starts the map anew.
  bool map_restarted = false;
};

/// Where process() shall write instead of into the object's own buffers: one element per input
/// point of all scans together.
struct ScanOutput {
  std::span<Label> labels;
  std::span<float> height_above_ground;
};

/// Ground segmentation and terrain estimation for one vehicle: GroundGrid (Steinke, Goehring,
/// Rojas, RA-L 2024). Scans and poses go in; labels come out and a rolling elevation map stays.
///
/// Frames: base is the vehicle's frame, x forward, z up; map has z against gravity. T_a_b takes
/// coordinates of b into a. Two objects share nothing and may run in two threads; one object is
/// for one thread at a time. Labels and terrain are the same bits for any number of threads and
/// any order of the points. Once warm and once the ground is found, process() allocates nothing.
/// With Config::threads of 1, the default, it never starts a thread.
class GROUNDGRID_EXPORT GroundGrid {
 public:
  /// Throws std::invalid_argument where config.validate() does.
  explicit GroundGrid(const Config& config = {});

  /// Runs on the threads of an executor, such as groundgrid/tbb_executor.hpp, instead of its own;
  /// Config::threads is then not used. Where the executor's concurrency is 1 all runs on the thread
  /// that calls. The executor must outlive this object, and whatever this is moved to. What it
  /// throws leaves process(), and every later process() of this object throws std::logic_error.
  /// Throws std::invalid_argument also where its concurrency is less than 1.
  GroundGrid(const Config& config, Executor& executor);
  ~GroundGrid();
  GroundGrid(GroundGrid&&) noexcept;
  GroundGrid& operator=(GroundGrid&&) noexcept;
  GroundGrid(const GroundGrid&) = delete;
  GroundGrid& operator=(const GroundGrid&) = delete;

  /// Takes one scan. Throws std::invalid_argument, with the map untouched, where a pose or mounting
  /// is not finite, not rigid or more than 1e9 m from the origin, where a view's data is null or
  /// its offsets do not fit its stride, and for more than 4194304 points. Point times are not used.
  ScanResult process(const SensorScan& scan,
                     const Eigen::Isometry3d& T_map_base = Eigen::Isometry3d::Identity());

  /// Takes the scans of several sensors at one pose.
  ScanResult process(std::span<const SensorScan> scans, const Eigen::Isometry3d& T_map_base);

  /// Takes scans that are not motion-corrected: every point is moved by the pose interpolated at
  /// its time between the scan's time_begin and time_end; points of scans without times by the pose
  /// at the end. The map follows T_map_base_end. Throws also where time_end is not later than
  /// time_begin and where the poses are further apart than Config::pose_jump_m.
  ScanResult process(std::span<const SensorScan> scans, const Eigen::Isometry3d& T_map_base_begin,
                     const Eigen::Isometry3d& T_map_base_end);

  /// The same, written into the caller's spans, which the result then points to. Throws
  /// std::invalid_argument where their lengths are not the number of points.
  ScanResult process(std::span<const SensorScan> scans, const Eigen::Isometry3d& T_map_base_begin,
                     const Eigen::Isometry3d& T_map_base_end, const ScanOutput& output);

  /// Forgets the map, the lattice's anchor and the estimated sensor height.
  void reset();

  /// The map as it stands after the last scan; size 0 before the first.
  [[nodiscard]] TerrainView terrain() const;

  /// One standard deviation of each cell's height in terrain(), metres, in the same order: on
  /// simulated drives at least 68 % of the true heights lie within one and some 95 % within two of
  /// it (docs/accuracy.md). Worked out when asked for, in a fraction of the time of a scan; empty
  /// before the first scan. Valid until the next call of this, process() or reset().
  [[nodiscard]] std::span<const float> standard_deviation() const;

  [[nodiscard]] const Config& config() const;

 private:
  class GROUNDGRID_NO_EXPORT Pipeline;
  std::unique_ptr<Pipeline> pipeline_;
};

/// Height in metres of a roughly level sensor above the ground around it, from one scan in the
/// sensor's frame; nothing where the scan shows no flat ground up to 8 m below the sensor. Points
/// nearer than Config::min_range_m and in the own vehicle's box (taken to be in the sensor's frame)
/// do not count. Throws std::invalid_argument where the view's offsets do not fit its stride. See
/// docs/method.md.
GROUNDGRID_EXPORT std::optional<double> estimate_sensor_height(const PointView& points,
                                                               const Config& config = {});

}  // namespace groundgrid
