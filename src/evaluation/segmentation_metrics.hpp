#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace groundgrid::evaluation {

/// What a method said about a point.
enum class Answer : std::uint8_t { unanswered, ground, non_ground };

/// Reads a predicted label: the ground classes of SemanticKITTI are ground, 0 is no answer, every
/// other number is non-ground (1, 50, 99, ...). The upper 16 bits are not looked at.
Answer answer_of(std::uint32_t predicted_label);

/// How points without an answer count.
enum class Unanswered : std::uint8_t { as_non_ground, left_out };

/// Points by truth and answer, ground being what is to be found. The ratios are from 0 to 1, and
/// NaN where they would be 0/0.
struct Confusion {
  std::uint64_t true_positive = 0;   ///< Ground called ground.
  std::uint64_t false_positive = 0;  ///< Non-ground called ground.
  std::uint64_t false_negative = 0;  ///< Ground called non-ground.
  std::uint64_t true_negative = 0;   ///< Non-ground called non-ground.

  [[nodiscard]] std::uint64_t points() const;
  [[nodiscard]] double precision() const;
  [[nodiscard]] double recall() const;
  [[nodiscard]] double f1() const;
  [[nodiscard]] double accuracy() const;
  [[nodiscard]] double iou() const;

  bool operator==(const Confusion&) const = default;
};

/// Counted points, with those without an answer apart.
struct Tally {
  Confusion answered;
  std::uint64_t unanswered_ground = 0;      ///< Points without an answer whose truth is ground.
  std::uint64_t unanswered_non_ground = 0;  ///< Points without an answer whose truth is not.

  void add(bool truth_is_ground, Answer answer);
  void add(const Tally& other);
  /// Takes away points that were counted before.
  void remove(const Tally& other);
  [[nodiscard]] std::uint64_t unanswered() const {
    return unanswered_ground + unanswered_non_ground;
  }
  /// Points with a truth that counts, answered or not.
  [[nodiscard]] std::uint64_t points() const { return answered.points() + unanswered(); }
  [[nodiscard]] Confusion confusion(Unanswered treatment) const;
};

/// What became of the points of one class.
struct ClassTally {
  std::uint64_t ground = 0;
  std::uint64_t non_ground = 0;
  std::uint64_t unanswered = 0;

  [[nodiscard]] std::uint64_t points() const { return ground + non_ground + unanswered; }
};

/// Figures by horizontal distance from the sensor: five bins of 10 m, and one for all that is
/// farther (SemanticKITTI's labels end at 50 m) or has no finite coordinates.
inline constexpr double kDistanceBinM = 10.0;
inline constexpr std::size_t kDistanceBins = 6;

/// Grass whose points lie higher than this over the soil counts apart, where that height is known:
/// whether it is ground depends on what for. Metres.
inline constexpr float kHighGrassM = 0.1F;

/// Pools the points of scans; two of them can be pooled into one.
class SegmentationMetrics {
 public:
  /// Counts one scan. `points` holds `floats_per_point` floats a point, x and y first, in the
  /// sensor's frame; `truth` and `predicted` hold one label a point. Throws std::invalid_argument
  /// where their lengths differ.
  /// `heights` holds the true height of each point above the soil, metres, or nothing.
  void add_scan(std::span<const float> points, std::size_t floats_per_point,
                std::span<const std::uint32_t> truth, std::span<const std::uint32_t> predicted,
                std::span<const float> heights = {});
  void add(const SegmentationMetrics& other);

  /// Everything that counts: all points but those of the ignored classes.
  [[nodiscard]] Tally total() const;
  /// The same by distance.
  [[nodiscard]] const std::array<Tally, kDistanceBins>& by_distance() const { return by_distance_; }
  /// Every class, ignored ones too: element i is class number i. As long as the greatest class.
  [[nodiscard]] std::span<const ClassTally> by_class() const { return by_class_; }
  /// Points of class terrain that lie higher than kHighGrassM, of scans with known heights; they
  /// are part of total(), too.
  [[nodiscard]] const Tally& high_grass() const { return high_grass_; }
  /// Everything that counts but high grass.
  [[nodiscard]] Tally without_high_grass() const;

 private:
  std::array<Tally, kDistanceBins> by_distance_{};
  std::vector<ClassTally> by_class_;
  Tally high_grass_{};
};

}  // namespace groundgrid::evaluation
