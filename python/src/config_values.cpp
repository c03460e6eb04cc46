#include "config_values.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace groundgrid::python {
namespace {

[[noreturn]] void reject_value(const Parameter& parameter, nb::handle value) {
  throw nb::type_error((std::string(parameter.name) + ": expected " + type_name(parameter) +
                        ", got " + nb::type_name(value.type()).c_str())
                           .c_str());
}

/// Sets fields from Python's values, each kind its own way, without a look at the range.
struct Convert {
  const Parameter& parameter;
  nb::handle value;

  void operator()(double* number) const {
    *number = PyBool_Check(value.ptr()) ? -1.0 : PyFloat_AsDouble(value.ptr());
    if (!PyBool_Check(value.ptr()) && PyErr_Occurred() == nullptr) return;
    PyErr_Clear();
    reject_value(parameter, value);
  }

  void operator()(int* number) const {
    if (PyBool_Check(value.ptr()) || !PyIndex_Check(value.ptr())) reject_value(parameter, value);
    const nb::object index = nb::steal(PyNumber_Index(value.ptr()));
    if (!index.is_valid()) throw nb::python_error();
    if (!nb::try_cast(index, *number))
      throw nb::value_error((std::string(parameter.name) + " = " + nb::str(index).c_str() +
                             ": does not fit into 32 bits")
                                .c_str());
  }

  void operator()(Method* method) const {
    if (!PyUnicode_Check(value.ptr())) reject_value(parameter, value);
    Config config;
    set_parameter(config, parameter.name, nb::cast<std::string>(value));
    *method = config.method;
  }

  template <std::size_t Count>
  void operator()(std::array<double, Count>* numbers) const {
    if (PyUnicode_Check(value.ptr()) || !nb::try_cast(value, *numbers))
      reject_value(parameter, value);
  }

  template <typename Value>
  void operator()(std::optional<Value>* field) const {
    field->reset();
    if (!value.is_none()) (*this)(&field->emplace());
  }
};

/// Says what there is instead of a former name.
std::string complaint_about(std::string_view name) {
  try {
    Config config;
    set_parameter(config, name, "");
  } catch (const std::invalid_argument& error) {
    return std::string(error.what()) + "; groundgrid.parameters() lists all";
  }
  return std::string(name);
}

const Parameter& parameter_named(std::string_view name) {
  const auto all = parameters();
  const auto found =
      std::find_if(all.begin(), all.end(), [name](const Parameter& p) { return p.name == name; });
  if (found == all.end()) throw nb::type_error(complaint_about(name).c_str());
  return *found;
}

}  // namespace

nb::object value_of(const Config& config, const Parameter& parameter) {
  if (is_name(parameter)) return nb::str(std::string(name_of(config.method)).c_str());
  const std::vector<double> numbers = numbers_of(config, parameter);
  if (numbers.empty()) return nb::none();
  if (type_name(parameter) == "int") return nb::cast(static_cast<int>(numbers.front()));
  if (numbers.size() == 1) return nb::cast(numbers.front());
  return nb::tuple(nb::cast(numbers));
}

void set_value(Config& config, const Parameter& parameter, nb::handle value) {
  std::visit(Convert{parameter, value}, parameter.field(config));
}

Config with_values(Config config, const nb::dict& values) {
  for (const auto& [name, value] : values)
    set_value(config, parameter_named(nb::cast<nb::str>(name).c_str()), value);
  config.validate();
  return config;
}

std::string type_name(const Parameter& parameter) {
  struct TypeName {
    std::string operator()(const Method* /*method*/) const { return "str"; }
    std::string operator()(const int* /*number*/) const { return "int"; }
    std::string operator()(const double* /*number*/) const { return "float"; }
    std::string operator()(const Point2* /*place*/) const { return "tuple[float, float]"; }
    std::string operator()(const Box* /*box*/) const {
      return "tuple[float, float, float, float, float, float]";
    }
    std::string operator()(const std::optional<double>* /*number*/) const { return "float | None"; }
    std::string operator()(const std::optional<Point2>* /*place*/) const {
      return (*this)(static_cast<Point2*>(nullptr)) + " | None";
    }
    std::string operator()(const std::optional<Box>* /*box*/) const {
      return (*this)(static_cast<Box*>(nullptr)) + " | None";
    }
  };
  Config config;
  return std::visit(TypeName{}, parameter.field(config));
}

std::string keyword_signature(bool with_defaults) {
  std::string text = ", *";
  for (const Parameter& parameter : parameters())
    text += ", " + std::string(parameter.name) + ": " + type_name(parameter) + " = " +
            (with_defaults ? nb::repr(value_of(Config{}, parameter)).c_str() : "...");
  return text;
}

}  // namespace groundgrid::python
