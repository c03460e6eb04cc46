// Accuracy on real, labelled scans: the default is at least as good as the authors' program.
#include "support/real_data.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "evaluation/segmentation_metrics.hpp"
#include "groundgrid/ground_grid.hpp"
#include "io/semantic_kitti_labels.hpp"

namespace groundgrid {
namespace {

/// Mean IoU over the sequences, in percent, that the authors' published program reaches on the
/// same scans; points without an answer are left out.
constexpr double kAuthorsWithPoses = 97.45;
constexpr double kAuthorsSingleScans = 96.55;
/// The paper's equations to the letter are no worse than this.
constexpr double kPaperIsSane = 85.0;

const std::vector<std::string> kSequences{"00", "01", "03", "06", "09"};
constexpr std::size_t kScans = 10;

double iou_of_sequence(const Config& config, const std::vector<testing::RealScan>& scans,
                       bool single_scans) {
  GroundGrid grid(config);
  evaluation::SegmentationMetrics metrics;
  std::vector<std::uint32_t> predicted;
  for (const testing::RealScan& real : scans) {
    SensorScan scan;
    scan.points = PointView::from_floats(real.points.data(), real.size(), 4);
    if (single_scans) grid.reset();
    const ScanResult result =
        single_scans ? grid.process(scan) : grid.process(scan, real.T_map_lidar);
    EXPECT_FALSE(result.map_restarted) << "nothing of this drive contradicts its map";
    predicted.clear();
    for (const Label label : result.labels) predicted.push_back(io::semantic_kitti_label(label));
    metrics.add_scan(real.points, 4, real.labels, predicted);
  }
  return 100.0 * metrics.total().confusion(evaluation::Unanswered::left_out).iou();
}

double mean_iou(const Config& config, const std::filesystem::path& dataset, bool single_scans) {
  double sum = 0.0;
  for (const std::string& sequence : kSequences) {
    const double iou =
        iou_of_sequence(config, testing::read_scans(dataset, sequence, kScans), single_scans);
    ::testing::Test::RecordProperty("iou_" + sequence, std::to_string(iou));
    sum += iou;
  }
  return sum / static_cast<double>(kSequences.size());
}

TEST(RealData, DefaultWithPosesIsAtLeastAsGoodAsTheAuthorsProgram) {
  GROUNDGRID_NEEDS_DATA(dataset)
  EXPECT_GE(mean_iou(Config{}, *dataset, false), kAuthorsWithPoses);
}

TEST(RealData, DefaultOnSingleScansIsAtLeastAsGoodAsTheAuthorsProgram) {
  GROUNDGRID_NEEDS_DATA(dataset)
  EXPECT_GE(mean_iou(Config{}, *dataset, true), kAuthorsSingleScans);
}

TEST(RealData, PaperPresetIsSane) {
  GROUNDGRID_NEEDS_DATA(dataset)
  EXPECT_GT(mean_iou(Config::paper(), *dataset, false), kPaperIsSane);
}

TEST(RealData, SensorHeightIsFoundOnEverySequence) {
  GROUNDGRID_NEEDS_DATA(dataset)
  for (const std::string& sequence : kSequences) {
    const testing::RealScan real = testing::read_scans(*dataset, sequence, 1).front();
    const auto height =
        estimate_sensor_height(PointView::from_floats(real.points.data(), real.size(), 4));
    ASSERT_TRUE(height.has_value()) << sequence;
    EXPECT_NEAR(*height, 1.73, 0.1) << sequence;  // KITTI's own figure
  }
}

}  // namespace
}  // namespace groundgrid
