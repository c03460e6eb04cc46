// `groundgrid evaluate` as users run it: the built program on a small drive and on real scans.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"
#include "shared_data.hpp"
#include "synthetic_dataset.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contains;
using test::ProgramRun;
using test::run_program;
using test::shell_word;

class Evaluate : public ::testing::Test {
 protected:
  Evaluate() {
    dataset.add_sequence("00", 3);
    dataset.add_sequence("01", 1);
  }

  [[nodiscard]] ProgramRun evaluate(const std::string& more = "") const {
    return run_program("evaluate " + shell_word(dataset.path()) + " " + more);
  }
  [[nodiscard]] ProgramRun evaluate_predictions(const std::string& more = "") const {
    return evaluate("--predictions " + shell_word(predictions.path()) + " " + more);
  }
  [[nodiscard]] fs::path prediction(const std::string& sequence, std::size_t number) const {
    return predictions / "sequences" / sequence / "predictions" /
           (test::SyntheticDataset::digits(number) + ".label");
  }
  // Copies the truth: predictions without a fault.
  void predict_truth() const {
    for (const auto& [sequence, scans] : {std::pair("00", 3U), std::pair("01", 1U)})
      for (unsigned i = 0; i < scans; ++i) {
        fs::create_directories(prediction(sequence, i).parent_path());
        fs::copy_file(dataset.label_file(sequence, i), prediction(sequence, i));
      }
  }

  test::SyntheticDataset dataset;
  test::TemporaryFolder predictions;
};

TEST_F(Evaluate, RunsTheMethod) {
  const ProgramRun run = evaluate("--sensor-height-m 1.73");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(contains(run.output, "preset default, sequences with poses, 1 thread"));
  EXPECT_TRUE(contains(run.output, "median ms"));
  EXPECT_TRUE(contains(run.output, "\naverage "));
  EXPECT_TRUE(contains(run.words, "as given"));
}

TEST_F(Evaluate, PrintsJsonAlone) {
  const ProgramRun run = evaluate("--json --preset paper --single-scan");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  const json report = json::parse(run.output);
  EXPECT_EQ(report["preset"], "paper");
  EXPECT_EQ(report["single_scan"], true);
  EXPECT_EQ(report["sequences"][0]["points"], 3 * test::SyntheticScan().size());
  EXPECT_GT(report["sequences"][0]["median_ms"].get<double>(), 0.0);
}

TEST_F(Evaluate, RecordsWhatTheMethodFoundOut) {
  const json sequence = json::parse(evaluate("--json").output)["sequences"][1];
  EXPECT_EQ(sequence["sensor_height"]["estimated"], true);
  EXPECT_NEAR(sequence["sensor_height"]["min_m"].get<double>(), 1.73, 0.02);
  EXPECT_NEAR(sequence["sensor_height"]["max_m"].get<double>(), 1.73, 0.02);
  EXPECT_EQ(sequence["map_restarts"], 0);
  const json given = json::parse(evaluate("--json --sensor-height-m 1.7").output)["sequences"][0];
  EXPECT_EQ(given["sensor_height"], (json{{"min_m", 1.7}, {"max_m", 1.7}, {"estimated", false}}));
  predict_truth();
  const json read = json::parse(evaluate_predictions("--json").output)["sequences"][0];
  EXPECT_FALSE(read.contains("sensor_height"));
  EXPECT_FALSE(read.contains("map_restarts"));
}

TEST_F(Evaluate, ReadsAllPosesBeforeTheFirstScan) {
  fs::remove(dataset.folder / "sequences/01/calib.txt");
  const ProgramRun run = evaluate();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "sequences/01/calib.txt"));
  EXPECT_FALSE(contains(run.words, "sequence 00"));
}

TEST_F(Evaluate, PrintsCsv) {
  const ProgramRun run = evaluate("--csv --sequence 1");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_TRUE(run.output.starts_with("kind,name,points,"));
  EXPECT_TRUE(contains(run.output, "\nsequence,01,"));
  EXPECT_FALSE(contains(run.output, "\nsequence,00,"));
}

TEST_F(Evaluate, GivesTheSameFiguresFromWrittenLabels) {
  ASSERT_EQ(run_program("segment " + shell_word(dataset.path()) + " --output " +
                        shell_word(predictions.path()))
                .exit_code,
            0);
  const json ran = json::parse(evaluate("--json").output);
  const json read = json::parse(evaluate_predictions("--json").output);
  EXPECT_EQ(ran["average"], read["average"]);
  EXPECT_EQ(ran["pooled"], read["pooled"]);
}

