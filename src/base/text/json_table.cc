#include "base/text/json_table.h"

#include "base/text/value_json.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Table& table);

Json json_of(const Value& value) {
  return to_json_value(value);
}

Json json_of(const std::vector<Table>& tables) {
  Json json = Json::array();
  for (const Table& one : tables) json.push_back(json_of(one));
  return json;
}

Json json_of(const Table& table) {
  Json json = Json::object();
  for (const Table::Entry& entry : table.entries) {
    json[entry.name] =
        std::visit([](const auto& content) { return json_of(content); }, entry.content);
  }
  return json;
}

}  // namespace

std::string to_json(const Table& table) {
  constexpr int kIndent = 2;
  return json_of(table).dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace somato
