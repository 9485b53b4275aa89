#include "somato/files/json_table.h"

#include <nlohmann/json.hpp>

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Value& value);
Json json_of(const Table& table);

template <typename Content>
Json json_of(const Content& content) {
  return content;
}

template <typename Content>
Json json_of(const std::vector<Content>& list) {
  Json json = Json::array();
  for (const Content& one : list) json.push_back(json_of(one));
  return json;
}

Json json_of(const Value& value) {
  return std::visit([](const auto& content) { return json_of(content); }, value.content);
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
