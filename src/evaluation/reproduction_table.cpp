#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluation/reproduction_rows.hpp"

namespace groundgrid::evaluation {
namespace {

constexpr std::size_t kColumns = 120;

std::string figure(double value) {
  return std::isnan(value) ? std::string("-") : fmt::format("{:.2f}", value);
}

std::string hertz(double milliseconds) {
  return milliseconds > 0.0 ? fmt::format("{:.0f}", 1000.0 / milliseconds) : std::string("-");
}

std::string heading() {
  std::string line = fmt::format("{:<23}", "");
  for (const PublishedSequence& sequence : published_sequences())
    line += fmt::format(" {:>6}", sequence.name);
  return line + fmt::format(" {:>8} {:>10}\n", "average", "same seq.");
}

std::string metric_block(const Reproduction& reproduction, const PublishedMetric& metric) {
  std::string text = fmt::format("\n{}\n", metric.name);
  for (const ReproductionRow& row : rows_of(reproduction, metric)) {
    text += fmt::format(" {:<22}", row.name);
    for (const double value : row.sequences) text += fmt::format(" {:>6}", figure(value));
    text += fmt::format(" {:>8} {:>10}\n", figure(row.average), figure(row.same_sequences));
  }
  return text;
}

std::string time_block(const Reproduction& reproduction) {
  std::string text = fmt::format("{:<23} {:>13} {:>5} {:>16} {:>5}   {}\n", "Median time of a scan",
                                 "1 thread, ms", "Hz", "all threads, ms", "Hz", "machine");
  for (const TimeRow& row : time_rows_of(reproduction))
    text += fmt::format(" {:<22} {:>13} {:>5} {:>16} {:>5}   {}\n", row.name,
                        figure(row.one_thread_ms), hertz(row.one_thread_ms),
                        figure(row.all_threads_ms), hertz(row.all_threads_ms), row.machine);
  return text;
}

// A paragraph in lines of at most kColumns letters.
std::string wrapped(std::string_view paragraph) {
  std::string text;
  while (paragraph.size() > kColumns) {
    const std::size_t end = std::min(paragraph.rfind(' ', kColumns), paragraph.size());
    text += fmt::format("{}\n", paragraph.substr(0, end));
    paragraph.remove_prefix(std::min(end + 1, paragraph.size()));
  }
  return text + fmt::format("{}\n", paragraph);
}

}  // namespace

std::string to_table(const Reproduction& reproduction) {
  std::string text = fmt::format("{}Table I: ground segmentation on SemanticKITTI, percent\n\n{}",
                                 wrapped(reproduction.title), heading());
  for (const PublishedMetric& metric : published_results())
    text += metric_block(reproduction, metric);
  text += fmt::format("\n{}", time_block(reproduction));
  for (const std::string& note : notes_of(reproduction)) text += fmt::format("\n{}", wrapped(note));
  return text;
}

}  // namespace groundgrid::evaluation
