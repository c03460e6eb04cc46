#include "groundgrid/parameters.hpp"
#include "program/method_options.hpp"
#include "program/parameter_listing.hpp"
#include "program/parameter_words.hpp"

namespace groundgrid::program {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

nlohmann::ordered_json parameter_json(const Config& config) {
  const Json values = to_json(config);
  Json list = Json::array();
  for (const Parameter& parameter : parameters()) {
    const std::string name(parameter.name);
    list.push_back({{"name", name},
                    {"value", values[name]},
                    {"unit", parameter.unit},
                    {"min", is_name(parameter) ? Json(nullptr) : Json(parameter.min)},
                    {"max", is_name(parameter) ? Json(nullptr) : Json(parameter.max)},
                    {"optional", is_optional(parameter)},
                    {"symbol", parameter.symbol.empty() ? Json(nullptr) : Json(parameter.symbol)},
                    {"stage", parameter.group},
                    {"text", parameter.text}});
  }
  return list;
}

}  // namespace groundgrid::program
