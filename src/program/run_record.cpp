#include "program/run_record.hpp"

#include "program/method_options.hpp"
#include "program/version.hpp"

namespace groundgrid::program {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::filesystem::path& path) {
  return path.empty() ? Json(nullptr) : Json(path.string());
}

Json counts_json(std::size_t scans, const LabelCounts& counts) {
  return {{"scans", scans},
          {"points", counts.points()},
          {"ground", counts.ground},
          {"obstacle", counts.obstacle},
          {"outlier", counts.outlier},
          {"unknown", counts.unknown}};
}

Json sequence_json(const SequenceRecord& sequence) {
  Json skipped = Json::array();
  for (const SkippedScan& scan : sequence.skipped)
    skipped.push_back({{"file", scan.file.string()}, {"reason", scan.reason}});
  Json json{{"sequence", sequence.name.empty() ? Json(nullptr) : Json(sequence.name)},
            {"folder", sequence.folder.string()},
            {"counts", counts_json(sequence.scans, sequence.counts)}};
  put_notes(json, sequence.notes);
  json["terrain"] = or_null(sequence.terrain);
  json["skipped"] = skipped;
  return json;
}

Json skipped_sequences_json(const RunRecord& record) {
  Json skipped = Json::array();
  for (const SkippedSequence& sequence : record.skipped_sequences)
    skipped.push_back({{"sequence", sequence.name},
                       {"folder", sequence.folder.string()},
                       {"scans", sequence.scans},
                       {"reason", sequence.reason}});
  return skipped;
}

}  // namespace

std::size_t RunRecord::scans() const {
  std::size_t scans = 0;
  for (const SequenceRecord& sequence : sequences) scans += sequence.scans;
  return scans;
}

std::size_t RunRecord::labelled() const {
  std::size_t labelled = 0;
  for (const SequenceRecord& sequence : sequences)
    labelled += sequence.counts.points() - sequence.counts.unknown;
  return labelled;
}

double RunRecord::scans_per_second() const {
  return seconds > 0.0 ? static_cast<double>(scans()) / seconds : 0.0;
}

std::size_t RunRecord::skipped() const {
  std::size_t skipped = 0;
  for (const SequenceRecord& sequence : sequences) skipped += sequence.skipped.size();
  for (const SkippedSequence& sequence : skipped_sequences) skipped += sequence.scans;
  return skipped;
}

Json to_json(const RunRecord& record) {
  LabelCounts counts;
  Json sequences = Json::array();
  for (const SequenceRecord& sequence : record.sequences) {
    counts.add(sequence.counts);
    sequences.push_back(sequence_json(sequence));
  }
  return {{"program", "groundgrid"},
          {"version", version()},
          {"command", "segment"},
          {"arguments", record.arguments},
          {"complete", record.skipped() == 0},
          {"input", record.input.string()},
          {"output", record.output.string()},
          {"poses", or_null(record.poses)},
          {"preset", record.preset},
          {"single_scan", record.single_scan},
          {"config", to_json(record.config)},
          {"threads", record.threads},
          {"counts", counts_json(record.scans(), counts)},
          {"seconds", record.seconds},
          {"scans_per_second", record.scans_per_second()},
          {"skipped_scans", record.skipped()},
          {"sequences", sequences},
          {"skipped_sequences", skipped_sequences_json(record)}};
}

}  // namespace groundgrid::program
