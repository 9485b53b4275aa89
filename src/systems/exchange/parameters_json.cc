#include "systems/exchange/parameters_json.h"

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/text/json_text.h"
#include "base/text/value_json.h"
#include "maps/som/map_parts.h"

namespace somato {
namespace {

// Parameters are single values.
std::optional<Value> value_of(const nlohmann::ordered_json& json) {
  if (json.is_boolean()) return Value{json.get<bool>()};
  if (json.is_string()) return Value{json.get<std::string>()};
  if (json.is_number_float()) return Value{json.get<double>()};
  if (!json.is_number_integer()) return {};
  const bool is_large = json.is_number_unsigned() &&
                        json.get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max();
  return is_large ? std::optional<Value>() : Value{json.get<std::int64_t>()};
}

}  // namespace

std::string parameters_to_json(const SomParameters& parameters) {
  auto json = nlohmann::ordered_json::object();
  for (const Parameter<SomParameters>& one : SomParameters::declarations().all()) {
    json[one.info.name] = to_json_value(one.read(parameters));
  }
  return json.dump();
}

Result<SomParameters> som_parameters_from_json(std::string_view text, const std::string& where) {
  SOMATO_TRY(const auto json, parse_json<nlohmann::ordered_json>(text, where, "export it again"));
  if (!json.is_object()) return damaged_model("the parameters are not a JSON object", where);
  Table table{where, {}};
  for (const auto& [name, content] : json.items()) {
    auto value = value_of(content);
    if (!value) return damaged_model("the parameter '" + name + "' is not a single value", where);
    table.entries.push_back({name, where, std::move(*value)});
  }
  auto parameters = read_parameters<SomParameters>(table);
  if (!parameters) return damaged_model(std::move(parameters.error()), where);
  return parameters;
}

}  // namespace somato
