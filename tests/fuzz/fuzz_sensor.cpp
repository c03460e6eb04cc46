// Any text as a sensor file: it is a sensor that can be simulated, or refused.
#include <cmath>
#include <string_view>

#include "io/error.hpp"
#include "require.hpp"
#include "simulation/sensor_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace groundgrid;
  try {
    const simulation::Sensor sensor =
        simulation::parse_sensor({reinterpret_cast<const char*>(bytes), size}, "fuzz.toml");
    fuzz::require(!sensor.beams.empty() && sensor.beams.size() <= 256, "it has lasers");
    fuzz::require(sensor.columns > 0 && sensor.columns <= 10000, "it has columns");
    fuzz::require(sensor.least_range_m < sensor.most_range_m, "it has ranges");
    const double length = sensor.direction(sensor.beams.back(), sensor.columns - 1, 1).norm();
    fuzz::require(std::abs(length - 1.0) < 1e-9, "its lasers look somewhere");
    fuzz::require(sensor.T_base_sensor().matrix().allFinite(), "it is somewhere");
  } catch (const io::Error&) {  // A right answer too.
  }
  return 0;
}
