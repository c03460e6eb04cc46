#include "simulation/scene.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

struct Entry {
  std::string_view name;
  double speed_mps;
  Scene (*make)(std::uint64_t seed, double length_m);
};

constexpr std::array kEntries{Entry{"urban", 10.0, make_urban}, Entry{"hill", 10.0, make_hill},
                              Entry{"motorway", 20.0, make_motorway},
                              Entry{"village", 10.0, make_village},
                              Entry{"offroad", 10.0, make_offroad}};

const Entry& entry(const std::string& name) {
  const auto* const found = std::find_if(kEntries.begin(), kEntries.end(),
                                         [&](const Entry& each) { return each.name == name; });
  if (found == kEntries.end()) throw std::invalid_argument("there is no scene '" + name + "'");
  return *found;
}

}  // namespace

const std::vector<std::string>& scene_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all(kEntries.size());
    std::transform(kEntries.begin(), kEntries.end(), all.begin(),
                   [](const Entry& each) { return std::string(each.name); });
    return all;
  }();
  return names;
}

double scene_speed_mps(const std::string& name) { return entry(name).speed_mps; }

Scene make_scene(const std::string& name, std::uint64_t seed, double length_m) {
  const Entry& found = entry(name);
  Scene scene = found.make(seed, length_m);
  scene.speed_mps = found.speed_mps;
  return scene;
}

}  // namespace groundgrid::simulation
