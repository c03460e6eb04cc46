// share/semantic-kitti-api gives, by the arithmetic of that project, the figures of `evaluate`.
#include "semantic_kitti_api.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "evaluation/segmentation_metrics.hpp"
#include "evaluation/semantic_kitti_classes.hpp"
#include "io/scan_sequence.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "run_program.hpp"
#include "shared_data.hpp"
#include "support/kitti_points.hpp"

namespace groundgrid {
namespace {

namespace fs = std::filesystem;
using evaluation::Confusion;
using evaluation::Truth;
using evaluation::Unanswered;
using nlohmann::json;
using test::LearningMap;
using test::SemanticKittiApi;

const fs::path kFolder = GROUNDGRID_SOURCE_DIR "/share/semantic-kitti-api";
constexpr std::size_t kGround = SemanticKittiApi::kGround;
constexpr std::size_t kNonGround = SemanticKittiApi::kNonGround;

YAML::Node ground() { return YAML::LoadFile((kFolder / "ground.yaml").string()); }

LearningMap remapping() {
  return LearningMap(YAML::LoadFile((kFolder / "ground-predictions.yaml").string()));
}

// What remap_semantic_labels.py makes of predictions.
std::vector<std::uint32_t> remapped(const LearningMap& map, std::vector<std::uint32_t> labels) {
  for (std::uint32_t& label : labels) label = map(label);
  return labels;
}

TEST(SemanticKittiApiFiles, CountClassesAsWeDo) {
  const std::map<Truth, std::uint32_t> numbers{
      {Truth::ignored, 0}, {Truth::ground, kGround}, {Truth::non_ground, kNonGround}};
  const LearningMap map(ground());
  EXPECT_EQ(map.classes().size(), 34U);
  for (const auto& [label, number] : map.classes())
    EXPECT_EQ(number, numbers.at(evaluation::truth_of(static_cast<std::uint16_t>(label)))) << label;
}

TEST(SemanticKittiApiFiles, NameEveryClassOfTheDataSet) {
  const YAML::Node file = ground();
  std::set<std::uint32_t> named;
  for (const auto& entry : file["labels"]) {
    const auto label = entry.first.as<std::uint16_t>();
    named.insert(label);
    if (label != 40 && label != 99) {
      EXPECT_EQ(entry.second.as<std::string>(), evaluation::class_name(label));
    }
    EXPECT_EQ(file["color_map"][label].as<std::vector<int>>().size(), 3U) << label;
  }
  const LearningMap map(file);
  for (std::uint16_t number = 0; number < 300; ++number) {
    EXPECT_EQ(named.contains(number), evaluation::class_name(number) != std::to_string(number))
        << number;
    EXPECT_EQ(named.contains(number), map.classes().contains(number)) << number;
  }
}

TEST(SemanticKittiApiFiles, NameTheResultsGroundAndNonGround) {
  const YAML::Node file = ground();
  ASSERT_EQ(file["learning_map_inv"].size(), 3U);
  const auto result = [&](std::size_t number) {
    return file["labels"][file["learning_map_inv"][number].as<int>()].as<std::string>();
  };
  EXPECT_EQ(result(kGround), "ground");
  EXPECT_EQ(result(kNonGround), "non-ground");
  EXPECT_EQ(file["learning_ignore"][0].as<bool>(), true);
  EXPECT_EQ(file["learning_ignore"][kGround].as<bool>(), false);
  EXPECT_EQ(file["learning_ignore"][kNonGround].as<bool>(), false);
}

TEST(SemanticKittiApiFiles, EvaluateTheSequencesOfTheTable) {
  const std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(ground()["split"]["valid"].as<std::vector<int>>(), all);
  const YAML::Node predictions = YAML::LoadFile((kFolder / "ground-predictions.yaml").string());
  for (const char* const split : {"train", "valid", "test"})
    EXPECT_EQ(predictions["split"][split].as<std::vector<int>>(),
              ground()["split"][split].as<std::vector<int>>());
}

TEST(SemanticKittiApiFiles, MakePredictionsOfTwoNumbers) {
  const LearningMap map = remapping();
  EXPECT_EQ(map.classes().size(), LearningMap(ground()).classes().size());
  for (const auto& [label, number] : map.classes()) {
    const bool is_ground = evaluation::answer_of(label) == evaluation::Answer::ground;
    EXPECT_EQ(number, is_ground ? 40U : 99U) << label;
  }
}

// Every class of the data set as truth and as prediction, each pair with a number of its own.
struct EveryCombination {
  std::vector<std::uint32_t> truth;
  std::vector<std::uint32_t> predicted;
  evaluation::SegmentationMetrics metrics;

  EveryCombination() {
    std::size_t times = 0;
    const LearningMap map(ground());
    for (const auto& [true_class, ignored] : map.classes())
      for (const auto& [predicted_class, ignored_too] : map.classes()) {
        times = (5 * times + 3) % 31;
        // An instance number in the upper half must do no harm.
        truth.insert(truth.end(), times, true_class | 0x50000U);
        predicted.insert(predicted.end(), times, predicted_class);
      }
    const std::vector<float> points(4 * truth.size(), 1.0F);
    metrics.add_scan(points, 4, truth, predicted);
  }

