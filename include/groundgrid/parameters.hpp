#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "groundgrid/config.hpp"
#include "groundgrid/export.hpp"

namespace groundgrid {

/// One field of Config: what documentation, flags, files and bindings are made from.
struct Parameter {
  using Field = std::variant<Method*, int*, double*, std::optional<double>*, std::optional<Point2>*,
                             std::optional<Box>*>;

  std::string_view name;    ///< Of the field in Config, unit suffix included.
  Field (*field)(Config&);  ///< Where a Config has it.
  std::string_view unit;    ///< "m", "m²", "deg", "" for a plain number or a name.
  double min = 0.0;         ///< Least value allowed, of each number.
  double max = 0.0;         ///< Greatest value allowed, of each number.
  std::string_view symbol;  ///< The paper's symbol; empty if the paper has none.
  std::string_view group;   ///< "method", or the part of Config that it is in.
  std::string_view text;    ///< One sentence.
};

/// All fields of Config, in the order of the struct.
GROUNDGRID_EXPORT std::span<const Parameter> parameters();

/// Whether a parameter is a name, and whether it can be left out.
GROUNDGRID_EXPORT bool is_name(const Parameter& parameter);
GROUNDGRID_EXPORT bool is_optional(const Parameter& parameter);

/// The numbers that a parameter has: nothing if it is left out or a name.
GROUNDGRID_EXPORT std::vector<double> numbers_of(const Config& config, const Parameter& parameter);

/// The name of a method, as set_parameter() takes it.
GROUNDGRID_EXPORT std::string_view name_of(Method method);

/// The value as set_parameter() takes it, as short as it can be without loss: "0.33", "paper",
/// "none", "[1, 2]".
GROUNDGRID_EXPORT std::string text_of(const Config& config, const Parameter& parameter);

/// A number, likewise: "0.33", "5e-5", "1e6".
GROUNDGRID_EXPORT std::string text_of(double number);

/// Sets one field from text: "0.33", "paper", "none", "1,2" or "[1, 2]". Throws
/// std::invalid_argument with the name and the range if the name is unknown or the text is no value
/// of the field's type. If the name is a former one, the message says what there is now.
GROUNDGRID_EXPORT void set_parameter(Config& config, std::string_view name, std::string_view value);

}  // namespace groundgrid
