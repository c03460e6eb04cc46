#include <gtest/gtest.h>

#include "make_raster.hpp"
#include "render_fixture.hpp"
#include "rendering/color_map.hpp"

namespace groundgrid::test {
namespace {

class RenderMap : public Render {
 protected:
  // 40 m by 20 m in cells of 1 m: a slope to the east, with `more` added.
  [[nodiscard]] std::filesystem::path raster(const std::string& name, double more = 0.0,
                                             double hole_below_x = 0.0) const {
    RasterPlan plan{.columns = 40, .rows = 20};
    plan.fill([&](double x, double) {
      return x < hole_below_x ? static_cast<double>(kHole) : 0.1 * (x - 100.0) + more;
    });
    make_raster(folder / name, plan);
    return folder / name;
  }
  [[nodiscard]] std::filesystem::path poses(double x, double y) const {
    std::string text;
    for (int i = 0; i < 3; ++i)
      text += "1 0 0 " + std::to_string(x + i) + " 0 1 0 " + std::to_string(y) + " 0 0 1 0\n";
    write_file(folder / "poses.txt", text);
    return folder / "poses.txt";
  }
};

TEST_F(RenderMap, TerrainGrowsLighterToTheHighSideAndIsWideAsTheTerrainIs) {
  const ProgramRun run = render("terrain " + shell_word(raster("t.tif")));
  ASSERT_EQ(run.exit_code, 0) << run.words;
  const rendering::Image image = picture();
  EXPECT_GT(image.size.width, 1.5 * image.size.height);
  const int middle = image.size.height / 2;
  EXPECT_GT(image.at(image.size.width * 7 / 10, middle).green,
            image.at(image.size.width / 10, middle).green + 60);
}

TEST_F(RenderMap, TerrainTakesItsColoursFromTheHeightsAskedFor) {
  const std::string terrain = "terrain " + shell_word(raster("t.tif")) + " --size 640x480 ";
  ASSERT_EQ(render(terrain + "--heights=-100,100").exit_code, 0);
  const rendering::Image image = picture();
  const rendering::Color left = image.at(100, 240);
  const rendering::Color right = image.at(450, 240);
  EXPECT_NEAR(left.green, right.green, 8) << "4 m of 200";
  expect_failure(render(terrain + "--heights 5,1"), 2, "--heights");
}

TEST_F(RenderMap, KeepsItsInputsWhateverNameTheyHave) {
  const std::filesystem::path map = raster("t.tif");
  const std::filesystem::path reference = raster("r.tif", 1.0);
  const std::filesystem::path path = poses(110.0, 195.0);
  const std::filesystem::path calibration = folder / "calib.txt";
  write_file(calibration, "Tr: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  const std::string more =
      " --path " + shell_word(path) + " --calibration " + shell_word(calibration);
  const std::string terrain = "terrain " + shell_word(map) + more;
  const std::string error = "error " + shell_word(map) + " " + shell_word(reference) + more;
  const auto expect_kept = [&](const std::filesystem::path& input, const std::string& command) {
    std::filesystem::create_hard_link(input, output());
    const std::string before = read_file(input);
    expect_failure(render(command), 2, input.string() + ": would be overwritten as");
    EXPECT_EQ(read_file(output()), before) << command;
    std::filesystem::remove(output());
  };
  for (const auto& input : {map, path, calibration}) expect_kept(input, terrain);
  for (const auto& input : {map, reference, path, calibration}) expect_kept(input, error);
}

TEST_F(RenderMap, TerrainShowsThePathAndRefusesOneElsewhere) {
  const std::string terrain = "terrain " + shell_word(raster("t.tif"));
  ASSERT_EQ(render(terrain).exit_code, 0);
  const std::size_t without = count_of(picture(), rendering::kWhite);
  ASSERT_EQ(render(terrain + " --path " + shell_word(poses(110.0, 195.0))).exit_code, 0);
  EXPECT_NE(count_of(picture(), rendering::kWhite), without);
  expect_failure(render(terrain + " --path " + shell_word(poses(0.0, 0.0))), 1,
                 "poses on the terrain");
  expect_failure(render(terrain + " --calibration calib.txt"), 2, "--path");
}

TEST_F(RenderMap, TerrainWithoutHeightsIsAnError) {
  expect_failure(render("terrain " + shell_word(raster("t.tif", 0.0, 1e6))), 1,
                 "a raster without any");
  expect_failure(render("terrain none.tif"), 1, "none.tif");
}

TEST_F(RenderMap, TerrainInPerspectiveIsTheSameFileTwice) {
  const std::string terrain = "terrain " + shell_word(raster("t.tif")) +
                              " --view perspective --size 640x480 --path " +
                              shell_word(poses(110.0, 195.0));
  const ProgramRun run = render(terrain);
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(picture().size, (rendering::ImageSize{640, 480}));
  const std::string first = read_file(output());
  ASSERT_EQ(render(terrain).exit_code, 0);
  EXPECT_EQ(read_file(output()), first);
  ASSERT_EQ(render(terrain + " --azimuth-deg 90").exit_code, 0);
  EXPECT_NE(read_file(output()), first);
}

TEST_F(RenderMap, IsTheSameFileTwice) {
  const std::string terrain = "terrain " + shell_word(raster("t.tif"));
  ASSERT_EQ(render(terrain).exit_code, 0);
  const std::string first = read_file(output());
  ASSERT_EQ(render(terrain).exit_code, 0);
  EXPECT_EQ(read_file(output()), first);
}

TEST_F(RenderMap, ErrorsOfAMapThatIsTooHighAreRed) {
  const ProgramRun run = render("error " + shell_word(raster("high.tif", 0.5)) + " " +
                                shell_word(raster("true.tif")) + " --limit 0.5 --size 640x480");
  ASSERT_EQ(run.exit_code, 0) << run.words;
  EXPECT_GT(count_of(picture(), rendering::error_colors().at(1.0)), 20000U);
}

TEST_F(RenderMap, ErrorsAreWhiteOnceTheOffsetIsTakenOut) {
  ASSERT_EQ(render("error " + shell_word(raster("high.tif", 0.5)) + " " +
                   shell_word(raster("true.tif")) + " --solve-offset --limit 0.5 --size 640x480")
                .exit_code,
            0);
  EXPECT_LT(count_of(picture(), rendering::error_colors().at(1.0)), 500U) << "the bar alone";
}

TEST_F(RenderMap, ErrorsShowWhereTheEstimateIsMissing) {
  ASSERT_EQ(render("error " + shell_word(raster("part.tif", 0.0, 120.0)) + " " +
                   shell_word(raster("true.tif")) + " --size 640x480")
                .exit_code,
            0);
  EXPECT_EQ(picture().at(100, 240), (rendering::Color{176, 176, 176}));
  EXPECT_EQ(picture().at(480, 240), rendering::kWhite);
}

TEST_F(RenderMap, ErrorsNeedAReferenceThatOverlaps) {
  RasterPlan far{.west = 5000.0};
  make_raster(folder / "far.tif", far);
  expect_failure(
      render("error " + shell_word(raster("t.tif")) + " " + shell_word(folder / "far.tif")), 1,
      "far.tif");
  EXPECT_FALSE(std::filesystem::exists(output()));
}

}  // namespace
}  // namespace groundgrid::test
