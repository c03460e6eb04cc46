#pragma once

#include <nanobind/nanobind.h>

#include <filesystem>
#include <string_view>

namespace groundgrid::python {

namespace nb = nanobind;

/// A path from str, bytes or os.PathLike, whatever bytes are in it. Throws TypeError for all else.
inline std::filesystem::path path_from(nb::handle path) {
  const nb::bytes name(nb::module_::import_("os").attr("fsencode")(path));
  return std::string_view(name.c_str(), name.size());
}

/// The same as Python has names: with bytes that are no text, too.
inline nb::object name_of_path(const std::filesystem::path& path) {
  return nb::module_::import_("os").attr("fsdecode")(nb::bytes(path.c_str()));
}

}  // namespace groundgrid::python
