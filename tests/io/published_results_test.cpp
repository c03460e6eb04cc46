// The published figures are typed from the paper: they must fit together as its formulas say.
#include "evaluation/published_results.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

namespace groundgrid::evaluation {
namespace {

constexpr double kRounding = 0.005;

const PublishedRow& row(const std::string& metric, const std::string& method) {
  for (const PublishedMetric& block : published_results())
    if (block.name == metric)
      for (const PublishedRow& candidate : block.rows)
        if (candidate.method == method) return candidate;
  throw std::invalid_argument("no " + metric + " of " + method);
}

TEST(PublishedResults, HaveFiveFiguresOfFourMethods) {
  ASSERT_EQ(published_results().size(), 5U);
  for (const char* const metric : {"Precision", "Recall", "F1", "Accuracy", "IoU"})
    for (const char* const method : {"GroundGrid", "Patchwork++", "GndNet", "JPC"})
      for (const double percent : row(metric, method).sequences) {
        EXPECT_GT(percent, 83.0) << metric << " of " << method;
        EXPECT_LT(percent, 99.6) << metric << " of " << method;
      }
  const Scores ours{.precision = 1.0, .recall = 2.0, .f1 = 3.0, .accuracy = 4.0, .iou = 5.0};
  for (std::size_t i = 0; i < published_results().size(); ++i)
    EXPECT_EQ(ours.*published_results()[i].figure, static_cast<double>(i + 1));
}

TEST(PublishedResults, AreThoseOfThePaperInItsCorners) {
  EXPECT_EQ(row("Precision", "Patchwork++").sequences.front(), 94.99);
  EXPECT_EQ(row("Precision", "Patchwork++").average, 95.80);
  EXPECT_EQ(row("IoU", "GroundGrid").sequences.front(), 94.84);
  EXPECT_EQ(row("IoU", "GroundGrid").sequences.back(), 91.64);
  EXPECT_EQ(row("IoU", "GroundGrid").average, 94.78);
}

TEST(PublishedResults, HaveAveragesThatAreTheMeansOfTheirRowsButForOneMisprint) {
  for (const PublishedMetric& block : published_results())
    for (const PublishedRow& published : block.rows) {
      const double mean =
          std::accumulate(published.sequences.begin(), published.sequences.end(), 0.0) /
          static_cast<double>(kPublishedSequences);
      const bool misprint = block.name == "Recall" && published.method == "JPC";
      if (misprint)
        EXPECT_NEAR(published.average - mean, 0.17, 2.0 * kRounding);
      else
        EXPECT_NEAR(published.average, mean, 2.0 * kRounding)
            << block.name << " of " << published.method;
    }
}

TEST(PublishedResults, HaveF1AndIouThatFollowFromPrecisionAndRecall) {
  for (const char* const method : {"GroundGrid", "Patchwork++", "GndNet", "JPC"})
    for (std::size_t i = 0; i < kPublishedSequences; ++i) {
      const double precision = row("Precision", method).sequences[i];
      const double recall = row("Recall", method).sequences[i];
      // With TP = 1: FP = 1/precision - 1, FN = 1/recall - 1. The ratio falls by at most two for
      // one in F1, by one for one in the others.
      const double union_of_both = 100.0 / precision + 100.0 / recall - 1.0;
      EXPECT_NEAR(row("F1", method).sequences[i], 200.0 / (union_of_both + 1.0), 2.0 * kRounding)
          << method << " on " << published_sequences()[i].name;
      EXPECT_NEAR(row("IoU", method).sequences[i], 100.0 / union_of_both, 3.0 * kRounding)
          << method << " on " << published_sequences()[i].name;
    }
}

TEST(PublishedResults, KnowTheScansOfEverySequence) {
  std::size_t scans = 0;
  for (const PublishedSequence& sequence : published_sequences()) scans += sequence.scans;
  EXPECT_EQ(scans, 23201U);  // What SemanticKITTI says it has with labels.
  EXPECT_EQ(published_sequences().front().name, "00");
  EXPECT_EQ(published_sequences().back().name, "10");
}

TEST(PublishedResults, HaveARateThatFollowsFromTheTime) {
  const PublishedTime time;
  EXPECT_NEAR(1000.0 / time.milliseconds, time.hertz, 0.5);
}

}  // namespace
}  // namespace groundgrid::evaluation
