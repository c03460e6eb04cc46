#pragma once

#include <array>
#include <string>
#include <vector>

#include "evaluation/published_results.hpp"
#include "evaluation/reproduction.hpp"

namespace groundgrid::evaluation {

/// One line of Table I, percent; NaN where there is no figure.
struct ReproductionRow {
  std::string name;  ///< "Patchwork++, published", "ours, preset paper".
  std::array<double, kPublishedSequences> sequences{};
  double average = 0.0;         ///< Over all eleven sequences.
  double same_sequences = 0.0;  ///< Over those that are there.
  bool ours = false;
};

/// GroundGrid as published, ours, then the other methods.
std::vector<ReproductionRow> rows_of(const Reproduction& reproduction,
                                     const PublishedMetric& metric);

/// One line of the table of times; NaN where there is no figure.
struct TimeRow {
  std::string name;
  double one_thread_ms = 0.0;
  double all_threads_ms = 0.0;
  std::string machine;
};

std::vector<TimeRow> time_rows_of(const Reproduction& reproduction);

/// What was run and how, what is missing, and what that means: a paragraph each.
std::vector<std::string> notes_of(const Reproduction& reproduction);

/// Names of published sequences that are not there.
std::vector<std::string> missing_sequences(const Reproduction& reproduction);

/// Whether every scan behind Table I was there.
bool is_complete(const Reproduction& reproduction);

}  // namespace groundgrid::evaluation
