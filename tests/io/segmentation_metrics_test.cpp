#include "evaluation/segmentation_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace groundgrid::evaluation {
namespace {

// A point at a distance along x, what it is, and what a method says.
struct Point {
  float x;
  std::uint32_t truth;
  std::uint32_t predicted;
};

SegmentationMetrics metrics_of(const std::vector<Point>& scan) {
  std::vector<float> coordinates;
  std::vector<std::uint32_t> truth;
  std::vector<std::uint32_t> predicted;
  for (const Point& point : scan) {
    coordinates.insert(coordinates.end(), {point.x, 0.0F, -1.0F, 0.0F});
    truth.push_back(point.truth);
    predicted.push_back(point.predicted);
  }
  SegmentationMetrics metrics;
  metrics.add_scan(coordinates, 4, truth, predicted);
  return metrics;
}

TEST(Answer, IsReadFromAnyMethodsNumbers) {
  for (const std::uint32_t label : {40U, 44U, 48U, 49U, 60U, 72U, 0x0007'0028U})
    EXPECT_EQ(answer_of(label), Answer::ground) << label;
  for (const std::uint32_t label : {1U, 50U, 70U, 99U, 252U, 9999U})
    EXPECT_EQ(answer_of(label), Answer::non_ground) << label;
  EXPECT_EQ(answer_of(0), Answer::unanswered);
  EXPECT_EQ(answer_of(0x0007'0000U), Answer::unanswered);
}

TEST(Confusion, GivesTheRatiosWorkedOutByHand) {
  const Confusion confusion{
      .true_positive = 6, .false_positive = 2, .false_negative = 4, .true_negative = 8};
  EXPECT_EQ(confusion.points(), 20U);
  EXPECT_DOUBLE_EQ(confusion.precision(), 6.0 / 8.0);
  EXPECT_DOUBLE_EQ(confusion.recall(), 6.0 / 10.0);
  EXPECT_DOUBLE_EQ(confusion.f1(), 12.0 / 18.0);
  EXPECT_DOUBLE_EQ(confusion.accuracy(), 14.0 / 20.0);
  EXPECT_DOUBLE_EQ(confusion.iou(), 6.0 / 12.0);
}

TEST(Confusion, HasNoRatiosOfNothing) {
  EXPECT_TRUE(std::isnan(Confusion{}.precision()));
  EXPECT_TRUE(std::isnan(Confusion{}.recall()));
  EXPECT_TRUE(std::isnan(Confusion{}.f1()));
  EXPECT_TRUE(std::isnan(Confusion{}.accuracy()));
  EXPECT_TRUE(std::isnan(Confusion{}.iou()));
}

TEST(SegmentationMetrics, CountWhatCounts) {
  const SegmentationMetrics metrics = metrics_of({{1.0F, 40, 40},
                                                  {1.0F, 72, 49},
                                                  {1.0F, 40, 99},
                                                  {1.0F, 50, 40},
                                                  {1.0F, 252, 1},
                                                  {1.0F, 10, 50},
                                                  {1.0F, 300, 99},
                                                  // Ignored, whatever is said of them.
                                                  {1.0F, 0, 40},
                                                  {1.0F, 1, 99},
                                                  {1.0F, 70, 0}});
  const Confusion expected{
      .true_positive = 2, .false_positive = 1, .false_negative = 1, .true_negative = 3};
  EXPECT_EQ(metrics.total().answered, expected);
  EXPECT_EQ(metrics.total().unanswered(), 0U);
}

TEST(SegmentationMetrics, CountPointsWithoutAnAnswerApart) {
  const Tally tally =
      metrics_of({{1.0F, 40, 40}, {1.0F, 40, 0}, {1.0F, 40, 0}, {1.0F, 50, 0}}).total();
  EXPECT_EQ(tally.points(), 4U);
  EXPECT_EQ(tally.unanswered(), 3U);
  EXPECT_EQ(tally.confusion(Unanswered::left_out), (Confusion{.true_positive = 1}));
  EXPECT_EQ(tally.confusion(Unanswered::as_non_ground),
            (Confusion{.true_positive = 1, .false_negative = 2, .true_negative = 1}));
}

TEST(SegmentationMetrics, SortByHorizontalDistance) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const SegmentationMetrics metrics = metrics_of({{0.0F, 40, 40},
                                                  {-9.99F, 40, 40},
                                                  {10.0F, 40, 40},
                                                  {49.99F, 40, 40},
                                                  {50.0F, 40, 40},
                                                  {1e30F, 40, 40},
                                                  {kNan, 40, 40}});
  std::vector<std::uint64_t> points;
  for (const Tally& tally : metrics.by_distance()) points.push_back(tally.points());
  EXPECT_EQ(points, (std::vector<std::uint64_t>{2, 1, 0, 0, 1, 3}));
}

TEST(SegmentationMetrics, KeepHeightOutOfTheDistance) {
  const std::vector<float> coordinates{3.0F, 4.0F, 100.0F};
  SegmentationMetrics metrics;
  metrics.add_scan(coordinates, 3, std::vector<std::uint32_t>{40}, std::vector<std::uint32_t>{40});
  EXPECT_EQ(metrics.by_distance()[0].points(), 1U);
}

TEST(SegmentationMetrics, CountEveryClass) {
  const SegmentationMetrics metrics =
      metrics_of({{1.0F, 70, 40}, {1.0F, 70, 99}, {1.0F, 70, 0}, {1.0F, 0x0001'0046U, 99}});
  ASSERT_EQ(metrics.by_class().size(), 71U);
  const ClassTally& vegetation = metrics.by_class()[70];
  EXPECT_EQ(vegetation.points(), 4U);
  EXPECT_EQ(vegetation.ground, 1U);
  EXPECT_EQ(vegetation.non_ground, 2U);
  EXPECT_EQ(vegetation.unanswered, 1U);
}

TEST(SegmentationMetrics, PoolScans) {
  SegmentationMetrics metrics = metrics_of({{1.0F, 40, 40}, {30.0F, 50, 99}});
  metrics.add(metrics_of({{1.0F, 252, 40}, {1.0F, 40, 0}}));
  EXPECT_EQ(metrics.total().answered,
            (Confusion{.true_positive = 1, .false_positive = 1, .true_negative = 1}));
  EXPECT_EQ(metrics.total().unanswered_ground, 1U);
  EXPECT_EQ(metrics.by_class()[252].ground, 1U);
  EXPECT_EQ(metrics.by_class()[40].points(), 2U);
}

TEST(SegmentationMetrics, CountHighGrassApart) {
  // Above 10 cm only the two points of class terrain are grass; the last has no answer.
  const std::vector<float> coordinates(3 * 6);
  const std::vector<std::uint32_t> truth{72, 72, 72, 40, 50, 72};
  const std::vector<std::uint32_t> predicted{40, 40, 99, 40, 40, 0};
  const std::vector<float> heights{0.0F, 0.1F, 0.11F, 0.5F, 2.0F, 0.3F};
  SegmentationMetrics metrics;
  metrics.add_scan(coordinates, 3, truth, predicted, heights);
  EXPECT_EQ(metrics.high_grass().points(), 2U);
  EXPECT_EQ(metrics.total().confusion(Unanswered::as_non_ground),
            (Confusion{.true_positive = 3, .false_positive = 1, .false_negative = 2}));
  EXPECT_EQ(metrics.without_high_grass().confusion(Unanswered::as_non_ground),
            (Confusion{.true_positive = 3, .false_positive = 1}));

  SegmentationMetrics pooled;
  pooled.add(metrics);
  pooled.add(metrics);
  EXPECT_EQ(pooled.high_grass().points(), 4U);
}

TEST(SegmentationMetrics, RejectLengthsThatDiffer) {
  const std::vector<float> two_points(8);
  const std::vector<std::uint32_t> one{40};
  const std::vector<std::uint32_t> two{40, 40};
  SegmentationMetrics metrics;
  EXPECT_THROW(metrics.add_scan(two_points, 4, one, one), std::invalid_argument);
  EXPECT_THROW(metrics.add_scan(two_points, 4, two, one), std::invalid_argument);
  EXPECT_THROW(metrics.add_scan(two_points, 4, two, two, std::vector<float>(1)),
               std::invalid_argument);
  EXPECT_NO_THROW(metrics.add_scan(two_points, 4, two, two));
}

}  // namespace
}  // namespace groundgrid::evaluation
