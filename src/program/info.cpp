#include "program/info.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/error.hpp"
#include "program/input_options.hpp"
#include "program/json_text.hpp"
#include "program/sequence_summary.hpp"
#include "program/standard_output.hpp"
#include "program/version.hpp"

namespace groundgrid::program {
namespace {

struct InfoOptions {
  InputOptions input;
  bool every_scan = false;
  bool json = false;
};

SequenceSummary look_at(const InfoOptions& options, const io::ScanSequence& sequence) {
  SequenceSummary summary = summary_of(sequence, options.input.R_level_lidar(), options.every_scan);
  try {
    if (const auto poses = options.input.read_poses(sequence, false)) add_poses(summary, *poses);
  } catch (const io::Error& error) {
    summary.pose_problem = error.what();
  }
  return summary;
}

void print_json(const InfoOptions& options, const std::vector<SequenceSummary>& summaries) {
  nlohmann::ordered_json json{{"program", "groundgrid"},
                              {"version", version()},
                              {"command", "info"},
                              {"input", options.input.path().string()},
                              {"sequences", nlohmann::ordered_json::array()}};
  for (const SequenceSummary& summary : summaries) json["sequences"].push_back(to_json(summary));
  print_result(to_text(json));
}

void print_text(const std::vector<SequenceSummary>& summaries) {
  std::string text;
  for (const SequenceSummary& summary : summaries)
    text += (text.empty() ? "" : "\n") + to_text(summary);
  print_result(text);
}

void require_a_scan(const InfoOptions& options, const std::vector<SequenceSummary>& summaries) {
  for (const SequenceSummary& summary : summaries)
    if (summary.first_scan) return;
  const SequenceSummary& first = summaries.front();
  if (first.sequence.scans.size() == 1) throw std::runtime_error(first.unreadable.front());
  throw io::Error({.file = options.input.path(),
                   .expected = "a scan that can be read",
                   .got = fmt::format("none; the first: {}", first.unreadable.front())});
}

void info(const InfoOptions& options) {
  std::vector<SequenceSummary> summaries;
  for (const io::ScanSequence& sequence : options.input.find_sequences())
    summaries.push_back(look_at(options, sequence));
  require_a_scan(options, summaries);
  if (options.json)
    print_json(options, summaries);
  else
    print_text(summaries);
}

}  // namespace

void add_info(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("info", "Say what is in a scan or dataset, and what is wrong with it");
  const auto options = std::make_shared<InfoOptions>();
  options->input.add_to(*command, "INPUT", "Dataset, folder of scans, scan or list of scans");
  command->add_flag("--every-scan", options->every_scan,
                    "Read all scans instead of the first of each sequence");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { info(*options); });
}

}  // namespace groundgrid::program
