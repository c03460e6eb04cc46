#include "evaluation/segmentation_metrics.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "evaluation/semantic_kitti_classes.hpp"
#include "io/semantic_kitti_labels.hpp"

namespace groundgrid::evaluation {
namespace {

double ratio(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(whole);
}

constexpr std::uint16_t kTerrainClass = 72;

std::size_t distance_bin(float x, float y) {
  const double bin =
      std::floor(std::hypot(static_cast<double>(x), static_cast<double>(y)) / kDistanceBinM);
  // Written so that NaN, which compares false, falls into the last bin.
  return bin < static_cast<double>(kDistanceBins - 1) ? static_cast<std::size_t>(bin)
                                                      : kDistanceBins - 1;
}

void count(ClassTally& tally, Answer answer) {
  switch (answer) {
    case Answer::ground:
      ++tally.ground;
      break;
    case Answer::non_ground:
      ++tally.non_ground;
      break;
    case Answer::unanswered:
      ++tally.unanswered;
      break;
  }
}

}  // namespace

Answer answer_of(std::uint32_t predicted_label) {
  const std::uint16_t predicted = io::semantic_kitti_class(predicted_label);
  if (predicted == 0) return Answer::unanswered;
  return truth_of(predicted) == Truth::ground ? Answer::ground : Answer::non_ground;
}

std::uint64_t Confusion::points() const {
  return true_positive + false_positive + false_negative + true_negative;
}
double Confusion::precision() const { return ratio(true_positive, true_positive + false_positive); }
double Confusion::recall() const { return ratio(true_positive, true_positive + false_negative); }
double Confusion::f1() const {
  return ratio(2 * true_positive, 2 * true_positive + false_positive + false_negative);
}
double Confusion::accuracy() const { return ratio(true_positive + true_negative, points()); }
double Confusion::iou() const {
  return ratio(true_positive, true_positive + false_positive + false_negative);
}

void Tally::add(bool truth_is_ground, Answer answer) {
  switch (answer) {
    case Answer::ground:
      ++(truth_is_ground ? answered.true_positive : answered.false_positive);
      break;
    case Answer::non_ground:
      ++(truth_is_ground ? answered.false_negative : answered.true_negative);
      break;
    case Answer::unanswered:
      ++(truth_is_ground ? unanswered_ground : unanswered_non_ground);
      break;
  }
}

void Tally::add(const Tally& other) {
  answered.true_positive += other.answered.true_positive;
  answered.false_positive += other.answered.false_positive;
  answered.false_negative += other.answered.false_negative;
  answered.true_negative += other.answered.true_negative;
  unanswered_ground += other.unanswered_ground;
  unanswered_non_ground += other.unanswered_non_ground;
}

void Tally::remove(const Tally& other) {
  answered.true_positive -= other.answered.true_positive;
  answered.false_positive -= other.answered.false_positive;
  answered.false_negative -= other.answered.false_negative;
  answered.true_negative -= other.answered.true_negative;
  unanswered_ground -= other.unanswered_ground;
  unanswered_non_ground -= other.unanswered_non_ground;
}

Confusion Tally::confusion(Unanswered treatment) const {
  Confusion counted = answered;
  if (treatment == Unanswered::as_non_ground) {
    counted.false_negative += unanswered_ground;
    counted.true_negative += unanswered_non_ground;
  }
  return counted;
}

void SegmentationMetrics::add_scan(std::span<const float> points, std::size_t floats_per_point,
                                   std::span<const std::uint32_t> truth,
                                   std::span<const std::uint32_t> predicted,
                                   std::span<const float> heights) {
  if (points.size() != truth.size() * floats_per_point || truth.size() != predicted.size() ||
      (!heights.empty() && heights.size() != truth.size()))
    throw std::invalid_argument("points, labels and heights differ in number");
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::uint16_t number = io::semantic_kitti_class(truth[i]);
    const Answer answer = answer_of(predicted[i]);
    if (number >= by_class_.size()) by_class_.resize(number + std::size_t{1});
    count(by_class_[number], answer);
    const Truth counted_as = truth_of(number);
    if (counted_as == Truth::ignored) continue;
    const std::size_t bin =
        distance_bin(points[i * floats_per_point], points[i * floats_per_point + 1]);
    by_distance_[bin].add(counted_as == Truth::ground, answer);
    if (number == kTerrainClass && !heights.empty() && heights[i] > kHighGrassM)
      high_grass_.add(true, answer);
  }
}

void SegmentationMetrics::add(const SegmentationMetrics& other) {
  for (std::size_t bin = 0; bin < kDistanceBins; ++bin)
    by_distance_[bin].add(other.by_distance_[bin]);
  high_grass_.add(other.high_grass_);
  if (by_class_.size() < other.by_class_.size()) by_class_.resize(other.by_class_.size());
  for (std::size_t i = 0; i < other.by_class_.size(); ++i) {
    by_class_[i].ground += other.by_class_[i].ground;
    by_class_[i].non_ground += other.by_class_[i].non_ground;
    by_class_[i].unanswered += other.by_class_[i].unanswered;
  }
}

Tally SegmentationMetrics::total() const {
  Tally total;
  for (const Tally& tally : by_distance_) total.add(tally);
  return total;
}

Tally SegmentationMetrics::without_high_grass() const {
  Tally tally = total();
  tally.remove(high_grass_);
  return tally;
}

}  // namespace groundgrid::evaluation
