#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluation/distance_bins.hpp"
#include "evaluation/report.hpp"
#include "evaluation/semantic_kitti_classes.hpp"

namespace groundgrid::evaluation {
namespace {

std::string percent(double ratio) {
  return std::isnan(ratio) ? std::string("-") : fmt::format("{:.2f}", 100.0 * ratio);
}

std::string share(std::uint64_t part, std::uint64_t whole) {
  return percent(whole == 0 ? std::nan("")
                            : static_cast<double>(part) / static_cast<double>(whole));
}

std::string score_columns(const Scores& scores) {
  return fmt::format("{:>9} {:>7} {:>7} {:>8} {:>7}", percent(scores.precision),
                     percent(scores.recall), percent(scores.f1), percent(scores.accuracy),
                     percent(scores.iou));
}

std::string tally_columns(const Tally& tally, Unanswered treatment) {
  const Confusion confusion = tally.confusion(treatment);
  return fmt::format("{:>11} {:>11} {:>10} {:>10} {:>11} {:>10} {}", tally.points(),
                     confusion.true_positive, confusion.false_positive, confusion.false_negative,
                     confusion.true_negative, tally.unanswered(),
                     score_columns(scores_of(confusion)));
}

std::string columns_heading() {
  return fmt::format("{:>11} {:>11} {:>10} {:>10} {:>11} {:>10} {:>9} {:>7} {:>7} {:>8} {:>7}",
                     "points", "TP", "FP", "FN", "TN", "unanswered", "precision", "recall", "F1",
                     "accuracy", "IoU");
}

std::string sequence_table(const Report& report) {
  const bool timed =
      std::any_of(report.sequences.begin(), report.sequences.end(),
                  [](const SequenceResult& sequence) { return sequence.median_ms.has_value(); });
  std::string text = fmt::format("{:<10} {:>6} {}{}\n", "sequence", "scans", columns_heading(),
                                 timed ? " median ms" : "");
  for (const SequenceResult& sequence : report.sequences)
    text += fmt::format("{:<10} {:>6} {}{}\n", sequence.name, sequence.scans,
                        tally_columns(sequence.metrics.total(), report.unanswered),
                        sequence.median_ms ? fmt::format(" {:>9.2f}", *sequence.median_ms) : "");
  return text + fmt::format("{:<10} {:>6} {:>68} {}\n", "average", "", "",
                            score_columns(average_of(report)));
}

std::string class_table(const SegmentationMetrics& pooled) {
  std::string text =
      fmt::format("{:<22} {:>11} {:>11} {:>10} {:>14} {:>12}\n", "class (all sequences)",
                  "counts as", "points", "% ground", "% non-ground", "% unanswered");
  for (std::size_t i = 0; i < pooled.by_class().size(); ++i) {
    const ClassTally& tally = pooled.by_class()[i];
    if (tally.points() == 0) continue;
    const auto number = static_cast<std::uint16_t>(i);
    text += fmt::format(
        "{:<22} {:>11} {:>11} {:>10} {:>14} {:>12}\n", class_name(number),
        truth_name(truth_of(number)), tally.points(), share(tally.ground, tally.points()),
        share(tally.non_ground, tally.points()), share(tally.unanswered, tally.points()));
  }
  return text;
}

std::string distance_table(const SegmentationMetrics& pooled, Unanswered treatment) {
  std::string text = fmt::format("{:<17} {}\n", "distance, m", columns_heading());
  for (std::size_t bin = 0; bin < kDistanceBins; ++bin) {
    const Tally& tally = pooled.by_distance()[bin];
    if (!bin_is_left_out(bin, tally))
      text += fmt::format("{:<17} {}\n", bin_name(bin), tally_columns(tally, treatment));
  }
  return text;
}

std::string grass_table(const SegmentationMetrics& pooled, Unanswered treatment) {
  if (pooled.high_grass().points() == 0) return {};
  return fmt::format("\n{:<17} {}\n{:<17} {}\n{:<17} {}\n", "grass over 10 cm", columns_heading(),
                     "counted", tally_columns(pooled.total(), treatment), "left out",
                     tally_columns(pooled.without_high_grass(), treatment));
}

}  // namespace

std::string to_table(const Report& report) {
  const char* const treatment = report.unanswered == Unanswered::left_out
                                    ? "left out of every figure"
                                    : "counted as non-ground";
  const SegmentationMetrics pooled = report.pooled();
  return fmt::format("{}\nPoints without an answer are {}. Figures in percent.\n\n{}\n{}\n{}{}",
                     report.title, treatment, sequence_table(report), class_table(pooled),
                     distance_table(pooled, report.unanswered),
                     grass_table(pooled, report.unanswered));
}

}  // namespace groundgrid::evaluation
