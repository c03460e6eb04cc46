#include <gtest/gtest.h>

#include <vector>

#include "render_fixture.hpp"
#include "synthetic_dataset.hpp"

namespace groundgrid::test {
namespace {

using rendering::Color;
using rendering::Image;

constexpr int kHeading = 80;  ///< Rows above every plot of a picture of 800 x 600, and below.

class RenderScan : public Render {
 protected:
  [[nodiscard]] ProgramRun render_scan(const std::string& more) const {
    return render("scan " + shell_word(dataset.path()) + " " + more);
  }
  // In the columns from `left` to `right` of the plot of a picture of 800 x 600.
  [[nodiscard]] static std::size_t count_in_plot(const Image& image, Color color, int left,
                                                 int right) {
    std::size_t count = 0;
    for (int y = kHeading; y < 600 - kHeading; ++y)
      for (int x = left; x < right; ++x)
        if (is_tinted(image.at(x, y), color)) ++count;
    return count;
  }

  SyntheticDataset dataset;
};

TEST_F(RenderScan, ShowsTheWallOnTheLeftAndTheStreetAllAround) {
  dataset.add_sequence("00", 2);
  const ProgramRun run = render_scan("--scan 1 --size 800x600 --range 20");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  const Image image = picture();
  EXPECT_EQ(image.size, (rendering::ImageSize{800, 600}));
  EXPECT_GT(count_in_plot(image, rendering::kVermilion, 0, 400), 100U);
  EXPECT_EQ(count_in_plot(image, rendering::kVermilion, 400, 800), 0U);
  EXPECT_GT(count_in_plot(image, rendering::kBluishGreen, 0, 400), 500U);
  EXPECT_GT(count_in_plot(image, rendering::kBluishGreen, 400, 800), 500U);
}

TEST_F(RenderScan, DrawsTheLabelsThatSegmentWrites) {
  dataset.add_sequence("00", 3);
  const std::string words = " --size 800x600 --title same ";
  ASSERT_EQ(render_scan("--scan 2" + words).exit_code, 0);
  const Image by_method = picture();
  ASSERT_EQ(run_program("segment " + shell_word(dataset.path()) + " --output " +
                        shell_word(folder / "out"))
                .exit_code,
            0);
  const auto labels = folder / "out" / "sequences" / "00" / "predictions" / "000002.label";
  ASSERT_EQ(render_scan("--scan 2 --labels " + shell_word(labels) + words).exit_code, 0);
  const Image by_file = picture();
  // The caption says where the labels are from.
  const auto plot = [](const Image& image) {
    return std::vector<std::uint32_t>(image.pixels.begin() + 800L * kHeading, image.pixels.end());
  };
  EXPECT_EQ(plot(by_file), plot(by_method));
}

TEST_F(RenderScan, ErrorsAreColouredByWhatIsWrong) {
  dataset.add_sequence("00", 1);
  const SyntheticScan scan;
  const auto draw = [&](std::uint32_t label) {
    write_numbers(folder / "all.label", std::vector<std::uint32_t>(scan.size(), label));
    EXPECT_EQ(render_scan("--errors --size 800x600 --range 20 --labels " +
                          shell_word(folder / "all.label"))
                  .exit_code,
              0);
    return picture();
  };
  const Image all_ground = draw(40);
  EXPECT_GT(count_in_plot(all_ground, rendering::kVermilion, 0, 400), 100U) << "the wall";
  EXPECT_GT(count_in_plot(all_ground, rendering::kBluishGreen, 400, 800), 500U) << "the street";
  EXPECT_EQ(count_in_plot(all_ground, rendering::kBlue, 0, 800), 0U);
  const Image all_obstacle = draw(99);
  EXPECT_EQ(count_in_plot(all_obstacle, rendering::kVermilion, 0, 800), 0U);
  EXPECT_EQ(count_in_plot(all_obstacle, rendering::kBluishGreen, 0, 800), 0U);
  EXPECT_GT(count_in_plot(all_obstacle, rendering::kBlue, 400, 800), 500U) << "the street";
}

TEST_F(RenderScan, TakesTheTruthOfALoneScanFromAFile) {
  dataset.add_sequence("00", 1);
  const std::string scan = "scan " + shell_word(dataset.scan_file("00", 0)) + " --errors";
  expect_failure(render(scan), 1, "--truth");
  const ProgramRun run = render(scan + " --truth " + shell_word(dataset.label_file("00", 0)));
  EXPECT_EQ(run.exit_code, 0) << run.words;
}

TEST_F(RenderScan, IsTheSameFileTwice) {
  dataset.add_sequence("00", 2);
  ASSERT_EQ(render_scan("--scan 1 --threads 1").exit_code, 0);
  const std::string first = read_file(output());
  ASSERT_EQ(render_scan("--scan 1 --threads 3").exit_code, 0);
  EXPECT_EQ(read_file(output()), first);
}

TEST_F(RenderScan, LeavesNothingBesideThePicture) {
  dataset.add_sequence("00", 1);
  ASSERT_EQ(render_scan("").exit_code, 0);
  EXPECT_EQ(files_below(folder.path()), (Names{"picture.png"}));
}

TEST_F(RenderScan, KeepsItsInputsWhateverNameTheyHave) {
  dataset.add_sequence("00", 2);
  const std::filesystem::path poses = folder / "poses.txt";
  const std::filesystem::path calibration = folder / "calib.txt";
  const std::filesystem::path config = folder / "config.toml";
  const std::filesystem::path labels = folder / "a.label";
  std::filesystem::copy_file(dataset.folder / "sequences/00/poses.txt", poses);
  std::filesystem::copy_file(dataset.folder / "sequences/00/calib.txt", calibration);
  std::filesystem::copy_file(dataset.label_file("00", 1), labels);
  write_file(config, "max_step_m = 0.1\n");
  const std::string files = " --poses " + shell_word(poses) + " --calibration " +
                            shell_word(calibration) + " --config " + shell_word(config);
  const auto expect_kept = [&](const std::filesystem::path& input, const std::string& more) {
    std::filesystem::create_hard_link(input, output());
    const std::string before = read_file(input);
    expect_failure(render_scan("--scan 1 " + more), 2, input.string() + ": would be overwritten");
    EXPECT_EQ(read_file(output()), before) << more;
    std::filesystem::remove(output());
  };
  for (const auto& input : {poses, calibration, config}) expect_kept(input, files);
  for (const auto& input : {dataset.scan_file("00", 0), dataset.label_file("00", 0)})
    expect_kept(input, "");
  expect_kept(labels, "--labels " + shell_word(labels));
  expect_kept(labels, "--errors --truth " + shell_word(labels));
}

TEST_F(RenderScan, AsksWhichScanAndSequence) {
  dataset.add_sequence("00", 2);
  expect_failure(render_scan(""), 2, "choose one with --scan");
  expect_failure(render_scan("--scan 7"), 1, "numbers 0 to 1");
  dataset.add_sequence("01", 1);
  expect_failure(render_scan("--scan 0"), 2, "choose one with --sequence");
  EXPECT_EQ(render_scan("--scan 0 --sequence 01").exit_code, 0);
}

TEST_F(RenderScan, SaysWhereTheTruthIsMissing) {
  dataset.add_sequence("00", 1, false);
  const ProgramRun run = render_scan("--errors");
  expect_failure(run, 1, "labels/000000.label");
  EXPECT_TRUE(contains(run.words, "--truth"));
  EXPECT_FALSE(std::filesystem::exists(output()));
}

TEST_F(RenderScan, RefusesLabelsOfAnotherScan) {
  dataset.add_sequence("00", 1);
  write_numbers(folder / "few.label", std::vector<std::uint32_t>(3, 40));
  expect_failure(render_scan("--labels " + shell_word(folder / "few.label")), 1, "few.label");
  EXPECT_FALSE(std::filesystem::exists(output()));
}

TEST_F(RenderScan, RefusesFlagsThatDoNotGoTogether) {
  dataset.add_sequence("00", 1);
  expect_failure(render_scan("--labels a.label --preset paper"), 2, "--preset");
  expect_failure(render_scan("--truth a.label"), 2, "--errors");
  expect_failure(render_scan("--range 0"), 2, "--range");
}

TEST_F(RenderScan, RefusesSizesThatAreNone) {
  dataset.add_sequence("00", 1);
  for (const std::string size : {"800", "800x", "x600", "800x600x3", "-800x600", "800 x 600",
                                 "100x100", "9000x300", "8000x8000", "99999999999x600"})
    expect_failure(render_scan("--size '" + size + "'"), 2, "'" + size + "'");
}

TEST_F(RenderScan, RefusesAnOutputThatCannotBe) {
  dataset.add_sequence("00", 1);
  const std::string scan = "render scan " + shell_word(dataset.path()) + " --output ";
  expect_failure(run_program(scan + shell_word(folder / "a.jpg")), 2, ".png");
  expect_failure(run_program(scan + shell_word(folder / "none" / "a.png")), 1, "none/a.png");
  std::filesystem::create_directory(folder / "b.png");
  expect_failure(run_program(scan + shell_word(folder / "b.png")), 1, "b.png");
  EXPECT_EQ(run_program(scan + shell_word(folder / "c.PNG")).exit_code, 0);
}

}  // namespace
}  // namespace groundgrid::test
