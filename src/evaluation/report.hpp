#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/segmentation_metrics.hpp"

namespace groundgrid::evaluation {

/// The figures of one sequence.
struct SequenceResult {
  std::string name;
  std::size_t scans = 0;
  SegmentationMetrics metrics{};
  std::optional<double> median_ms{};  ///< Of the method's time a scan, where it was run.
};

/// The figures of an evaluation.
struct Report {
  std::string title;  ///< What was evaluated and how, in one line.
  Unanswered unanswered = Unanswered::as_non_ground;
  std::vector<SequenceResult> sequences{};

  /// All sequences' points together.
  [[nodiscard]] SegmentationMetrics pooled() const;
};

/// Figures that are averaged over sequences; ratios from 0 to 1, NaN where nothing was counted.
struct Scores {
  double precision;
  double recall;
  double f1;
  double accuracy;
  double iou;
};

Scores scores_of(const Confusion& confusion);

/// The mean over the sequences, each weighing the same; a sequence in which a figure is 0/0 has no
/// part in the mean of that figure.
Scores average_of(const Report& report);

/// For people: a row per sequence and their average, then all points by class and by distance.
std::string to_table(const Report& report);

/// The same for programs; ratios from 0 to 1, null where nothing was counted.
nlohmann::ordered_json to_json(const Report& report);

/// One row per sequence, average, class and distance, told apart by the first column; ratios from
/// 0 to 1, empty where nothing was counted or the figure has no meaning for the row.
std::string to_csv(const Report& report);

}  // namespace groundgrid::evaluation
