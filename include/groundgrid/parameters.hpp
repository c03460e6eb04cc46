#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "groundgrid/config.hpp"
#include "groundgrid/export.hpp"

namespace groundgrid {

/// One field of Config: what documentation, flags, files and bindings are made from.
struct Parameter {
  using Member = std::variant<double Config::*, std::optional<double> Config::*, int Config::*,
                              Method Config::*>;

  std::string_view name;    ///< As in Config, unit suffix included.
  Member member;            ///< Where it lives.
  std::string_view unit;    ///< "m", "m²", "deg", "" for a plain number or a name.
  double min = 0.0;         ///< Least value allowed.
  double max = 0.0;         ///< Greatest value allowed.
  std::string_view symbol;  ///< The paper's symbol; empty where the paper has none.
  std::string_view group;   ///< The stage it belongs to.
  std::string_view text;    ///< One sentence.
};

/// All fields of Config, in the order of the struct.
GROUNDGRID_EXPORT std::span<const Parameter> parameters();

/// The name of a method, as set_parameter() takes it.
GROUNDGRID_EXPORT std::string_view name_of(Method method);

/// Sets one field from text ("0.33", "paper", "none"). Throws std::invalid_argument with the name
/// and the range where the name is unknown or the text is no value of the field's type.
GROUNDGRID_EXPORT void set_parameter(Config& config, std::string_view name, std::string_view value);

}  // namespace groundgrid
