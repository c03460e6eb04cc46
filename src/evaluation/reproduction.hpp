#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "evaluation/report.hpp"

namespace groundgrid::evaluation {

/// What one preset gives on the sequences that are there.
struct ReproducedPreset {
  std::string name;  ///< "paper".
  std::vector<SequenceResult> sequences{};
  double one_thread_ms = 0.0;   ///< Median of the method's time a scan.
  double all_threads_ms = 0.0;  ///< The same with every core.
};

/// The experiment of Table I, repeated. Points without an answer count as non-ground.
struct Reproduction {
  std::string title;        ///< What was run, in one line.
  std::size_t threads = 1;  ///< What "all threads" means on this machine.
  /// At least one; each with the same sequences, whose names are those of published_sequences().
  std::vector<ReproducedPreset> presets{};
};

/// Table I for the terminal, 120 columns wide: the published figures and ours, then the times, then
/// what is missing and what must not be compared.
std::string to_table(const Reproduction& reproduction);

/// The same as a page.
std::string to_markdown(const Reproduction& reproduction);

/// The same for programs; ratios from 0 to 1, the published ones too.
nlohmann::ordered_json to_json(const Reproduction& reproduction);

}  // namespace groundgrid::evaluation
