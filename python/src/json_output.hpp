#pragma once

#include <nanobind/nanobind.h>

#include <nlohmann/json.hpp>

namespace groundgrid::python {

namespace nb = nanobind;

/// The same as dicts, lists, numbers and None.
inline nb::object to_python(const nlohmann::ordered_json& json) {
  return nb::module_::import_("json").attr("loads")(json.dump());
}

}  // namespace groundgrid::python
