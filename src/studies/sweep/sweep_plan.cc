#include "studies/sweep/sweep_plan.h"

#include <algorithm>
#include <utility>

#include "base/core/contains.h"
#include "base/files/toml_file.h"
#include "somato/graph/module.h"
#include "studies/description/variation.h"

namespace somato {
namespace {

std::vector<std::string> split_key(const std::string& key) {
  std::vector<std::string> names{""};
  for (const char c : key) {
    if (c == '.') {
      names.emplace_back();
    } else {
      names.back() += c;
    }
  }
  return names;
}

// The key as the tables of a file have it, one within the other.
Table::Entry nested(const std::vector<std::string>& names, const std::string& where,
                    const Value& value) {
  Table::Entry entry{names.back(), where, value};
  for (std::size_t i = names.size() - 1; i-- > 0;) {
    Table outer{where, {std::move(entry)}};
    entry = {names[i], where, std::move(outer)};
  }
  return entry;
}

Table changes_at(const SweepDescription& sweep, const SweepPoint& point) {
  Table changes;
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (!point[i]) continue;
    const Unknown& unknown = sweep.unknowns[i];
    for (const std::string& key : unknown.parameters.key) {
      changes.entries.push_back(nested(split_key(key), unknown.where, point[i]->value));
    }
  }
  return changes;
}

// The value of a key in the file; nullptr if there is none.
const Value* value_in(const Table& file, const std::vector<std::string>& names) {
  const Table* table = &file;
  for (std::size_t i = 0; table && i + 1 < names.size(); ++i) table = table_in(*table, names[i]);
  const Table::Entry* entry = table ? table->find(names.back()) : nullptr;
  return entry ? std::get_if<Value>(&entry->content) : nullptr;
}

std::vector<std::string> entry_names(const Table& table) {
  std::vector<std::string> names;
  names.reserve(table.entries.size());
  for (const Table::Entry& entry : table.entries) names.push_back(entry.name);
  return names;
}

// A parameter of a module's type that the file leaves out.
Result<std::string> default_of_module(const Table& file, const std::vector<std::string>& names,
                                      const std::string& where) {
  const Table* modules = table_in(file, "module");
  const Table none;
  const Table& known_modules = modules ? *modules : none;
  const Table* module = names.size() == 3 ? table_in(known_modules, names[1]) : nullptr;
  if (!module) return fail(unknown_name("module", names[1], where, entry_names(known_modules)));
  const Value* type_name = value_in(*module, {"type"});
  const auto* text = type_name ? std::get_if<std::string>(&type_name->content) : nullptr;
  SOMATO_TRY(const auto type, find_module_type(text ? *text : "", module->where));
  std::vector<std::string> known = entry_names(*module);
  for (const ParameterInfo& parameter : type->parameters) {
    if (parameter.name == names[2]) return parameter.default_text;
    known.push_back(parameter.name);
  }
  return fail(unknown_name("key of the module '" + names[1] + "'", names[2], where, known));
}

Result<std::string> own_value(const Table& file, const std::string& key, const std::string& where,
                              const std::map<std::string, std::string>& explore_defaults) {
  const std::vector<std::string> names = split_key(key);
  const bool of_module = names.front() == "module";
  if (names.size() < 2 || (!of_module && names.front() != "explore")) {
    return fail(ErrorKind::kUsage, "'" + key + "' is not a key of a module or of the exploration",
                where, "write module.NAME.PARAMETER, or explore.TABLE.NAME");
  }
  if (const Value* value = value_in(file, names)) return to_toml(*value);
  if (of_module) return default_of_module(file, names, where);
  const auto known = explore_defaults.find(key);
  if (known != explore_defaults.end()) return known->second;
  std::vector<std::string> all;
  all.reserve(explore_defaults.size());
  for (const auto& [name, value] : explore_defaults) all.push_back(name);
  return fail(unknown_name("key", key, where, all));
}

// The values of several keys, each value once.
Result<std::string> own_values_of(const Table& file, const Unknown& unknown,
                                  const std::map<std::string, std::string>& explore_defaults) {
  std::vector<std::string> values;
  for (const std::string& key : unknown.parameters.key) {
    auto value = own_value(file, key, unknown.where, explore_defaults);
    if (!value) return value;
    if (!contains(values, *value)) values.push_back(std::move(*value));
  }
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
  return text;
}

bool is_about_another(const Claim& claim) {
  return claim.compares() && claim.than_system != claim.system;
}

// Claims that compare with another system would need a run of that one.
void take_claims(const ReproductionPlan& plan, SystemSweep& sweep) {
  for (const Claim& claim : plan.claims) {
    if (is_about_another(claim)) {
      sweep.not_judged.push_back(claim.text);
    } else {
      sweep.claims.push_back(claim);
    }
  }
}

bool is_claimed(const std::vector<Claim>& claims, const std::string& variation) {
  return std::any_of(claims.begin(), claims.end(), [&](const Claim& claim) {
    return claim.variation == variation || (claim.compares() && claim.than_variation == variation);
  });
}

}  // namespace

Result<SystemSweep> plan_sweep(const SweepDescription& sweep, const NamedFile& system,
                               const std::map<std::string, std::string>& explore_defaults) {
  if (const Table::Entry* question = system.content.find("question")) {
    return fail(ErrorKind::kUsage, "a sweep requires a system, not a question", question->where,
                "use the name of a system; 'somato systems' lists them");
  }
  SOMATO_TRY(auto changed, with_changes(system.content, sweep.changes));
  SystemSweep planned{{}, sweep, {system.name, std::move(changed)}, {}, {}, {}};
  ReproductionPlan plan;
  SOMATO_TRY_VOID(add_to_plan(planned.file, {}, plan));
  planned.system = plan.parts.front().system;
  for (const Unknown& unknown : sweep.unknowns) {
    SOMATO_TRY(auto own, own_values_of(planned.file.content, unknown, explore_defaults));
    planned.own_values.push_back(std::move(own));
  }
  take_claims(plan, planned);
  if (planned.claims.empty()) {
    return fail(ErrorKind::kUsage, "the system has no claims that a sweep could evaluate",
                plan.parts.front().description.where,
                "add a table [[claim]] to its file, or to that of the sweep");
  }
  return planned;
}

Result<ReproductionPlan> plan_of_point(const SystemSweep& sweep, const SweepPoint& point) {
  SOMATO_TRY(const auto file, with_changes(sweep.file.content, changes_at(sweep.sweep, point)));
  ReproductionPlan plan;
  SOMATO_TRY_VOID(add_to_plan({sweep.file.name, file}, {}, plan));
  plan.claims = sweep.claims;
  std::erase_if(plan.parts, [&](const ReproductionPart& part) {
    return !is_claimed(sweep.claims, part.variation);
  });
  return plan;
}

std::string name_of_point(const SweepDescription& sweep, const SweepPoint& point) {
  std::string name;
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (!point[i]) continue;
    name += (name.empty() ? "" : ", ") + sweep.unknowns[i].name + " = " + to_toml(point[i]->value);
  }
  return name.empty() ? "the unchanged system" : name;
}

}  // namespace somato