TEST_F(Evaluate, CountsGrassApartWhereTheSoilIsKnown) {
  predict_truth();
  const std::size_t points = test::SyntheticScan().size();
  test::write_numbers(dataset.label_file("01", 0), std::vector<std::uint32_t>(points, 72));
  const fs::path heights = dataset.folder / "sequences/01/truth/height/000000.f32";
  EXPECT_FALSE(contains(evaluate_predictions().output, "grass over 10 cm"));
  test::write_numbers(heights, std::vector<float>(points, 0.2F));
  EXPECT_TRUE(contains(evaluate_predictions().output, "grass over 10 cm"));
  EXPECT_TRUE(contains(evaluate_predictions("--csv").output, "\nwithout_high_grass,,"));
  const json report = json::parse(evaluate_predictions("--json").output);
  EXPECT_EQ(report["sequences"][1]["without_high_grass"]["points"], 0);
  EXPECT_EQ(report["pooled"]["without_high_grass"]["points"], 3 * points);
  test::write_numbers(heights, std::vector<float>(points - 1, 0.2F));
  EXPECT_EQ(evaluate_predictions().exit_code, 1);
}

TEST_F(Evaluate, FindsNoFaultInTheTruth) {
  predict_truth();
  const ProgramRun run = evaluate_predictions("--json");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(json::parse(run.output)["average"]["iou"], 1.0);
}

TEST_F(Evaluate, LeavesUnansweredPointsOutIfAskedTo) {
  predict_truth();
  test::write_numbers(prediction("01", 0),
                      std::vector<std::uint32_t>(test::SyntheticScan().size(), 0));
  const auto first_of = [&](const std::string& more) {
    return json::parse(evaluate_predictions("--json --sequence 01 " + more).output)["sequences"][0];
  };
  EXPECT_EQ(first_of("")["recall"], 0.0);
  EXPECT_EQ(first_of("--leave-unanswered-out")["recall"], nullptr);
  EXPECT_EQ(first_of("--leave-unanswered-out")["unanswered"], test::SyntheticScan().size());
}

TEST_F(Evaluate, NamesAMissingPredictionAndTheCounts) {
  predict_truth();
  fs::remove(prediction("00", 1));
  const ProgramRun run = evaluate_predictions();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_TRUE(contains(run.words, prediction("00", 1).string()));
  EXPECT_TRUE(contains(run.words, dataset.scan_file("00", 1).string()));
  EXPECT_TRUE(contains(run.words, "3 scans"));
  EXPECT_TRUE(contains(run.words, "2 of them"));
}

TEST_F(Evaluate, NamesPredictionsOfAnotherLength) {
  predict_truth();
  fs::resize_file(prediction("01", 0), 40);
  const ProgramRun run = evaluate_predictions();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, prediction("01", 0).string()));
  EXPECT_TRUE(contains(run.words, dataset.scan_file("01", 0).string()));
  EXPECT_TRUE(contains(run.words, "10 labels"));
}

TEST_F(Evaluate, LeavesOutSequencesWithoutLabelsUnlessNamed) {
  dataset.add_sequence("11", 1, false);
  const ProgramRun all = evaluate("--csv");
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_TRUE(contains(all.words, "sequence 11 has no labels"));
  EXPECT_FALSE(contains(all.output, "sequence,11"));
  EXPECT_EQ(evaluate("--sequence 11").exit_code, 1);
}

TEST_F(Evaluate, NeedsLabels) {
  const ProgramRun run =
      run_program("evaluate " + shell_word(dataset.folder / "sequences/00/velodyne"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "no labelled sequence"));
}

TEST_F(Evaluate, NoticesThatStandardOutputIsFull) {
  const ProgramRun run =
      run_program("evaluate " + shell_word(dataset.path()) + " --json", "", "/dev/full");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, "standard output"));
}

class EvaluateRealScans : public test::WithSharedData {};

TEST_F(EvaluateRealScans, ScoresAnotherMethodAsItWasCounted) {
  const ProgramRun run =
      run_program("evaluate " + shell_word(data() / "semantickitti") + " --predictions " +
                  shell_word(data() / "predictions/fugseg") + " --sequence 03 --json");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  const json sequence = json::parse(run.output)["sequences"][0];
  EXPECT_EQ(sequence["tp"], 457483);
  EXPECT_EQ(sequence["fp"], 26117);
  EXPECT_EQ(sequence["fn"], 7367);
  EXPECT_EQ(sequence["tn"], 276095);
}

TEST_F(EvaluateRealScans, RunsTheMethodOnThem) {
  const ProgramRun run =
      run_program("evaluate " + shell_word(data() / "semantickitti") + " --sequence 01 --json");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_GT(json::parse(run.output)["average"]["iou"].get<double>(), 0.95);
}

}  // namespace
}  // namespace groundgrid::program
