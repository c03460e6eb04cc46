#include "evaluation/published_results.hpp"
#include "evaluation/reproduction_rows.hpp"

namespace groundgrid::evaluation {
namespace {

using Json = nlohmann::ordered_json;

std::string key_of(const PublishedMetric& metric) {
  std::string key(metric.name);
  for (char& letter : key)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return key;
}

Json row_json(const ReproductionRow& row) {
  Json by_sequence;
  for (std::size_t i = 0; i < kPublishedSequences; ++i)
    by_sequence[std::string(published_sequences()[i].name)] = row.sequences[i] / 100.0;
  return {{"name", row.name},
          {"published", !row.ours},
          {"sequences", by_sequence},
          {"average", row.average / 100.0},
          {"same_sequences", row.same_sequences / 100.0}};
}

Json sequences_json(const Reproduction& reproduction) {
  Json list = Json::array();
  for (const PublishedSequence& published : published_sequences())
    for (const SequenceResult& sequence : reproduction.presets.front().sequences)
      if (sequence.name == published.name)
        list.push_back({{"sequence", sequence.name},
                        {"scans", sequence.scans},
                        {"published_scans", published.scans}});
  return list;
}

Json times_json(const Reproduction& reproduction) {
  Json list = Json::array();
  for (const TimeRow& row : time_rows_of(reproduction))
    list.push_back({{"name", row.name},
                    {"one_thread_ms", row.one_thread_ms},
                    {"all_threads_ms", row.all_threads_ms},
                    {"machine", row.machine}});
  return list;
}

}  // namespace

Json to_json(const Reproduction& reproduction) {
  Json json;
  json["title"] = reproduction.title;
  json["complete"] = is_complete(reproduction);
  json["sequences"] = sequences_json(reproduction);
  json["missing_sequences"] = missing_sequences(reproduction);
  json["unanswered_points"] = "non-ground";
  json["threads"] = reproduction.threads;
  json["threads_give_same_labels"] = true;
  for (const PublishedMetric& metric : published_results()) {
    Json rows = Json::array();
    for (const ReproductionRow& row : rows_of(reproduction, metric)) rows.push_back(row_json(row));
    json["figures"][key_of(metric)] = rows;
  }
  json["times"] = times_json(reproduction);
  return json;
}

}  // namespace groundgrid::evaluation
