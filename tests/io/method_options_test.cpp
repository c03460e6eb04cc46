#include "program/method_options.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "groundgrid/parameters.hpp"
#include "io/error.hpp"
#include "program/usage_error.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::program {
namespace {

using test::contains;
using test::message_of;

Config config_from(const std::string& arguments) {
  CLI::App app;
  MethodOptions options;
  options.add_to(app);
  app.parse(arguments);
  return options.config();
}

Config config_from_file(const std::string& toml, const std::string& arguments = "") {
  const test::TemporaryFolder folder;
  test::write_file(folder / "p.toml", toml);
  return config_from("--config " + (folder / "p.toml").string() + " " + arguments);
}

TEST(MethodOptions, StartFromAPreset) {
  EXPECT_EQ(to_json(config_from("")), to_json(Config{}));
  EXPECT_EQ(to_json(config_from("--preset default")), to_json(Config{}));
  EXPECT_EQ(to_json(config_from("--preset paper")), to_json(Config::paper()));
}

TEST(MethodOptions, HaveAFlagForEveryParameter) {
  CLI::App app;
  MethodOptions options;
  options.add_to(app);
  for (const Parameter& parameter : parameters()) {
    std::string flag = "--" + std::string(parameter.name);
    std::replace(flag.begin(), flag.end(), '_', '-');
    EXPECT_NE(app.get_option_no_throw(flag), nullptr) << flag;
  }
}

TEST(MethodOptions, TakeValuesOfEveryKind) {
  const Config config =
      config_from("--sensor-height-m 1.73 --cell-size-m=0.25 --own-vehicle-min-x-m -2 --threads 3");
  EXPECT_EQ(config.sensor_height_m, 1.73);
  EXPECT_EQ(config.cell_size_m, 0.25);
  EXPECT_EQ(config.own_vehicle_min_x_m, -2.0);
  EXPECT_EQ(config.threads, 3);
}

TEST(MethodOptions, LetTheFileWinOverThePresetAndFlagsOverTheFile) {
  const Config config = config_from_file(
      "# for a small robot\ncell_size_m = 0.2  # metres\nmap-extent-m = \"50\"\n\nmin_range_m=1\n",
      "--preset paper --min-range-m 2");
  EXPECT_EQ(config.cell_size_m, 0.2);
  EXPECT_EQ(config.map_extent_m, 50.0);
  EXPECT_EQ(config.min_range_m, 2.0);
  EXPECT_EQ(config.point_angle_deg, Config::paper().point_angle_deg);
}

TEST(MethodOptions, NameWhatIsWrong) {
  EXPECT_TRUE(
      contains(message_of<UsageError>([] { config_from("--cell-size-m 1e9"); }), "cell_size_m"));
  EXPECT_TRUE(contains(message_of<UsageError>([] { config_from_file("cell_size = 1\n"); }),
                       "p.toml, line 1: unknown parameter 'cell_size'"));
  EXPECT_TRUE(contains(message_of<UsageError>([] { config_from_file("[map]\ncell_size_m = 1\n"); }),
                       "[map]: parameters stand at the top level, in no table"));
  EXPECT_TRUE(contains(
      message_of<UsageError>([] { config_from_file("cell_size_m = 1\ncell-size-m = 2\n"); }),
      "p.toml, line 2: cell-size-m is given for the second time"));
  EXPECT_THROW(config_from_file("cell_size_m =\n"), UsageError);
  EXPECT_THROW(config_from_file("cell_size_m = [1, 2]\n"), UsageError);
  EXPECT_THROW(config_from("--config /nowhere/p.toml"), io::Error);
}

TEST(MethodOptions, ComeBackFromJson) {
  const Config before = config_from("--preset paper --sensor-height-m 0.4");
  const nlohmann::ordered_json written = to_json(before);
  Config after;
  for (const auto& [name, value] : written.items())
    if (!value.is_null())
      set_parameter(after, name, value.is_string() ? value.get<std::string>() : value.dump());
  EXPECT_EQ(to_json(after), written);
}

}  // namespace
}  // namespace groundgrid::program
