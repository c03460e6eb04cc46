#include "config_values.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

namespace groundgrid::python {
namespace {

[[noreturn]] void reject_value(const Parameter& parameter, nb::handle value) {
  throw nb::type_error((std::string(parameter.name) + ": expected " + type_name(parameter) +
                        ", got " + nb::type_name(value.type()).c_str())
                           .c_str());
}

void convert(const Parameter& parameter, nb::handle value, double& number) {
  number = PyBool_Check(value.ptr()) ? -1.0 : PyFloat_AsDouble(value.ptr());
  if (!PyBool_Check(value.ptr()) && PyErr_Occurred() == nullptr) return;
  PyErr_Clear();
  reject_value(parameter, value);
}

void convert(const Parameter& parameter, nb::handle value, std::optional<double>& number) {
  number.reset();
  if (!value.is_none()) convert(parameter, value, number.emplace());
}

void convert(const Parameter& parameter, nb::handle value, int& number) {
  if (PyBool_Check(value.ptr()) || !PyIndex_Check(value.ptr())) reject_value(parameter, value);
  const nb::object index = nb::steal(PyNumber_Index(value.ptr()));
  if (!index.is_valid()) throw nb::python_error();
  if (!nb::try_cast(index, number))
    throw nb::value_error((std::string(parameter.name) + " = " + nb::str(index).c_str() +
                           ": does not fit into 32 bits")
                              .c_str());
}

void convert(const Parameter& parameter, nb::handle value, Method& method) {
  if (!PyUnicode_Check(value.ptr())) reject_value(parameter, value);
  Config config;
  set_parameter(config, parameter.name, nb::cast<std::string>(value));
  method = config.method;
}

const Parameter& parameter_named(std::string_view name) {
  const auto all = parameters();
  const auto found =
      std::find_if(all.begin(), all.end(), [name](const Parameter& p) { return p.name == name; });
  if (found == all.end())
    throw nb::type_error(
        ("unknown parameter '" + std::string(name) + "'; groundgrid.parameters() lists all")
            .c_str());
  return *found;
}

}  // namespace

nb::object value_of(const Config& config, const Parameter& parameter) {
  return std::visit(
      [&config](auto member) -> nb::object {
        const auto& value = config.*member;
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::optional<double>>)
          return value ? nb::cast(*value) : nb::none();
        else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Method>)
          return nb::str(std::string(name_of(value)).c_str());
        else
          return nb::cast(value);
      },
      parameter.member);
}

void set_value(Config& config, const Parameter& parameter, nb::handle value) {
  std::visit([&](auto member) { convert(parameter, value, config.*member); }, parameter.member);
}

Config with_values(Config config, const nb::dict& values) {
  for (const auto& [name, value] : values)
    set_value(config, parameter_named(nb::cast<nb::str>(name).c_str()), value);
  config.validate();
  return config;
}

std::string type_name(const Parameter& parameter) {
  if (std::holds_alternative<int Config::*>(parameter.member)) return "int";
  if (std::holds_alternative<Method Config::*>(parameter.member)) return "str";
  return std::holds_alternative<double Config::*>(parameter.member) ? "float" : "float | None";
}

std::string keyword_signature(bool with_defaults) {
  std::string text = ", *";
  for (const Parameter& parameter : parameters())
    text += ", " + std::string(parameter.name) + ": " + type_name(parameter) + " = " +
            (with_defaults ? nb::repr(value_of(Config{}, parameter)).c_str() : "...");
  return text;
}

}  // namespace groundgrid::python
