#include "studies/description/variation.h"

#include <algorithm>
#include <utility>

#include "somato/core/parameter.h"

namespace somato {
namespace {

constexpr const char* kSystems = "systems";
constexpr const char* kModules = "module";

std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  names.reserve(table.entries.size());
  for (const Table::Entry& entry : table.entries) names.push_back(entry.name);
  return names;
}

Error misfit(const Table::Entry& entry) {
  const bool table = std::holds_alternative<Table>(entry.content);
  return {
      ErrorKind::kUsage,
      "'" + entry.name + "' is " + (table ? "not a table" : "a table") + " in the system's file",
      entry.where,
      table ? "use a value" : "change its keys, for example " + entry.name + ".KEY = ..."};
}

Result<void> change(Table& table, const Table& changes, const std::string& name);

// A table within the one called `parent`.
Result<void> change_table(Table& table, const Table::Entry& entry, const std::string& parent) {
  const auto& changes = std::get<Table>(entry.content);
  for (Table::Entry& present : table.entries) {
    if (present.name != entry.name) continue;
    auto* inner = std::get_if<Table>(&present.content);
    return inner ? change(*inner, changes, entry.name) : fail(misfit(entry));
  }
  if (parent == kModules) {
    return fail(unknown_name("module", entry.name, entry.where, names_of(table)));
  }
  table.entries.push_back(entry);
  return {};
}

Result<void> change_key(Table& table, const Table::Entry& entry) {
  for (Table::Entry& present : table.entries) {
    if (present.name != entry.name) continue;
    if (std::holds_alternative<Table>(present.content)) return fail(misfit(entry));
    present = entry;
    return {};
  }
  table.entries.push_back(entry);
  return {};
}

Result<void> change(Table& table, const Table& changes, const std::string& name) {
  for (const Table::Entry& entry : changes.entries) {
    auto changed = std::holds_alternative<Table>(entry.content) ? change_table(table, entry, name)
                                                                : change_key(table, entry);
    if (!changed) return changed;
  }
  return {};
}

Result<std::vector<std::string>> names_in(const Table::Entry& entry) {
  const auto refuse = [&] {
    return fail(ErrorKind::kUsage, "'systems' must be a list of names", entry.where,
                "write systems = [\"...\"]");
  };
  const Value* value = std::get_if<Value>(&entry.content);
  const auto* list = value ? std::get_if<Value::List>(&value->content) : nullptr;
  if (!list) return refuse();
  std::vector<std::string> names;
  for (const Value& element : *list) {
    const auto* name = std::get_if<std::string>(&element.content);
    if (!name) return refuse();
    names.push_back(*name);
  }
  return names;
}

Result<Variation> read_variation(const Table::Entry& entry) {
  const auto* table = std::get_if<Table>(&entry.content);
  if (!table) {
    return fail(ErrorKind::kUsage, "'" + entry.name + "' must be a table", entry.where,
                "write [variation." + entry.name + "] on a separate line, its changes below");
  }
  Variation variation{entry.name, entry.where, {}, {}};
  variation.changes.where = table->where;
  for (const Table::Entry& change : table->entries) {
    if (change.name != kSystems) {
      variation.changes.entries.push_back(change);
      continue;
    }
    SOMATO_TRY(auto names, names_in(change));
    variation.systems = std::move(names);
  }
  return variation;
}

}  // namespace

Result<std::vector<Variation>> read_variations(const Table& file) {
  std::vector<Variation> variations;
  const Table::Entry* entry = file.find("variation");
  if (!entry) return variations;
  const auto* tables = std::get_if<Table>(&entry->content);
  if (!tables) {
    return fail(ErrorKind::kUsage, "a variation requires a name", entry->where,
                "write [variation.NAME] on a separate line");
  }
  for (const Table::Entry& one : tables->entries) {
    SOMATO_TRY(auto variation, read_variation(one));
    variations.push_back(std::move(variation));
  }
  return variations;
}

Result<Table> with_changes(Table file, const Table& changes) {
  SOMATO_TRY_VOID(change(file, changes, {}));
  return file;
}

}  // namespace somato
