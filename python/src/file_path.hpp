#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <filesystem>
#include <string>

namespace groundgrid::python {

namespace nb = nanobind;

/// A path from str or os.PathLike. Throws TypeError for all else.
inline std::filesystem::path path_from(nb::handle path) {
  return nb::cast<std::string>(nb::module_::import_("os").attr("fsdecode")(path));
}

}  // namespace groundgrid::python
