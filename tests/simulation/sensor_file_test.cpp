#include "simulation/sensor_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "io/error.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr const char* kWhole =
    "# Two lasers.\n"
    "pattern = \"turning\"\n"
    "elevations_deg = [ 1.5,\n"
    "  -20 ]  # the lower one\n"
    "azimuths_deg = [0, 2]\n"
    "origin_heights_m = [0.2, 0.1]\n"
    "columns = 500\n"
    "rate_hz = 5\n"
    "least_range_m = 0.5\n"
    "most_range_m = 40.0\n"
    "noise_m = 0.03\n"
    "bias_m = 0\n"
    "range_step_m = 0.004\n"
    "height_m = 1.2\n"
    "x_m = 0.4\n"
    "y_m = -0.3\n"
    "roll_deg = 180\n"
    "pitch_deg = 10\n"
    "yaw_deg = -90\n";

/// The message about a text, or nothing where it is well.
std::string error_of(const std::string& text) {
  try {
    static_cast<void>(parse_sensor(text, "own.toml"));
  } catch (const io::Error& error) {
    return error.what();
  }
  return {};
}

void expect_error(const std::string& text, const std::string& part) {
  const std::string message = error_of(text);
  EXPECT_NE(message.find("own.toml"), std::string::npos) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(SensorFile, GivesEveryField) {
  const Sensor sensor = parse_sensor(kWhole, "folder/own.toml");
  EXPECT_EQ(sensor.name, "own");
  EXPECT_EQ(sensor.sweep, Sweep::turning);
  ASSERT_EQ(sensor.beams.size(), 2U);
  EXPECT_DOUBLE_EQ(sensor.beams[0].elevation_rad, 1.5 * kRadPerDegree);
  EXPECT_DOUBLE_EQ(sensor.beams[1].elevation_rad, -20.0 * kRadPerDegree);
  EXPECT_DOUBLE_EQ(sensor.beams[1].azimuth_rad, 2.0 * kRadPerDegree);
  EXPECT_DOUBLE_EQ(sensor.beams[0].height_m, 0.2);
  EXPECT_EQ(sensor.columns, 500);
  EXPECT_DOUBLE_EQ(sensor.rate_hz, 5.0);
  EXPECT_DOUBLE_EQ(sensor.least_range_m, 0.5);
  EXPECT_DOUBLE_EQ(sensor.most_range_m, 40.0);
  EXPECT_DOUBLE_EQ(sensor.noise_m, 0.03);
  EXPECT_DOUBLE_EQ(sensor.bias_m, 0.0);
  EXPECT_DOUBLE_EQ(sensor.range_step_m, 0.004);
  EXPECT_DOUBLE_EQ(sensor.mount.height_m, 1.2);
  EXPECT_DOUBLE_EQ(sensor.mount.x_m, 0.4);
  EXPECT_DOUBLE_EQ(sensor.mount.y_m, -0.3);
  EXPECT_DOUBLE_EQ(sensor.mount.roll_rad, 180.0 * kRadPerDegree);
  EXPECT_DOUBLE_EQ(sensor.mount.pitch_rad, 10.0 * kRadPerDegree);
  EXPECT_DOUBLE_EQ(sensor.mount.yaw_rad, -90.0 * kRadPerDegree);
}

TEST(SensorFile, CanBeginWithASensorThatThereIs) {
  const Sensor sensor = parse_sensor("like = \"vlp-16\"  # [\r\nheight_m = 0.6\r\n", "low.toml");
  EXPECT_EQ(sensor.name, "low");
  EXPECT_EQ(sensor.beams.size(), 16U);
  EXPECT_EQ(sensor.columns, 1800);
  EXPECT_DOUBLE_EQ(sensor.mount.height_m, 0.6);
}

TEST(SensorFile, CanDescribeARosette) {
  const Sensor sensor = parse_sensor(
      "pattern = \"rosette\"\ncone_deg = 60\nelevations_deg = [0]\ncolumns = 100\nheight_m = 1\n",
      "own.toml");
  EXPECT_EQ(sensor.sweep, Sweep::rosette);
  EXPECT_DOUBLE_EQ(sensor.cone_rad, 30.0 * kRadPerDegree);
  // The two prisms turn apart: the laser leaves the axis, and never the cone.
  double widest = 0.0;
  for (int column = 0; column < sensor.columns; ++column)
    widest = std::max(widest, std::acos(sensor.direction(sensor.beams[0], column, 7).x()));
  EXPECT_GT(widest, 29.0 * kRadPerDegree);
  EXPECT_LT(widest, 30.5 * kRadPerDegree);
}

TEST(SensorFile, MustSayWhatASensorNeeds) {
  expect_error("", "columns");
  expect_error("columns = 4", "elevations_deg");
  expect_error("columns = 4\nelevations_deg = [0]", "height_m");
  expect_error("columns = 4\nelevations_deg = []\nheight_m = 1", "elevations_deg");
  expect_error("pattern = \"rosette\"", "cone_deg");
}

TEST(SensorFile, NamesTheLineOfAFieldThatCannotBe) {
  expect_error("like = \"vlp-16\"\n\ncolumns = 0\n", "line 3");
  expect_error("like = \"vlp-16\"\ncolumns = 10001", "columns: 1 to 10000");
  expect_error("like = \"vlp-16\"\ncolumns = 2.5", "whole number");
  expect_error("like = \"vlp-16\"\ncolumns = \"many\"", "columns: a number");
  expect_error("like = \"vlp-16\"\nheight_m = nan", "height_m");
  expect_error("like = \"vlp-16\"\nelevations_deg = [0, 91]", "-90 to 90");
  expect_error("like = \"vlp-16\"\nelevations_deg = 3", "elevations_deg: a list of numbers");
  expect_error("like = \"vlp-16\"\nazimuths_deg = [1, 2]", "16 numbers");
  expect_error("like = \"vlp-16\"\norigin_heights_m = [1]", "16 numbers");
  expect_error("like = \"vlp-16\"\nleast_range_m = 90", "less than most_range_m");
  expect_error("like = \"eye\"", "there is no sensor 'eye'");
  expect_error("like = 3", "like: a quoted word");
  expect_error("pattern = \"spiral\"", "turning or rosette");
  expect_error("like = \"vlp-16\"\ncolor = 3", "'color'");
  expect_error("columns = 3\ncolumns = 3", "line 2");
}

TEST(SensorFile, HasNoMoreLasersThanMemoryIsMeantFor) {
  std::string many = "columns = 4\nheight_m = 1\nelevations_deg = [0";
  for (int i = 0; i < 256; ++i) many += ", 0";
  expect_error(many + "]", "at most 256");
}

TEST(SensorFile, IsPlainToml) {
  expect_error("[beams]\nx = 1", "line 1");
  expect_error("a = [1, [2]]", "line 1");
  expect_error("a = {b = 1}", "line 1");
  expect_error("a.b.c = 1", "line 1");
  expect_error("columns", "line 1");
  expect_error("columns = ", "TOML");
  expect_error("x_m = [1,\n2", "ends with ]");
  expect_error("a = [1, \"b\"]", "line 1");
  expect_error("a = 1979-05-27", "line 1");
  expect_error("a = \"\"\"open", "TOML");
  expect_error("like = \"\xff\"", "no sensor '?'");
  expect_error("a = " + std::string(30000, '['), "line 1");
}

TEST(SensorFile, IsShort) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "long.toml", std::string(65537, '#'));
  EXPECT_THROW(read_sensor(folder / "long.toml"), io::Error);
  EXPECT_THROW(read_sensor(folder / "none.toml"), io::Error);
  test::write_file(folder / "own.toml", kWhole);
  EXPECT_EQ(read_sensor(folder / "own.toml").columns, 500);
}

}  // namespace
}  // namespace groundgrid::simulation