  [[nodiscard]] Confusion ours(Unanswered treatment) const {
    return metrics.total().confusion(treatment);
  }
};

TEST(SemanticKittiApi, GivesOurIouOfGroundForPredictionsAsTheyAre) {
  const EveryCombination points;
  ASSERT_GT(points.metrics.total().unanswered_ground, 0U);
  SemanticKittiApi api(kFolder / "ground.yaml");
  api.add(points.predicted, points.truth);
  EXPECT_EQ(api.iou(kGround), points.ours(Unanswered::as_non_ground).iou());
  EXPECT_NE(api.iou(kGround), points.ours(Unanswered::left_out).iou());
}

TEST(SemanticKittiApi, LeavesPredictionsOfIgnoredClassesOutOfAccuracyOnly) {
  const EveryCombination points;
  SemanticKittiApi api(kFolder / "ground.yaml");
  api.add(points.predicted, points.truth);
  EXPECT_NE(api.accuracy(), points.ours(Unanswered::as_non_ground).accuracy());
  // Without answers and outliers, and vegetation for methods that predict it.
  evaluation::SegmentationMetrics counted;
  for (std::size_t i = 0; i < points.truth.size(); ++i)
    if (const std::uint32_t label = points.predicted[i]; label > 1 && label != 70)
      counted.add_scan(std::vector<float>(4), 4, std::span(points.truth).subspan(i, 1),
                       std::span(points.predicted).subspan(i, 1));
  EXPECT_EQ(api.accuracy(), counted.total().answered.accuracy());
}

TEST(SemanticKittiApi, GivesAllOurFiguresForRemappedPredictions) {
  const EveryCombination points;
  SemanticKittiApi api(kFolder / "ground.yaml");
  api.add(remapped(remapping(), points.predicted), points.truth);
  const Confusion ours = points.ours(Unanswered::as_non_ground);
  EXPECT_EQ(api.count(kGround, kGround), ours.true_positive);
  EXPECT_EQ(api.count(kGround, kNonGround), ours.false_positive);
  EXPECT_EQ(api.count(kNonGround, kGround), ours.false_negative);
  EXPECT_EQ(api.count(kNonGround, kNonGround), ours.true_negative);
  EXPECT_EQ(api.iou(kGround), ours.iou());
  EXPECT_EQ(api.accuracy(), ours.accuracy());
}

class SemanticKittiApiOnRealScans : public test::WithSharedData {
 protected:
  // `evaluate --json` and the API agree on predictions in SemanticKITTI's layout.
  void expect_agreement(const fs::path& predictions) const {
    const fs::path dataset = data() / "semantickitti";
    const test::ProgramRun run =
        test::run_program("evaluate " + test::shell_word(dataset) + " --predictions " +
                          test::shell_word(predictions) + " --json");
    ASSERT_EQ(run.exit_code, 0) << run.words;
    const json ours = json::parse(run.output)["pooled"];

    SemanticKittiApi as_written(kFolder / "ground.yaml");
    SemanticKittiApi after_remapping(kFolder / "ground.yaml");
    add_all(predictions, as_written, after_remapping);
    EXPECT_EQ(as_written.iou(kGround), ours["iou"].get<double>());
    EXPECT_EQ(after_remapping.iou(kGround), ours["iou"].get<double>());
    EXPECT_EQ(after_remapping.accuracy(), ours["accuracy"].get<double>());
    EXPECT_EQ(after_remapping.count(kGround, kGround), ours["tp"]);
    EXPECT_EQ(after_remapping.count(kGround, kNonGround), ours["fp"]);
    EXPECT_EQ(after_remapping.count(kNonGround, kGround), ours["fn"]);
    EXPECT_EQ(after_remapping.count(kNonGround, kNonGround), ours["tn"]);
  }

 private:
  static void add_all(const fs::path& predictions, SemanticKittiApi& as_written,
                      SemanticKittiApi& after_remapping) {
    const LearningMap map = remapping();
    std::vector<std::uint32_t> truth;
    std::vector<std::uint32_t> predicted;
    for (const io::ScanSequence& sequence : io::find_sequences(data() / "semantickitti"))
      for (const io::ScanFile& scan : sequence.scans) {
        const std::vector<float> points = testing::kitti_points(scan.path);
        const std::string name = scan.name + ".label";
        const std::size_t count = points.size() / 4;
        io::read_labels(sequence.labels() / name, scan.path, count, truth);
        io::read_labels(predictions / "sequences" / sequence.name / "predictions" / name, scan.path,
                        count, predicted);
        as_written.add(predicted, truth);
        after_remapping.add(remapped(map, predicted), truth);
      }
  }
};

TEST_F(SemanticKittiApiOnRealScans, AgreesOnOtherMethods) {
  expect_agreement(data() / "predictions/authors-with-poses");
  expect_agreement(data() / "predictions/fugseg");
}

TEST_F(SemanticKittiApiOnRealScans, AgreesOnOurLabelsWithOutliers) {
  const test::TemporaryFolder folder;
  const test::ProgramRun run =
      test::run_program("segment " + test::shell_word(data() / "semantickitti") +
                        " --preset paper --json --output " + test::shell_word(folder.path()));
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_GT(json::parse(run.output)["counts"]["outlier"], 1000);
  expect_agreement(folder.path());
}

}  // namespace
}  // namespace groundgrid
