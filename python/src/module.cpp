#include "bindings.hpp"
#include "groundgrid/version.hpp"

NB_MODULE(_core, module) {
  using namespace groundgrid::python;
  module.doc() = "The C++ core of groundgrid. Its names are public through the package.";
  module.attr("version") = GROUNDGRID_VERSION;
  bind_errors();
  bind_label(module);
  bind_config(module);
  bind_terrain(module);
  bind_ground_grid(module);
  bind_terrain_layers(module);
  bind_drive_terrain(module);
  bind_segmentation_metrics(module);
  bind_terrain_metrics(module);
  bind_simulation(module);
  bind_scan_files(module);
  bind_cloud_files(module);
  bind_output_files(module);
}
