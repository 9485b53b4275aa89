#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/files/toml_file.h"
#include "somato/core/check.h"

namespace {

void check(const somato::Table& table);

struct ContentCheck {
  // A value reads back when it is written; compared as text, for a NaN is not itself.
  void operator()(const somato::Value& value) const {
    const std::string text = somato::to_toml(value);
    const somato::Result<somato::Table> again = somato::parse_toml("v = " + text, "again");
    SOMATO_ASSERT(again);
    const auto* read = std::get_if<somato::Value>(&again->entries.at(0).content);
    SOMATO_ASSERT(read && somato::to_toml(*read) == text);
  }
  void operator()(const somato::Table& table) const { check(table); }
  void operator()(const std::vector<somato::Table>& tables) const {
    for (const somato::Table& table : tables) check(table);
  }
};

void check(const somato::Table& table) {
  SOMATO_ASSERT(table.where.starts_with("input"));
  for (const somato::Table::Entry& entry : table.entries) {
    SOMATO_ASSERT(entry.where.starts_with("input:"));
    SOMATO_ASSERT(table.find(entry.name) == &entry);
    std::visit(ContentCheck{}, entry.content);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const somato::Result<somato::Table> table = somato::parse_toml(text, "input");
  if (table) check(*table);
  if (!table) SOMATO_ASSERT(table.error().where.starts_with("input"));
  return 0;
}
