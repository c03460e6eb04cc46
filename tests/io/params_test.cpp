// `groundgrid params` as users run it.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "groundgrid/parameters.hpp"
#include "program/method_options.hpp"
#include "run_program.hpp"

namespace groundgrid::program {
namespace {

using nlohmann::json;
using test::contains;
using test::run_program;

std::string output_of(const std::string& arguments) {
  const test::ProgramRun run = run_program("params " + arguments);
  EXPECT_EQ(run.exit_code, 0) << run.words;
  EXPECT_EQ(run.words, "");
  return run.output;
}

Config preset_named(const std::string& preset) {
  return preset == "paper" ? Config::paper() : Config{};
}

class ParamsOfPreset : public ::testing::TestWithParam<const char*> {};

TEST_P(ParamsOfPreset, ComeBackFromTheirToml) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "p.toml", output_of(std::string("--toml --preset ") + GetParam()));
  // Over the other preset, so that a line left out shows.
  for (const char* const start : {"default", "paper"}) {
    CLI::App app;
    MethodOptions options;
    options.add_to(app);
    app.parse("--preset " + std::string(start) + " --config " + (folder / "p.toml").string());
    EXPECT_EQ(to_json(options.config()), to_json(preset_named(GetParam()))) << start;
  }
}

TEST_P(ParamsOfPreset, HaveTheirValuesInJson) {
  const json list = json::parse(output_of(std::string("--json --preset ") + GetParam()));
  const auto values = to_json(preset_named(GetParam()));
  ASSERT_EQ(list.size(), parameters().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Parameter& parameter = parameters()[i];
    EXPECT_EQ(list[i]["name"], parameter.name);
    EXPECT_EQ(json(list[i]["value"]).dump(), values[std::string(parameter.name)].dump());
    EXPECT_EQ(list[i]["unit"], parameter.unit);
    EXPECT_EQ(list[i]["stage"], parameter.group);
    EXPECT_EQ(list[i]["text"], parameter.text);
  }
}

TEST_P(ParamsOfPreset, AreATableOfAHundredColumns) {
  std::istringstream table(output_of(std::string("--preset ") + GetParam()));
  std::string line;
  while (std::getline(table, line)) {
    const auto letters = std::count_if(line.begin(), line.end(), [](char byte) {
      return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    });
    EXPECT_LE(letters, 100) << line;
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, ParamsOfPreset, ::testing::Values("default", "paper"));

TEST(Params, AreListedByStageWithUnitRangeAndSymbol) {
  const std::string table = output_of("--preset paper");
  EXPECT_TRUE(contains(table, "preset paper"));
  EXPECT_TRUE(contains(table, "\nOf the paper's method alone\n"));
  const auto begin = table.find("\nvariance_distance_factor ");
  ASSERT_NE(begin, std::string::npos);
  std::istringstream row(table.substr(begin));
  std::string name, value, unit, least, to, greatest, symbol;
  row >> name >> value >> unit >> least >> to >> greatest >> symbol;
  EXPECT_EQ(value, "1e-5");
  EXPECT_EQ(unit, "m");
  EXPECT_EQ(least + to + greatest, "0to1");
  EXPECT_EQ(symbol, "d_sf");
  for (const Parameter& parameter : parameters())
    EXPECT_TRUE(contains(table, "\n" + std::string(parameter.name) + " "));
}

TEST(Params, ExplainThemselvesInToml) {
  const std::string toml = output_of("--toml");
  EXPECT_TRUE(contains(toml,
                       "\n# Decay of confidence if a scan shows no ground (eq. 8).\n"
                       "# 1 to 1e9; the paper's θ\nconfidence_decay = 5\n"));
  EXPECT_TRUE(contains(toml, "\n# m, -10 to 100, or \"none\"\n# sensor_height_m = \"none\"\n"));
  EXPECT_TRUE(contains(toml, "\nmethod = \"standard\"\n"));
  EXPECT_TRUE(contains(toml, "# anchor_m = \"none\"\n"));
}

TEST(Params, HaveRangesInJson) {
  for (const json& parameter : json::parse(output_of("--json"))) {
    if (parameter["name"] == "sensor_height_m") {
      EXPECT_EQ(parameter["value"], nullptr);
      EXPECT_EQ(parameter["optional"], true);
      EXPECT_EQ(parameter["min"], -10.0);
      EXPECT_EQ(parameter["symbol"], nullptr);
    }
    if (parameter["name"] == "method") {
      EXPECT_EQ(parameter["value"], "standard");
      EXPECT_EQ(parameter["max"], nullptr);
    }
    if (parameter["name"] == "confidence_decay") {
      EXPECT_EQ(parameter["symbol"], "θ");
    }
  }
}

TEST(Params, AreThePageInDocs) {
  EXPECT_EQ(output_of("--markdown"), test::read_file(GROUNDGRID_SOURCE_DIR "/docs/parameters.md"))
      << "run: build/release/src/program/groundgrid params --markdown >docs/parameters.md";
}

TEST(Params, HaveBothPresetsOnThePage) {
  const std::string page = output_of("--markdown");
  EXPECT_TRUE(contains(page, "\n| `ground_threshold_m` | 0.2 | **0.3** | m | 0 to 10 | h_g | "));
  EXPECT_TRUE(contains(page, "\n| `resolution_m` | 0.33 | 0.33 | m | 0.02 to 10 | R | "));
}

TEST(Params, TakeOneFormAtATime) {
  for (const char* const both : {"--toml --json", "--json --markdown", "--toml --markdown",
                                 "--preset paper --markdown", "--preset best"}) {
    const test::ProgramRun run = run_program(std::string("params ") + both);
    EXPECT_EQ(run.exit_code, 2) << both;
    EXPECT_EQ(run.output, "") << both;
  }
}

}  // namespace
}  // namespace groundgrid::program
