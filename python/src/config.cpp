#include "groundgrid/config.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <string>
#include <variant>

#include "bindings.hpp"
#include "config_values.hpp"
#include "groundgrid/parameters.hpp"
#include "program/parameter_values.hpp"

namespace groundgrid::python {
namespace {

Config preset(const std::string& name) {
  if (name == "default") return Config{};
  if (name == "paper") return Config::paper();
  throw nb::value_error(("preset: expected 'default' or 'paper', got '" + name + "'").c_str());
}

nb::dict values_of(const Config& config) {
  nb::dict values;
  for (const Parameter& parameter : parameters())
    values[parameter.name.data()] = value_of(config, parameter);
  return values;
}

/// Only what is not as in Config().
std::string repr_of_config(const Config& config) {
  std::string text;
  for (const Parameter& parameter : parameters()) {
    const nb::object value = value_of(config, parameter);
    if (value.equal(value_of(Config{}, parameter))) continue;
    text +=
        (text.empty() ? "" : ", ") + std::string(parameter.name) + "=" + nb::repr(value).c_str();
  }
  return "Config(" + text + ")";
}

bool equal(const Config& one, const Config& other) {
  const auto all = parameters();
  return std::all_of(all.begin(), all.end(), [&](const Parameter& parameter) {
    return value_of(one, parameter).equal(value_of(other, parameter));
  });
}

Config from_toml(nb::handle path, const std::string& start) {
  const nb::object text = nb::module_::import_("os").attr("fsdecode")(path);
  Config config = preset(start);
  program::apply_parameter_file(nb::cast<std::string>(text), config);
  return config;
}

std::string doc_of(const Parameter& parameter) {
  std::string text(parameter.text);
  std::string place;
  if (!parameter.symbol.empty()) place = "paper: " + std::string(parameter.symbol);
  if (!parameter.unit.empty()) place += (place.empty() ? "" : ", ") + std::string(parameter.unit);
  return place.empty() ? text : text + " (" + place + ")";
}

void bind_parameter(nb::class_<Config>& config, const Parameter& parameter) {
  const std::string name(parameter.name);
  const std::string getter = "def " + name + "(self) -> " + type_name(parameter);
  const std::string setter = "def " + name + "(self, value: " + type_name(parameter) + ") -> None";
  const std::string doc = doc_of(parameter);
  config.def_prop_rw(
      name.c_str(), [&parameter](const Config& self) { return value_of(self, parameter); },
      [&parameter](Config& self, nb::handle value) {
        Config changed = self;
        set_value(changed, parameter, value);
        changed.validate();
        self = changed;
      },
      nb::for_setter(nb::arg("value").none()), nb::for_getter(nb::sig(getter.c_str())),
      nb::for_setter(nb::sig(setter.c_str())), doc.c_str());
}

void bind_config_class(nb::module_& module) {
  nb::class_<Config> config(
      module, "Config",
      "Every value that the method depends on. Config() is what works best on real scans,\n"
      "Config.paper() follows the paper to the letter. Each parameter is a keyword and an\n"
      "attribute; ValueError names one that is out of its range, TypeError one that is unknown or\n"
      "of another type.");
  const std::string init = "def __init__(self" + keyword_signature(true) + ") -> None";
  config.def(
      "__init__",
      [](Config* self, const nb::kwargs& values) { new (self) Config(with_values({}, values)); },
      nb::sig(init.c_str()), "The default, but for what is given.");
  for (const Parameter& parameter : parameters()) bind_parameter(config, parameter);
  config.def_static("paper", &Config::paper,
                    "The paper's equations and its parameter section, to the letter.");
  config.def_static("preset", &preset, nb::arg("name"),
                    "The preset of that name: 'default' or 'paper'. Raises ValueError for others.");
  config.def_static(
      "from_toml", &from_toml, nb::arg("path"), nb::kw_only(), nb::arg("preset") = "default",
      nb::sig("def from_toml(path: str | os.PathLike[str], *, preset: str = 'default') -> Config"),
      "Reads a parameter file: TOML with a line `name = value` for each parameter that is not as\n"
      "in the preset. `groundgrid params --toml` writes one. Raises FileNotFoundError, and\n"
      "ValueError with the line for what is no parameter or out of range.");
  const std::string replace = "def replace(self" + keyword_signature(false) + ") -> Config";
  config.def(
      "replace",
      [](const Config& self, const nb::kwargs& values) { return with_values(self, values); },
      nb::sig(replace.c_str()), "A copy with other values.");
  config.def("to_dict", &values_of, nb::sig("def to_dict(self) -> dict[str, typing.Any]"),
             "All parameters by name; Config(**values) makes the same configuration of them.");
  config.def("__getstate__", &values_of,
             nb::sig("def __getstate__(self) -> dict[str, typing.Any]"));
  config.def(
      "__setstate__",
      [](Config& self, const nb::dict& values) { new (&self) Config(with_values({}, values)); },
      nb::sig("def __setstate__(self, values: dict[str, typing.Any]) -> None"));
  config.def("__repr__", &repr_of_config);
  config.def(
      "__eq__",
      [](const Config& self, nb::handle other) {
        const Config* known = nullptr;
        return nb::try_cast(other, known) && known != nullptr && equal(self, *known);
      },
      nb::arg("other").none());
  // Its values change.
  config.attr("__hash__") = nb::none();
}

void bind_parameter_class(nb::module_& module) {
  nb::class_<Parameter>(module, "Parameter", "One parameter of Config.")
      .def_prop_ro(
          "name", [](const Parameter& self) { return self.name; }, "As in Config.")
      .def_prop_ro(
          "default", [](const Parameter& self) { return value_of(Config{}, self); },
          nb::sig("def default(self) -> float | str | None"), "What it is in Config().")
      .def_prop_ro(
          "unit", [](const Parameter& self) { return self.unit; }, "'m', 'm²', 'deg', ''.")
      .def_ro("min", &Parameter::min, "Least value allowed.")
      .def_ro("max", &Parameter::max, "Greatest value allowed.")
      .def_prop_ro(
          "symbol", [](const Parameter& self) { return self.symbol; },
          "In the paper; empty where it has none.")
      .def_prop_ro(
          "stage", [](const Parameter& self) { return self.group; },
          "The stage of the method that it belongs to.")
      .def_prop_ro(
          "text", [](const Parameter& self) { return self.text; }, "One sentence.")
      .def("__repr__", [](const Parameter& self) {
        return "Parameter(" + std::string(self.name) + ": " + doc_of(self) + ")";
      });
  module.def(
      "parameters", [] { return std::vector<Parameter>(parameters().begin(), parameters().end()); },
      "All parameters of Config, in its order.");
}

}  // namespace

void bind_config(nb::module_& module) {
  bind_config_class(module);
  bind_parameter_class(module);
}

}  // namespace groundgrid::python
