#include <gtest/gtest.h>

#include <cstdlib>

#include "read_gif.hpp"
#include "render_fixture.hpp"
#include "synthetic_dataset.hpp"

namespace groundgrid::test {
namespace {

class RenderDrive : public Render {
 protected:
  [[nodiscard]] ProgramRun render_drive(const std::string& more) const {
    return run_program("render drive " + shell_word(dataset.path()) + " --size 400x300 --output " +
                       shell_word(gif()) + " " + more);
  }
  [[nodiscard]] std::filesystem::path gif() const { return output("drive.gif"); }
  [[nodiscard]] std::size_t frames() const { return read_gif(gif()).frames.size(); }

  SyntheticDataset dataset;
};

TEST_F(RenderDrive, HasAFrameForEachScanThatShowsGroundAndWall) {
  dataset.add_sequence("00", 3);
  const ProgramRun run = render_drive("--range 20");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  const GifContent content = read_gif(gif());
  ASSERT_EQ(content.frames.size(), 3U);
  for (const rendering::Image& frame : content.frames) {
    EXPECT_EQ(frame.size, (rendering::ImageSize{400, 300}));
    EXPECT_GT(count_of(frame, rendering::kBluishGreen), 500U);
    EXPECT_GT(count_of(frame, rendering::kVermilion), 30U);
  }
  EXPECT_NE(content.frames[0].pixels, content.frames[2].pixels) << "the title counts";
  EXPECT_EQ(files_below(folder.path()), (Names{"drive.gif"}));
}

TEST_F(RenderDrive, TakesEverySoManythScanOfARange) {
  dataset.add_sequence("00", 7);
  ASSERT_EQ(render_drive("--every 3").exit_code, 0);
  EXPECT_EQ(frames(), 3U) << "0, 3, 6";
  ASSERT_EQ(render_drive("--scans 2-5 --every 2").exit_code, 0);
  EXPECT_EQ(frames(), 2U) << "2, 4";
  ASSERT_EQ(render_drive("--scans 6-6").exit_code, 0);
  EXPECT_EQ(frames(), 1U);
}

TEST_F(RenderDrive, FramesAreThePicturesOfTheirScans) {
  dataset.add_sequence("00", 4);
  ASSERT_EQ(render_drive("--scans 3-3 --title ''").exit_code, 0);
  const rendering::Image frame = read_gif(gif()).frames.at(0);
  ASSERT_EQ(render("scan " + shell_word(dataset.path()) + " --scan 3 --size 400x300 --title ''")
                .exit_code,
            0);
  const rendering::Image still = picture();
  // The caption is another one, and the GIF has no mixes of two main colours.
  std::size_t different = 0;
  for (int y = 40; y < 300; ++y)
    for (int x = 0; x < 400; ++x)
      if (std::abs(frame.at(x, y).red - still.at(x, y).red) > 24 ||
          std::abs(frame.at(x, y).green - still.at(x, y).green) > 24)
        ++different;
  EXPECT_LT(different, 200U) << "of 104,000";
}

TEST_F(RenderDrive, DrawsPerspectivesAndErrors) {
  dataset.add_sequence("00", 2);
  const ProgramRun run = render_drive("--view perspective --errors");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_GT(count_of(read_gif(gif()).frames.at(1), rendering::kBluishGreen), 500U);
}

TEST_F(RenderDrive, IsTheSameFileTwice) {
  dataset.add_sequence("00", 2);
  ASSERT_EQ(render_drive("--view perspective").exit_code, 0);
  const std::string first = read_file(gif());
  ASSERT_EQ(render_drive("--view perspective").exit_code, 0);
  EXPECT_EQ(read_file(gif()), first);
}

TEST_F(RenderDrive, RefusesRangesThatAreNone) {
  dataset.add_sequence("00", 2);
  for (const std::string scans : {"3", "5-2", "a-b", "1-", "-1"})
    expect_failure(render_drive("--scans='" + scans + "'"), 2, "'" + scans + "'");
  expect_failure(render_drive("--scans 5-9"), 1, "numbers 0 to 1");
  EXPECT_FALSE(std::filesystem::exists(gif()));
}

TEST_F(RenderDrive, RefusesWhatIsNoGif) {
  dataset.add_sequence("00", 1);
  expect_failure(render("drive " + shell_word(dataset.path())), 2, ".gif");
}

TEST_F(RenderDrive, StopsAtAScanWithoutTruthAndLeavesNothing) {
  dataset.add_sequence("00", 2);
  std::filesystem::remove(dataset.label_file("00", 1));
  expect_failure(render_drive("--errors"), 1, "000001.label");
  EXPECT_TRUE(files_below(folder.path()).empty());
}

TEST_F(RenderDrive, RefusesFlagsOfAPerspectiveWithoutOne) {
  dataset.add_sequence("00", 1);
  expect_failure(render_drive("--azimuth-deg 30"), 2, "--azimuth-deg is for --view perspective");
}

}  // namespace
}  // namespace groundgrid::test
