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
  const Config config = config_from(
      "--sensor-height-m 1.73 --resolution-m=0.25 --ego-vehicle-box-m -2,3,-1,1,-2,0.5");
  EXPECT_EQ(config.vehicle.sensor_height_m, 1.73);
  EXPECT_EQ(config.map.resolution_m, 0.25);
  EXPECT_EQ(config.vehicle.ego_vehicle_box_m, (Box{-2.0, 3.0, -1.0, 1.0, -2.0, 0.5}));
}

TEST(MethodOptions, LetTheFileWinOverThePresetAndFlagsOverTheFile) {
  const Config config = config_from_file(
      "# for a small robot\nresolution_m = 0.2  # metres\nextent-m = \"50\"\n\nmin_range_m=1\n",
      "--preset paper --min-range-m 2");
  EXPECT_EQ(config.map.resolution_m, 0.2);
  EXPECT_EQ(config.map.extent_m, 50.0);
  EXPECT_EQ(config.vehicle.min_range_m, 2.0);
  EXPECT_EQ(config.paper_only.azimuth_resolution_deg,
            Config::paper().paper_only.azimuth_resolution_deg);
}

TEST(MethodOptions, NameWhatIsWrong) {
  EXPECT_TRUE(
      contains(message_of<UsageError>([] { config_from("--resolution-m 1e9"); }), "resolution_m"));
  EXPECT_TRUE(contains(message_of<UsageError>([] { config_from_file("cell_size = 1\n"); }),
                       "p.toml, line 1: unknown parameter 'cell_size'"));
  EXPECT_TRUE(
      contains(message_of<UsageError>([] { config_from_file("[map]\nresolution_m = 1\n"); }),
               "[map]: parameters stand at the top level, in no table"));
  EXPECT_TRUE(contains(
      message_of<UsageError>([] { config_from_file("resolution_m = 1\nresolution-m = 2\n"); }),
      "p.toml, line 2: resolution-m is given for the second time"));
  EXPECT_THROW(config_from_file("resolution_m =\n"), UsageError);
  EXPECT_THROW(config_from_file("resolution_m = [1, 2]\n"), UsageError);
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
