// The figures of two other methods' labels, as they were counted independently of this code.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "evaluation/segmentation_metrics.hpp"
#include "io/scan_sequence.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "shared_data.hpp"
#include "support/kitti_points.hpp"

namespace groundgrid::evaluation {
namespace {

struct Counted {
  const char* method;
  const char* sequence;
  Confusion confusion;
  double iou_percent;
};

void PrintTo(const Counted& counted, std::ostream* stream) {
  *stream << counted.method << " on " << counted.sequence;
}

class OtherMethods : public test::WithSharedData, public ::testing::WithParamInterface<Counted> {};

TEST_P(OtherMethods, HaveTheFiguresCountedIndependently) {
  const Counted& counted = GetParam();
  const std::vector<std::string> names{counted.sequence};
  const io::ScanSequence sequence = io::find_sequences(data() / "semantickitti", names).front();
  const auto predictions =
      data() / "predictions" / counted.method / "sequences" / counted.sequence / "predictions";
  SegmentationMetrics metrics;
  std::vector<std::uint32_t> truth;
  std::vector<std::uint32_t> predicted;
  for (const io::ScanFile& scan : sequence.scans) {
    const std::vector<float> points = testing::kitti_points(scan.path);
    const std::size_t count = points.size() / 4;
    io::read_labels(sequence.labels() / (scan.name + ".label"), scan.path, count, truth);
    io::read_labels(predictions / (scan.name + ".label"), scan.path, count, predicted);
    metrics.add_scan(points, 4, truth, predicted);
  }
  EXPECT_EQ(metrics.total().answered, counted.confusion);
  EXPECT_EQ(metrics.total().unanswered(), 0U);
  EXPECT_NEAR(100.0 * metrics.total().answered.iou(), counted.iou_percent, 0.005);
}

// In the order of Confusion: TP, FP, FN, TN.
INSTANTIATE_TEST_SUITE_P(
    AuthorsWithPoses, OtherMethods,
    ::testing::Values(Counted{"authors-with-poses", "00", {624415, 11542, 1388, 321435}, 97.97},
                      Counted{"authors-with-poses", "01", {947156, 3698, 2342, 47510}, 99.37},
                      Counted{"authors-with-poses", "03", {460482, 25646, 4368, 276566}, 93.88},
                      Counted{"authors-with-poses", "06", {809919, 14542, 9679, 213938}, 97.10},
                      Counted{"authors-with-poses", "09", {696940, 5357, 2083, 76217}, 98.94}));

INSTANTIATE_TEST_SUITE_P(
    FugSeg, OtherMethods,
    ::testing::Values(Counted{"fugseg", "00", {623208, 12959, 2595, 320018}, 97.56},
                      Counted{"fugseg", "01", {943888, 1556, 5610, 49652}, 99.25},
                      Counted{"fugseg", "03", {457483, 26117, 7367, 276095}, 93.18},
                      Counted{"fugseg", "06", {806773, 9490, 12825, 218990}, 97.31},
                      Counted{"fugseg", "09", {694244, 5580, 4779, 75994}, 98.53}));

}  // namespace
}  // namespace groundgrid::evaluation
