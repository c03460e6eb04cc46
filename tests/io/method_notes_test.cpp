#include "program/method_notes.hpp"

#include <gtest/gtest.h>

namespace groundgrid::program {
namespace {

ScanResult result_with(std::optional<double> height, bool estimated, bool restarted = false) {
  ScanResult result;
  result.sensor_height_m = height;
  result.sensor_height_estimated = estimated;
  result.map_restarted = restarted;
  return result;
}

nlohmann::ordered_json json_of(const MethodNotes& notes) {
  nlohmann::ordered_json written;
  put_notes(written, notes);
  return written;
}

TEST(MethodNotes, SayWhereNoScanHadASensorHeight) {
  MethodNotes notes;
  notes.add(result_with(std::nullopt, false));
  EXPECT_EQ(notes.sensor_words(), "sensor height not found: no flat ground in any scan");
  EXPECT_EQ(json_of(notes)["sensor_height"], nullptr);
}

TEST(MethodNotes, TakeHeightsOnlyFromScansThatHaveOne) {
  MethodNotes notes;
  notes.add(result_with(std::nullopt, false));
  notes.add(result_with(1.75, true));
  notes.add(result_with(std::nullopt, false));
  notes.add(result_with(1.7, true));
  EXPECT_EQ(notes.sensor_words(), "sensor 1.70 to 1.75 m above the ground, estimated scan by scan");
  EXPECT_EQ(json_of(notes)["sensor_height"],
            (nlohmann::ordered_json{{"min_m", 1.7}, {"max_m", 1.75}, {"estimated", true}}));
}

TEST(MethodNotes, AreEstimatedWhereAnyScanIs) {
  MethodNotes notes;
  notes.add(result_with(1.73, false));
  EXPECT_EQ(notes.sensor_words(), "sensor 1.73 m above the ground, as given");
  notes.add(result_with(1.73, true));
  notes.add(result_with(1.73, false));
  EXPECT_EQ(notes.sensor_words(), "sensor 1.73 m above the ground, estimated");
}

TEST(MethodNotes, CountMapRestarts) {
  MethodNotes notes;
  notes.add(result_with(1.73, false));
  EXPECT_EQ(json_of(notes)["map_restarts"], 0);
  notes.add(result_with(1.73, false, true));
  notes.add(result_with(std::nullopt, false, true));
  EXPECT_EQ(json_of(notes)["map_restarts"], 2);
}

}  // namespace
}  // namespace groundgrid::program
