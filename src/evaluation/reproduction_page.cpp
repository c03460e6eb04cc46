#include <fmt/format.h>

#include <cmath>

#include "evaluation/reproduction_rows.hpp"

namespace groundgrid::evaluation {
namespace {

std::string cell(double value) {
  return std::isnan(value) ? std::string(" - |") : fmt::format(" {:.2f} |", value);
}

std::string metric_table(const Reproduction& reproduction, const PublishedMetric& metric) {
  std::string text = fmt::format("\n## {}\n\n| |", metric.name);
  for (const PublishedSequence& sequence : published_sequences())
    text += fmt::format(" {} |", sequence.name);
  text += " average | same seq. |\n| --- |";
  for (std::size_t i = 0; i < kPublishedSequences + 2; ++i) text += " --- |";
  text += "\n";
  for (const ReproductionRow& row : rows_of(reproduction, metric)) {
    text += fmt::format("| {} |", row.name);
    for (const double value : row.sequences) text += cell(value);
    text += cell(row.average) + cell(row.same_sequences) + "\n";
  }
  return text;
}

std::string time_table(const Reproduction& reproduction) {
  std::string text =
      "\n## Median time of a scan, ms\n\n| | 1 thread | all threads | machine |\n"
      "| --- | --- | --- | --- |\n";
  for (const TimeRow& row : time_rows_of(reproduction))
    text += fmt::format("| {} |{}{} {} |\n", row.name, cell(row.one_thread_ms),
                        cell(row.all_threads_ms), row.machine);
  return text;
}

}  // namespace

std::string to_markdown(const Reproduction& reproduction) {
  std::string text =
      fmt::format("# Table I, repeated\n\n{}. Figures in percent.\n", reproduction.title);
  for (const std::string& note : notes_of(reproduction)) text += fmt::format("\n{}\n", note);
  for (const PublishedMetric& metric : published_results())
    text += metric_table(reproduction, metric);
  return text + time_table(reproduction);
}

}  // namespace groundgrid::evaluation
