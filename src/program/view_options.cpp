#include "program/view_options.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>

#include "program/usage_error.hpp"

namespace groundgrid::program {

void ViewOptions::add_to(CLI::App& command, double azimuth_deg, double elevation_deg) {
  point_.azimuth_deg = azimuth_deg;
  point_.elevation_deg = elevation_deg;
  command.add_option("--view", view_, "above or perspective [above]")
      ->check(CLI::IsMember({"above", "perspective"}));
  point_options_ = {
      command
          .add_option("--azimuth-deg", point_.azimuth_deg,
                      fmt::format("Where the perspective looks, degrees to the left of what is up "
                                  "from above [{:g}]",
                                  azimuth_deg))
          ->check(CLI::Range(-360.0, 360.0)),
      command
          .add_option("--elevation-deg", point_.elevation_deg,
                      fmt::format("How steeply it looks down, degrees [{:g}]", elevation_deg))
          ->check(CLI::Range(0.0, 90.0)),
      command
          .add_option("--distance", point_.distance_m,
                      "Metres from the eye to what it looks at [as it fits]")
          ->check(CLI::Range(1.0, 10000.0))};
}

void ViewOptions::check() const {
  if (perspective()) return;
  for (const CLI::Option* option : point_options_)
    if (option->count() > 0) throw UsageError(option->get_name() + " is for --view perspective");
}

}  // namespace groundgrid::program
