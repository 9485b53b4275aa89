#include "base/text/value_json.h"

#include <variant>
#include <vector>

namespace somato {
namespace {

template <typename Content>
nlohmann::ordered_json content_json(const Content& content) {
  return content;
}

nlohmann::ordered_json content_json(const Value::List& list) {
  auto json = nlohmann::ordered_json::array();
  for (const Value& one : list) json.push_back(to_json_value(one));
  return json;
}

}  // namespace

nlohmann::ordered_json to_json_value(const Value& value) {
  return std::visit([](const auto& content) { return content_json(content); }, value.content);
}

}  // namespace somato
