#include "evaluation/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "evaluation/distance_bins.hpp"
#include "evaluation/semantic_kitti_classes.hpp"
#include "io/csv_field.hpp"

namespace groundgrid::evaluation {
namespace {

using Json = nlohmann::ordered_json;

double mean_of(const Report& report, double Scores::*figure) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const SequenceResult& sequence : report.sequences) {
    const double value = scores_of(sequence.metrics.total().confusion(report.unanswered)).*figure;
    if (std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
}

void put_scores(Json& json, const Scores& scores) {
  json["precision"] = scores.precision;
  json["recall"] = scores.recall;
  json["f1"] = scores.f1;
  json["accuracy"] = scores.accuracy;
  json["iou"] = scores.iou;
}

void put_tally(Json& json, const Tally& tally, Unanswered treatment) {
  const Confusion confusion = tally.confusion(treatment);
  json["points"] = tally.points();
  json["tp"] = confusion.true_positive;
  json["fp"] = confusion.false_positive;
  json["fn"] = confusion.false_negative;
  json["tn"] = confusion.true_negative;
  json["unanswered"] = tally.unanswered();
  put_scores(json, scores_of(confusion));
}

Json classes_json(const SegmentationMetrics& metrics) {
  Json classes = Json::array();
  for (std::size_t i = 0; i < metrics.by_class().size(); ++i) {
    const ClassTally& tally = metrics.by_class()[i];
    if (tally.points() == 0) continue;
    const auto number = static_cast<std::uint16_t>(i);
    classes.push_back({{"class", number},
                       {"name", class_name(number)},
                       {"counts_as", truth_name(truth_of(number))},
                       {"points", tally.points()},
                       {"ground", tally.ground},
                       {"non_ground", tally.non_ground},
                       {"unanswered", tally.unanswered}});
  }
  return classes;
}

Json distances_json(const SegmentationMetrics& metrics, Unanswered treatment) {
  Json distances = Json::array();
  for (std::size_t bin = 0; bin < kDistanceBins; ++bin) {
    const Tally& tally = metrics.by_distance()[bin];
    if (bin_is_left_out(bin, tally)) continue;
    Json row;
    row["from_m"] = bin_begin_m(bin);
    row["to_m"] = bin + 1 < kDistanceBins ? Json(bin_begin_m(bin + 1)) : Json(nullptr);
    put_tally(row, tally, treatment);
    distances.push_back(row);
  }
  return distances;
}

void put_metrics(Json& json, const SegmentationMetrics& metrics, Unanswered treatment) {
  put_tally(json, metrics.total(), treatment);
  json["classes"] = classes_json(metrics);
  json["distances"] = distances_json(metrics, treatment);
  if (metrics.high_grass().points() > 0)
    put_tally(json["without_high_grass"], metrics.without_high_grass(), treatment);
}

std::string number_or_nothing(double value) {
  return std::isnan(value) ? std::string{} : fmt::format("{:.6f}", value);
}

std::string scores_csv(const Scores& scores) {
  return fmt::format("{},{},{},{},{}", number_or_nothing(scores.precision),
                     number_or_nothing(scores.recall), number_or_nothing(scores.f1),
                     number_or_nothing(scores.accuracy), number_or_nothing(scores.iou));
}

std::string tally_csv(const char* kind, const std::string& name, const Tally& tally,
                      Unanswered treatment, std::optional<double> median_ms) {
  const Confusion confusion = tally.confusion(treatment);
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", kind, io::csv_field(name),
                     tally.points(), tally.answered.true_positive + tally.answered.false_positive,
                     tally.answered.false_negative + tally.answered.true_negative,
                     tally.unanswered(), confusion.true_positive, confusion.false_positive,
                     confusion.false_negative, confusion.true_negative,
                     scores_csv(scores_of(confusion)),
                     median_ms ? fmt::format("{:.3f}", *median_ms) : std::string{});
}

std::string classes_csv(const SegmentationMetrics& metrics) {
  std::string text;
  for (std::size_t i = 0; i < metrics.by_class().size(); ++i) {
    const ClassTally& tally = metrics.by_class()[i];
    if (tally.points() == 0) continue;
    text +=
        fmt::format("class,{},{},{},{},{},,,,,,,,,,\n", class_name(static_cast<std::uint16_t>(i)),
                    tally.points(), tally.ground, tally.non_ground, tally.unanswered);
  }
  return text;
}

}  // namespace

SegmentationMetrics Report::pooled() const {
  SegmentationMetrics pooled;
  for (const SequenceResult& sequence : sequences) pooled.add(sequence.metrics);
  return pooled;
}

Scores scores_of(const Confusion& confusion) {
  return {confusion.precision(), confusion.recall(), confusion.f1(), confusion.accuracy(),
          confusion.iou()};
}

Scores average_of(const Report& report) {
  return {mean_of(report, &Scores::precision), mean_of(report, &Scores::recall),
          mean_of(report, &Scores::f1), mean_of(report, &Scores::accuracy),
          mean_of(report, &Scores::iou)};
}

Json to_json(const Report& report) {
  Json json;
  json["title"] = report.title;
  json["unanswered_points"] = report.unanswered == Unanswered::left_out ? "left out" : "non-ground";
  json["sequences"] = Json::array();
  for (const SequenceResult& sequence : report.sequences) {
    Json row;
    row["sequence"] = sequence.name;
    row["scans"] = sequence.scans;
    if (sequence.median_ms) row["median_ms"] = *sequence.median_ms;
    put_metrics(row, sequence.metrics, report.unanswered);
    json["sequences"].push_back(row);
  }
  put_scores(json["average"], average_of(report));
  put_metrics(json["pooled"], report.pooled(), report.unanswered);
  return json;
}

std::string to_csv(const Report& report) {
  std::string text =
      "kind,name,points,ground,non_ground,unanswered,tp,fp,fn,tn,precision,recall,f1,accuracy,iou,"
      "median_ms\n";
  for (const SequenceResult& sequence : report.sequences)
    text += tally_csv("sequence", sequence.name, sequence.metrics.total(), report.unanswered,
                      sequence.median_ms);
  text += fmt::format("average,,,,,,,,,,{},\n", scores_csv(average_of(report)));
  const SegmentationMetrics pooled = report.pooled();
  text += classes_csv(pooled);
  for (std::size_t bin = 0; bin < kDistanceBins; ++bin)
    if (!bin_is_left_out(bin, pooled.by_distance()[bin]))
      text +=
          tally_csv("distance", bin_name(bin), pooled.by_distance()[bin], report.unanswered, {});
  if (pooled.high_grass().points() > 0)
    text += tally_csv("without_high_grass", "", pooled.without_high_grass(), report.unanswered, {});
  return text;
}

}  // namespace groundgrid::evaluation
