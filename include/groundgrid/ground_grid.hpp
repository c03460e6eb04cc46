#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "groundgrid/config.hpp"
#include "groundgrid/executor.hpp"
#include "groundgrid/export.hpp"
#include "groundgrid/label.hpp"
#include "groundgrid/rigid_transform.hpp"
#include "groundgrid/scan.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid {

/// A move of base between two scans by more than this starts the map anew: at 10 Hz no vehicle on
/// the ground goes half as far.
inline constexpr double kPoseJump_m = 20.0;

/// The result of process(). Element i belongs to input point i; with several sensors the points
/// of the first scan come first, then those of the second, and so on. The spans live until the
/// next process() or reset() of the same object.
struct ScanResult {
  std::span<const Label> labels;
  /// Metres above the ground at the point, by which the label was chosen. That ground is the mean
  /// of the ground returns around, a few centimetres above the map's height, which rests on the
  /// lowest ones; it is the map's height for the paper's method and for outliers. NaN if the label
  /// is unknown.
  std::span<const float> height_above_ground;
  std::size_t ground = 0;
  std::size_t obstacle = 0;
  std::size_t outlier = 0;
  std::size_t unknown = 0;
  /// Height of the first sensor above the ground in use, metres; nothing if none is given and no
  /// scan so far showed the ground.
  std::optional<double> sensor_height_m;
  /// True if sensor_height_m was estimated from a scan and not given.
  bool sensor_height_estimated = false;
  /// True if the map was started anew: the pose jumped by more than kPoseJump_m, or the scan shows
  /// the ground at another height than the map has it (a lift, a pose that is wrong in z). Not
  /// while the ground is still to be found: until then every scan starts the map anew.
  bool map_restarted = false;
};

/// Memory of the caller's for the result: one element per input point of all scans together.
struct ScanOutput {
  std::span<Label> labels;
  std::span<float> height_above_ground;
};

/// One call of process().
struct ScanRequest {
  /// Of one or several sensors.
  std::span<const SensorScan> scans{};
  /// Where base is, at the end of the scan; the map follows it.
  RigidTransform T_map_base{};
  /// Where base was at the begin of the scan, for scans that are not motion-corrected (deskewed):
  /// every point is moved by the pose interpolated at its time between the scan's time_begin and
  /// time_end; points of scans without times by the pose at the end. At most kPoseJump_m away.
  std::optional<RigidTransform> T_map_base_begin{};
  /// Written instead of the object's own buffers; the result then points to it.
  std::optional<ScanOutput> output{};
};

/// Ground segmentation and terrain estimation for one vehicle: GroundGrid (Steinke, Goehring,
/// Rojas, RA-L 2024). Scans and poses go in; labels come out and a rolling elevation map stays.
///
/// Frames: base is the vehicle's frame, x forward, z up; map has z against gravity. T_a_b takes
/// coordinates of b into a. Two objects share nothing and may run in two threads; one object is
/// for one thread at a time. Labels and terrain are the same bits for any number of threads and
/// any order of the points. Once warm and once the ground is found, process() allocates nothing.
class GROUNDGRID_EXPORT GroundGrid {
 public:
  /// `threads` of 0 means one per core; of 1, the default, none is ever started. The methods paper
  /// and reference use one. Throws std::invalid_argument if config.validate() does or `threads` is
  /// not in [0, 1024].
  explicit GroundGrid(const Config& config = {}, int threads = 1);

  /// Runs on the threads of an executor, such as groundgrid/tbb_executor.hpp, instead of its own.
  /// If the executor's concurrency is 1 all runs on the calling thread. The executor must outlive
  /// this object, and whatever this is moved to. What it throws leaves process(), and every later
  /// process() of this object throws std::logic_error. Throws std::invalid_argument also if its
  /// concurrency is less than 1.
  GroundGrid(const Config& config, Executor& executor);
  ~GroundGrid();
  GroundGrid(GroundGrid&&) noexcept;
  GroundGrid& operator=(GroundGrid&&) noexcept;
  GroundGrid(const GroundGrid&) = delete;
  GroundGrid& operator=(const GroundGrid&) = delete;

  /// Takes one scan at one pose. Throws std::invalid_argument, with the map untouched, if a pose or
  /// mounting is not finite, not rigid or more than 1e9 m from the origin, if a view's data is null
  /// or its offsets do not fit its stride, and for more than 4194304 points. Times of points are
  /// not used.
  ScanResult process(const SensorScan& scan,
                     const Eigen::Isometry3d& T_map_base = Eigen::Isometry3d::Identity());

  /// Takes one scan of each of several sensors, deskews them, or writes into the caller's memory.
  /// Throws also if time_end is not later than time_begin, if the poses of begin and end are more
  /// than kPoseJump_m apart, and if the output's lengths are not the number of points.
  ScanResult process(const ScanRequest& request);

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
/// sensor's frame; nothing if the scan shows no flat ground up to 8 m below the sensor. Points
/// nearer than min_range_m and in the ego vehicle's box (taken to be in the sensor's frame) do not
/// count. Throws std::invalid_argument if the view's offsets do not fit its stride. See
/// docs/method.md.
GROUNDGRID_EXPORT std::optional<double> estimate_sensor_height(const PointView& points,
                                                               const Config& config = {});

}  // namespace groundgrid
