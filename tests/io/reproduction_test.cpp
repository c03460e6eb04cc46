#include "evaluation/reproduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "evaluation/published_results.hpp"
#include "evaluation/reproduction_rows.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::evaluation {
namespace {

using test::contains;

void add_points(SegmentationMetrics& metrics, std::uint32_t truth, std::uint32_t predicted,
                std::size_t count) {
  const std::vector<float> points(4 * count, 1.0F);
  metrics.add_scan(points, 4, std::vector(count, truth), std::vector(count, predicted));
}

// 6 TP, 2 FP, 1 FN and 1 ground point without an answer, 10 TN: precision 75, recall 75, F1 75,
// accuracy 80, IoU 60.
SequenceResult sequence(std::string_view name, std::size_t scans) {
  SequenceResult result{.name = std::string(name), .scans = scans};
  add_points(result.metrics, 40, 40, 6);
  add_points(result.metrics, 50, 40, 2);
  add_points(result.metrics, 72, 99, 1);
  add_points(result.metrics, 72, 0, 1);
  add_points(result.metrics, 10, 1, 10);
  add_points(result.metrics, 70, 40, 100);
  return result;
}

// 6 TP, 10 TN.
SequenceResult faultless(std::string_view name, std::size_t scans) {
  SequenceResult result{.name = std::string(name), .scans = scans};
  add_points(result.metrics, 40, 40, 6);
  add_points(result.metrics, 50, 99, 10);
  return result;
}

Reproduction part() {
  return {.title = "a part",
          .threads = 2,
          .presets = {{.name = "paper",
                       .sequences = {sequence("01", 10), faultless("03", 801)},
                       .one_thread_ms = 8.0,
                       .all_threads_ms = 4.0}}};
}

Reproduction whole() {
  Reproduction reproduction{.title = "all of it", .threads = 1, .presets = {{.name = "paper"}}};
  for (const PublishedSequence& published : published_sequences())
    reproduction.presets[0].sequences.push_back(sequence(published.name, published.scans));
  return reproduction;
}

const PublishedMetric& metric(std::string_view name) {
  return *std::find_if(published_results().begin(), published_results().end(),
                       [&](const PublishedMetric& each) { return each.name == name; });
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Reproduction, PutsOursBelowThePublishedFiguresOfGroundGrid) {
  const auto rows = rows_of(part(), metric("IoU"));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0].name, "GroundGrid, published");
  EXPECT_EQ(rows[1].name, "ours, preset paper");
  EXPECT_EQ(rows[2].name, "Patchwork++, published");
  EXPECT_EQ(rows[3].name, "GndNet, published");
  EXPECT_EQ(rows[4].name, "JPC, published");
  EXPECT_FALSE(rows[0].ours);
  EXPECT_TRUE(rows[1].ours);
}

TEST(Reproduction, CountsPointsWithoutAnAnswerAsNonGround) {
  const std::pair<const char*, double> expected[] = {
      {"Precision", 75.0}, {"Recall", 75.0}, {"F1", 75.0}, {"Accuracy", 80.0}, {"IoU", 60.0}};
  for (const auto& [name, percent] : expected) {
    const ReproductionRow ours = rows_of(part(), metric(name))[1];
    EXPECT_NEAR(ours.sequences[1], percent, 1e-9) << name;
    EXPECT_NEAR(ours.sequences[3], 100.0, 1e-9) << name;
    EXPECT_TRUE(std::isnan(ours.sequences[0])) << name;
    EXPECT_NEAR(ours.same_sequences, (percent + 100.0) / 2.0, 1e-9) << name;
  }
}

TEST(Reproduction, AveragesOverTheSequencesThatAreThere) {
  const auto rows = rows_of(part(), metric("Precision"));
  EXPECT_NEAR(rows[0].same_sequences, (98.01 + 97.96) / 2.0, 1e-9);
  EXPECT_EQ(rows[0].average, 96.99);
  EXPECT_TRUE(std::isnan(rows[1].average));
  EXPECT_NEAR(rows[2].same_sequences, (98.27 + 96.81) / 2.0, 1e-9);
}

TEST(Reproduction, HasAnAverageOfOursWhereAllSequencesAreThere) {
  const auto rows = rows_of(whole(), metric("IoU"));
  EXPECT_NEAR(rows[1].average, 60.0, 1e-9);
  EXPECT_NEAR(rows[1].same_sequences, 60.0, 1e-9);
  EXPECT_NEAR(rows[0].same_sequences, rows[0].average, 0.01);
}

