#include "evaluation/report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "temporary_folder.hpp"

namespace groundgrid::evaluation {
namespace {

using test::contains;

SegmentationMetrics metrics_of(const std::vector<std::uint32_t>& truth,
                               const std::vector<std::uint32_t>& predicted) {
  SegmentationMetrics metrics;
  metrics.add_scan(std::vector<float>(truth.size() * 4, 1.0F), 4, truth, predicted);
  return metrics;
}

// 00: TP 1, FP 1, FN 0, TN 0, and a ground point without an answer. 01: TP 3, TN 1.
Report small_report(Unanswered treatment) {
  return {
      .title = "A test",
      .unanswered = treatment,
      .sequences = {
          {.name = "00",
           .scans = 1,
           .metrics = metrics_of({40, 50, 48}, {40, 40, 0}),
           .median_ms = 2.5},
          {.name = "01", .scans = 2, .metrics = metrics_of({40, 40, 40, 50}, {40, 40, 40, 99})}}};
}

TEST(Report, AveragesOverSequencesNotPoints) {
  const Scores average = average_of(small_report(Unanswered::left_out));
  EXPECT_DOUBLE_EQ(average.iou, (0.5 + 1.0) / 2.0);
  EXPECT_DOUBLE_EQ(average.recall, 1.0);
}

TEST(Report, CountsUnansweredAsNonGroundOnlyIfToldTo) {
  const Scores average = average_of(small_report(Unanswered::as_non_ground));
  EXPECT_DOUBLE_EQ(average.iou, (1.0 / 3.0 + 1.0) / 2.0);
  EXPECT_DOUBLE_EQ(average.recall, (0.5 + 1.0) / 2.0);
}

TEST(Report, LeavesSequencesWithoutAFigureOutOfItsMean) {
  Report report = small_report(Unanswered::left_out);
  report.sequences.push_back({.name = "02", .scans = 1, .metrics = metrics_of({50}, {99})});
  EXPECT_DOUBLE_EQ(average_of(report).iou, 0.75);
  EXPECT_DOUBLE_EQ(average_of(report).accuracy, (0.5 + 1.0 + 1.0) / 3.0);
  EXPECT_TRUE(std::isnan(average_of(Report{}).iou));
}

TEST(Report, PrintsATable) {
  const std::string table = to_table(small_report(Unanswered::as_non_ground));
  EXPECT_TRUE(contains(table, "A test\nPoints without an answer are counted as non-ground."));
  EXPECT_TRUE(contains(table, "33.33      2.50\n"));
  EXPECT_TRUE(contains(table, "66.67\n"));
  EXPECT_TRUE(contains(table, "\nroad "));
  EXPECT_TRUE(contains(table, "\n40-50 "));
  EXPECT_FALSE(contains(table, "> 50"));
}

TEST(Report, PrintsADashForNothing) {
  const Report report{.title = "",
                      .sequences = {{.name = "00", .metrics = metrics_of({50}, {99})}}};
  EXPECT_TRUE(contains(to_table(report), "        -       -       -   100.00       -\n"));
}

TEST(Report, GivesJson) {
  const auto json = to_json(small_report(Unanswered::as_non_ground));
  EXPECT_EQ(json["unanswered_points"], "non-ground");
  const auto& first = json["sequences"][0];
  EXPECT_EQ(first["sequence"], "00");
  EXPECT_EQ(first["points"], 3);
  EXPECT_EQ(first["tp"], 1);
  EXPECT_EQ(first["fp"], 1);
  EXPECT_EQ(first["fn"], 1);
  EXPECT_EQ(first["tn"], 0);
  EXPECT_EQ(first["unanswered"], 1);
  EXPECT_EQ(first["median_ms"], 2.5);
  EXPECT_FALSE(json["sequences"][1].contains("median_ms"));
  EXPECT_EQ(json["pooled"]["points"], 7);
  EXPECT_EQ(json["pooled"]["classes"][0]["name"], "road");
  EXPECT_EQ(json["pooled"]["classes"][0]["counts_as"], "ground");
  EXPECT_EQ(json["pooled"]["distances"].size(), 5U);
  EXPECT_EQ(json["pooled"]["distances"][0]["points"], 7);
  EXPECT_NEAR(json["average"]["iou"].get<double>(), 2.0 / 3.0, 1e-12);
  // Nothing lies beyond 10 m.
  EXPECT_TRUE(contains(json["pooled"]["distances"][1].dump(), "\"iou\":null"));
}

TEST(Report, GivesCsvWithAsManyFieldsInEveryRow) {
  const std::string csv = to_csv(small_report(Unanswered::as_non_ground));
  EXPECT_TRUE(contains(csv,
                       "\nsequence,00,3,2,0,1,1,1,1,0,0.500000,0.500000,0.500000,0.333333,"
                       "0.333333,2.500\n"));
  EXPECT_TRUE(contains(csv, "\nclass,sidewalk,1,0,0,1,,,,,,,,,,\n"));
  EXPECT_TRUE(contains(csv, "\ndistance,10-20,0,0,0,0,0,0,0,0,,,,,,\n"));
  std::size_t commas = 0;
  for (const char letter : csv) {
    commas += letter == ',' ? 1U : 0U;
    if (letter != '\n') continue;
    EXPECT_EQ(commas, 15U);
    commas = 0;
  }
}

TEST(Report, QuotesNamesInCsv) {
  const Report report{.title = "",
                      .sequences = {{.name = "a,\"b\"", .metrics = metrics_of({40}, {40})}}};
  EXPECT_TRUE(contains(to_csv(report), "\nsequence,\"a,\"\"b\"\"\",1,1,0,"));
}

}  // namespace
}  // namespace groundgrid::evaluation
