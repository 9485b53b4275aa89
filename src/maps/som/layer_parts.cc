#include "maps/som/layer_parts.h"

#include <cstdint>
#include <utility>
#include <variant>

#include "base/files/toml_file.h"
#include "maps/som/map_parts.h"
#include "somato/core/parameter.h"
#include "somato/core/value.h"
#include "somato/maps/layers.h"

namespace somato {
namespace {

template <typename Field>
std::string line_of(const std::string& key, const std::vector<Layer>& layers, const Field& field) {
  Value::List list;
  for (const Layer& layer : layers) list.push_back({field(layer)});
  return key + " = " + to_toml({std::move(list)}) + "\n";
}

// The list of that key, or an empty one.
Value::List list_of(const Table& table, const std::string& key) {
  const Table::Entry* entry = table.find(key);
  const Value* value = entry ? std::get_if<Value>(&entry->content) : nullptr;
  const auto* list = value ? std::get_if<Value::List>(&value->content) : nullptr;
  return list ? *list : Value::List();
}

double number_of(const Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value.content)) {
    return static_cast<double>(*integer);
  }
  const auto* real = std::get_if<double>(&value.content);
  return real ? *real : 0.0;
}

std::string text_of(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.content);
  return text ? *text : std::string();
}

std::size_t count_of(const Value& value) {
  const auto* integer = std::get_if<std::int64_t>(&value.content);
  return integer && *integer > 0 ? static_cast<std::size_t>(*integer) : 0;
}

}  // namespace

std::string layers_to_toml(const std::vector<Layer>& layers) {
  if (layers.empty()) return {};
  return line_of("layers", layers, [](const Layer& layer) { return layer.name; }) +
         line_of("columns", layers,
                 [](const Layer& layer) { return static_cast<std::int64_t>(layer.count); }) +
         line_of("distances", layers,
                 [](const Layer& layer) { return choice_name(layer.similarity); }) +
         line_of("weights", layers, [](const Layer& layer) { return layer.weight; }) +
         line_of("scales", layers, [](const Layer& layer) { return layer.scale.value_or(0.0); });
}

Result<std::vector<Layer>> layers_from(const Archive& archive, const std::string& name,
                                       std::size_t elements, const std::string& where) {
  if (!archive.find(name)) return std::vector<Layer>();
  const auto damaged = [&] { return damaged_model("'" + name + "' are not layers", where); };
  SOMATO_TRY(const std::string* text, archive.get<std::string>(name, where));
  const Result<Table> table = parse_toml(*text, where);
  if (!table) return damaged();
  const Value::List names = list_of(*table, "layers");
  const Value::List counts = list_of(*table, "columns");
  const Value::List distances = list_of(*table, "distances");
  const Value::List weights = list_of(*table, "weights");
  const Value::List scales = list_of(*table, "scales");
  for (const Value::List* list : {&counts, &distances, &weights, &scales}) {
    if (list->size() != names.size()) return damaged();
  }
  SomParameters parameters;
  std::size_t first = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto similarity = choice_named<Similarity>("distance", text_of(distances[i]), where);
    if (!similarity) return damaged();
    parameters.layers.push_back({text_of(names[i]), first, count_of(counts[i]), *similarity,
                                 number_of(weights[i]), number_of(scales[i])});
    first += parameters.layers.back().count;
  }
  if (names.empty() || !check_layers(parameters, elements)) return damaged();
  return std::move(parameters.layers);
}

}  // namespace somato