TEST(Reproduction, SaysWhatIsMissing) {
  const test::Names missing = {"00", "02", "04", "05", "06", "07", "08", "09", "10"};
  EXPECT_EQ(missing_sequences(part()), missing);
  EXPECT_FALSE(is_complete(part()));
  const std::string table = to_table(part());
  EXPECT_TRUE(contains(table, "Not in the dataset: 00, 02, 04, 05, 06, 07, 08, 09, 10."));
  EXPECT_TRUE(contains(table, "Not all scans are there: 01 (10 of 1101). "));
  EXPECT_TRUE(contains(table, "cold start"));
}

TEST(Reproduction, SaysThatNothingIsMissing) {
  EXPECT_TRUE(is_complete(whole()));
  const std::string table = to_table(whole());
  EXPECT_TRUE(contains(table, "Every sequence is there with every scan"));
  EXPECT_FALSE(contains(table, "Not "));
}

TEST(Reproduction, IsNotCompleteWithoutOneScan) {
  Reproduction reproduction = whole();
  --reproduction.presets[0].sequences[4].scans;
  EXPECT_FALSE(is_complete(reproduction));
  EXPECT_TRUE(contains(to_table(reproduction), "04 (270 of 271). "));
}

TEST(Reproduction, IsATableOf120Columns) {
  const auto lines = lines_of(to_table(part()));
  for (const std::string& line : lines) EXPECT_LE(line.size(), 120U) << line;
  const auto row = [&](const std::string& begin) {
    return *std::find_if(lines.begin(), lines.end(),
                         [&](const std::string& line) { return line.starts_with(begin); });
  };
  EXPECT_EQ(row(" Patchwork++, published"),
            " Patchwork++, published  94.99  98.27  95.96  96.81  98.18  92.65  97.86  93.29  96.97"
            "  96.06  92.81    95.80      97.54");
  EXPECT_EQ(row(" ours, preset paper "),
            " ours, preset paper          -  75.00      - 100.00      -      -      -      -      -"
            "      -      -        -      87.50");
}

TEST(Reproduction, PutsTheTimesBesideThePublishedOne) {
  const auto rows = time_rows_of(part());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].all_threads_ms, 5.85);
  EXPECT_TRUE(std::isnan(rows[0].one_thread_ms));
  EXPECT_EQ(rows[1].one_thread_ms, 8.0);
  EXPECT_EQ(rows[1].machine, "this machine, 2 threads");
  const auto lines = lines_of(to_table(part()));
  const auto has_line = [&](const std::string& line) {
    return std::find(lines.begin(), lines.end(), line) != lines.end();
  };
  EXPECT_TRUE(
      has_line(" GroundGrid, published              -     -             5.85   171   "
               "Intel i5-13600K, up to 8 threads"));
  EXPECT_TRUE(
      has_line(" ours, preset paper              8.00   125             4.00   250   "
               "this machine, 2 threads"));
}

TEST(Reproduction, IsAPageOfEvenTables) {
  const std::string page = to_markdown(part());
  EXPECT_TRUE(contains(page, "\n## IoU\n\n| | 00 | 01 | 02 |"));
  EXPECT_TRUE(contains(page, "\n| ours, preset paper | - | 60.00 | - | 100.00 | - |"));
  EXPECT_TRUE(contains(page, "\n| ours, preset paper | 8.00 | 4.00 | this machine, 2 threads |\n"));
  std::size_t bars = 0;
  for (const std::string& line : lines_of(page)) {
    const auto here = static_cast<std::size_t>(std::count(line.begin(), line.end(), '|'));
    if (bars != 0 && here != 0) {
      EXPECT_EQ(here, bars) << line;
    }
    bars = here;
  }
}

TEST(Reproduction, IsJsonWithRatios) {
  const auto json = to_json(part());
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["sequences"].size(), 2U);
  EXPECT_EQ(json["sequences"][0]["sequence"], "01");
  EXPECT_EQ(json["sequences"][0]["scans"], 10);
  EXPECT_EQ(json["sequences"][0]["published_scans"], 1101);
  EXPECT_EQ(json["missing_sequences"].size(), 9U);
  const auto& ours = json["figures"]["iou"][1];
  EXPECT_EQ(ours["published"], false);
  EXPECT_NEAR(ours["sequences"]["01"].get<double>(), 0.6, 1e-12);
  EXPECT_EQ(ours["sequences"]["00"].dump(), "null");
  EXPECT_EQ(ours["average"].dump(), "null");
  EXPECT_NEAR(json["figures"]["iou"][0]["average"].get<double>(), 0.9478, 1e-12);
  EXPECT_EQ(json["times"][1]["one_thread_ms"], 8.0);
}

}  // namespace
}  // namespace groundgrid::evaluation
