#include "groundgrid/label.hpp"

#include "bindings.hpp"

namespace groundgrid::python {

void bind_label(nb::module_& module) {
  nb::enum_<Label>(module, "Label", nb::is_arithmetic(),
                   "The answer for one point. An IntEnum, to compare label arrays with.")
      .value("UNKNOWN", Label::unknown,
             "No answer: NaN or infinite point, a ray without a return, outside the map, too near "
             "to the sensor or on the own vehicle.")
      .value("GROUND", Label::ground, "On the terrain surface.")
      .value("OBSTACLE", Label::obstacle, "Above the terrain surface.")
      .value("OUTLIER", Label::outlier,
             "Without a line of sight from the sensor: a reflection below the ground.");
}

}  // namespace groundgrid::python
