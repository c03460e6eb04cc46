#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "rendering/view_point.hpp"

namespace groundgrid::program {

/// The flags that say from where something is seen.
class ViewOptions {
 public:
  /// `azimuth` and `elevation` hold where nothing else is said. The object must stay where it is
  /// until parsing is over.
  void add_to(CLI::App& command, double azimuth_deg, double elevation_deg);

  [[nodiscard]] bool perspective() const { return view_ == "perspective"; }
  [[nodiscard]] const rendering::ViewPoint& point() const { return point_; }
  /// Throws UsageError where flags that belong to a perspective are given without one.
  void check() const;

 private:
  std::string view_ = "above";
  rendering::ViewPoint point_{};
  std::vector<CLI::Option*> point_options_;
};

}  // namespace groundgrid::program
