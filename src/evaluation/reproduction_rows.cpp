#include "evaluation/reproduction_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace groundgrid::evaluation {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kOwnMethod = "GroundGrid";

const SequenceResult* find(const ReproducedPreset& preset, std::string_view name) {
  const auto found = std::find_if(preset.sequences.begin(), preset.sequences.end(),
                                  [&](const SequenceResult& each) { return each.name == name; });
  return found == preset.sequences.end() ? nullptr : &*found;
}

bool is_there(const Reproduction& reproduction, std::string_view sequence) {
  return find(reproduction.presets.front(), sequence) != nullptr;
}

ReproductionRow published_row(const Reproduction& reproduction, const PublishedRow& published) {
  ReproductionRow row{.name = fmt::format("{}, published", published.method),
                      .sequences = published.sequences,
                      .average = published.average};
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < kPublishedSequences; ++i) {
    if (!is_there(reproduction, published_sequences()[i].name)) continue;
    sum += published.sequences[i];
    ++count;
  }
  row.same_sequences = count > 0.0 ? sum / count : kNone;
  return row;
}

ReproductionRow own_row(const ReproducedPreset& preset, double Scores::*figure) {
  ReproductionRow row{.name = fmt::format("ours, preset {}", preset.name), .ours = true};
  for (std::size_t i = 0; i < kPublishedSequences; ++i) {
    const SequenceResult* const sequence = find(preset, published_sequences()[i].name);
    row.sequences[i] =
        sequence == nullptr
            ? kNone
            : 100.0 *
                  scores_of(sequence->metrics.total().confusion(Unanswered::as_non_ground)).*figure;
  }
  row.same_sequences = 100.0 * average_of({.title = {}, .sequences = preset.sequences}).*figure;
  // An average over fewer sequences must not stand below one over all.
  row.average = preset.sequences.size() == kPublishedSequences ? row.same_sequences : kNone;
  return row;
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

std::vector<std::string> cut_sequences(const Reproduction& reproduction) {
  std::vector<std::string> cut;
  for (const PublishedSequence& published : published_sequences()) {
    const SequenceResult* const sequence = find(reproduction.presets.front(), published.name);
    if (sequence != nullptr && sequence->scans < published.scans)
      cut.push_back(fmt::format("{} ({} of {})", published.name, sequence->scans, published.scans));
  }
  return cut;
}

}  // namespace

std::vector<ReproductionRow> rows_of(const Reproduction& reproduction,
                                     const PublishedMetric& metric) {
  std::vector<ReproductionRow> rows;
  for (const PublishedRow& published : metric.rows)
    if (published.method == kOwnMethod) rows.push_back(published_row(reproduction, published));
  for (const ReproducedPreset& preset : reproduction.presets)
    rows.push_back(own_row(preset, metric.figure));
  for (const PublishedRow& published : metric.rows)
    if (published.method != kOwnMethod) rows.push_back(published_row(reproduction, published));
  return rows;
}

std::vector<TimeRow> time_rows_of(const Reproduction& reproduction) {
  const PublishedTime published;
  std::vector<TimeRow> rows{{fmt::format("{}, published", kOwnMethod), kNone,
                             published.milliseconds, std::string(published.machine)}};
  for (const ReproducedPreset& preset : reproduction.presets)
    rows.push_back({fmt::format("ours, preset {}", preset.name), preset.one_thread_ms,
                    preset.all_threads_ms,
                    fmt::format("this machine, {} thread{}", reproduction.threads,
                                reproduction.threads == 1 ? "" : "s")});
  return rows;
}

std::vector<std::string> missing_sequences(const Reproduction& reproduction) {
  std::vector<std::string> missing;
  for (const PublishedSequence& published : published_sequences())
    if (!is_there(reproduction, published.name)) missing.emplace_back(published.name);
  return missing;
}

bool is_complete(const Reproduction& reproduction) {
  return missing_sequences(reproduction).empty() && cut_sequences(reproduction).empty();
}

std::vector<std::string> notes_of(const Reproduction& reproduction) {
  std::vector<std::string> notes{
      "Ours: sequences with their poses, the sensor's height estimated from the first scan. As in "
      "the paper (IV-A), road, parking, sidewalk, other-ground, lane-marking and terrain are "
      "ground "
      "and unlabeled, outlier and vegetation are not counted; a sequence's points are pooled. The "
      "paper does not say how points without an answer count: here as non-ground.",
      fmt::format("The labels of 1 thread and of all threads ({}) were compared: they are the same "
                  "in every scan.",
                  reproduction.threads)};
  if (is_complete(reproduction)) {
    notes.emplace_back("Every sequence is there with every scan: the figures can be compared.");
    return notes;
  }
  if (const auto missing = missing_sequences(reproduction); !missing.empty())
    notes.push_back(fmt::format(
        "Not in the dataset: {}. 'same seq.' is the average over those that are there, in the "
        "published rows too.",
        joined(missing)));
  if (const auto cut = cut_sequences(reproduction); !cut.empty())
    notes.push_back(fmt::format(
        "Not all scans are there: {}. A part of a sequence, from a cold start, cannot be compared "
        "with the published figures of the whole.",
        joined(cut)));
  return notes;
}

}  // namespace groundgrid::evaluation
