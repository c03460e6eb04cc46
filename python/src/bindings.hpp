#pragma once

#include <nanobind/nanobind.h>
// A source that forgot the next one would only fail when it is called.
#include <nanobind/stl/string.h>

namespace groundgrid::python {

namespace nb = nanobind;

// Each adds its part to the module; a part stands after those whose types its signatures name.
void bind_errors();
void bind_label(nb::module_& module);
void bind_config(nb::module_& module);
void bind_terrain(nb::module_& module);
void bind_ground_grid(nb::module_& module);
void bind_terrain_layers(nb::module_& module);
void bind_drive_terrain(nb::module_& module);
void bind_segmentation_metrics(nb::module_& module);
void bind_terrain_metrics(nb::module_& module);
void bind_simulation(nb::module_& module);
void bind_scan_files(nb::module_& module);
void bind_cloud_files(nb::module_& module);
void bind_output_files(nb::module_& module);

}  // namespace groundgrid::python
