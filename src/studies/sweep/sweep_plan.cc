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

bool has_module(const Table& file, const std::string& name) {
  const Table* modules = table_in(file, "module");
  return modules && table_in(*modules, name);
}

std::string name_of_system(const Table& file) {
  const Table* study = table_in(file, "study");
  const Table::Entry* name = study ? study->find("name") : nullptr;
  const auto* value = name ? std::get_if<Value>(&name->content) : nullptr;
  const auto* text = value ? std::get_if<std::string>(&value->content) : nullptr;
  return text ? *text : "";
}

// Whether a key is of the exploration, or of a module that the system has.
bool is_of_system(const Table& file, const std::vector<std::string>& names) {
  return names.size() < 2 || names.front() != "module" || has_module(file, names[1]);
}

Table changes_at(const SweepDescription& sweep, const SweepPoint& point, const Table& file) {
  Table changes;
  const std::string system = name_of_system(file);
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (!point[i] || !sweep.unknowns[i].parameters.is_of(system)) continue;
    const Unknown& unknown = sweep.unknowns[i];
    for (const std::string& key : unknown.parameters.key) {
      const std::vector<std::string> names = split_key(key);
      if (!is_of_system(file, names)) continue;
      changes.entries.push_back(nested(names, unknown.where, point[i]->value));
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

bool any_has(const std::vector<NamedFile>& files, const std::vector<std::string>& names) {
  return std::any_of(files.begin(), files.end(),
                     [&](const NamedFile& file) { return is_of_system(file.content, names); });
}

// The values of several keys in all systems, each value once.
Result<std::string> own_values_of(const std::vector<NamedFile>& files, const Unknown& unknown,
                                  const std::map<std::string, std::string>& explore_defaults) {
  std::vector<std::string> values;
  for (const std::string& key : unknown.parameters.key) {
    const bool is_known = any_has(files, split_key(key));
    for (const NamedFile& file : files) {
      if (is_known && !is_of_system(file.content, split_key(key))) continue;
      if (!unknown.parameters.is_of(name_of_system(file.content))) continue;
      auto value = own_value(file.content, key, unknown.where, explore_defaults);
      if (!value) return value;
      if (!contains(values, *value)) values.push_back(std::move(*value));
    }
  }
  if (values.empty()) {
    return fail(ErrorKind::kUsage,
                "the unknown '" + unknown.name + "' has no effect on any of its systems",
                unknown.where, "name systems that have its keys");
  }
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
  return text;
}

Result<void> check_names_of_systems(const Unknown& unknown,
                                    const std::vector<std::string>& systems) {
  for (const std::string& system : unknown.parameters.systems) {
    if (contains(systems, system)) continue;
    return fail(unknown_name("system of the sweep", system, unknown.where, systems));
  }
  return {};
}

Result<void> take_own_values(const std::map<std::string, std::string>& explore_defaults,
                             SystemSweep& sweep) {
  for (const Unknown& unknown : sweep.sweep.unknowns) {
    SOMATO_TRY_VOID(check_names_of_systems(unknown, sweep.systems));
    SOMATO_TRY(auto own, own_values_of(sweep.files, unknown, explore_defaults));
    sweep.own_values.push_back(std::move(own));
  }
  return {};
}

// Claims that compare with another system need a run of that one.
void take_claims(const ReproductionPlan& plan, SystemSweep& sweep) {
  for (const Claim& claim : plan.claims) {
    if (claim.compares() && !contains(sweep.systems, claim.than_system)) {
      sweep.not_judged.push_back(claim.text);
    } else {
      sweep.claims.push_back(claim);
    }
  }
}

bool is_about(const Claim& claim, const ReproductionPart& part) {
  return (claim.system == part.system && claim.variation == part.variation) ||
         (claim.compares() && claim.than_system == part.system &&
          claim.than_variation == part.variation);
}

bool is_needed(const SystemSweep& sweep, const ReproductionPart& part) {
  const auto needs = [&](const Claim& claim) { return is_about(claim, part); };
  return std::any_of(sweep.claims.begin(), sweep.claims.end(), needs) ||
         std::any_of(sweep.measured.begin(), sweep.measured.end(), needs);
}

// The changes of the sweep without modules that only other systems have.
Table changes_for(const Table& changes, const NamedFile& system,
                  const std::vector<NamedFile>& all) {
  Table own = changes;
  for (Table::Entry& entry : own.entries) {
    auto* modules = entry.name == "module" ? std::get_if<Table>(&entry.content) : nullptr;
    if (!modules) continue;
    std::erase_if(modules->entries, [&](const Table::Entry& one) {
      const std::vector<std::string> names{"module", one.name};
      return !is_of_system(system.content, names) && any_has(all, names);
    });
  }
  return own;
}

Result<void> check_systems(const SweepDescription& sweep, const std::vector<NamedFile>& systems) {
  if (systems.empty()) return fail(ErrorKind::kUsage, "a sweep requires a system", "", "name one");
  for (const NamedFile& system : systems) {
    const Table::Entry* question = system.content.find("question");
    if (!question) continue;
    return fail(ErrorKind::kUsage, "a sweep requires a system, not a question", question->where,
                "use the name of a system; 'somato systems' lists them");
  }
  const Table::Entry* claim = sweep.changes.find("claim");
  if (!claim || systems.size() == 1) return {};
  return fail(ErrorKind::kUsage, "the claims of a sweep would be those of each of its systems",
              claim->where, "write [[claim]] in the files of the systems, or sweep one system");
}

// Adds the system, with the changes of the sweep.
Result<void> add_system(const NamedFile& system, const std::vector<NamedFile>& all,
                        SystemSweep& planned, ReproductionPlan& plan) {
  SOMATO_TRY(auto changed,
             with_changes(system.content, changes_for(planned.sweep.changes, system, all)));
  const std::size_t first = plan.parts.size();
  planned.files.push_back({system.name, std::move(changed)});
  SOMATO_TRY_VOID(add_to_plan(planned.files.back(), {}, plan));
  const ReproductionPart& part = plan.parts[first];
  if (contains(planned.systems, part.system)) {
    return fail(ErrorKind::kUsage, "two systems are called '" + part.system + "'",
                part.description.where, "sweep one of them, or change the name of a study");
  }
  planned.systems.push_back(part.system);
  return {};
}

}  // namespace

std::string names_of(const SystemSweep& sweep) {
  std::string names;
  for (const std::string& system : sweep.systems) names += (names.empty() ? "" : ", ") + system;
  return names;
}

Result<SystemSweep> plan_sweep(const SweepDescription& sweep, const std::vector<NamedFile>& systems,
                               const std::map<std::string, std::string>& explore_defaults) {
  SOMATO_TRY_VOID(check_systems(sweep, systems));
  SystemSweep planned{{}, sweep, {}, {}, {}, {}};
  ReproductionPlan plan;
  for (const NamedFile& system : systems) {
    SOMATO_TRY_VOID(add_system(system, systems, planned, plan));
  }
  SOMATO_TRY_VOID(take_own_values(explore_defaults, planned));
  take_claims(plan, planned);
  if (planned.claims.empty()) {
    return fail(ErrorKind::kUsage, "the system has no claims that a sweep could evaluate",
                plan.parts.front().description.where,
                "add a table [[claim]] to its file, or to that of the sweep");
  }
  return planned;
}

Result<SystemSweep> plan_body_sweep(const SweepDescription& sweep, const NamedFile& body,
                                    const std::map<std::string, std::string>& explore_defaults) {
  SOMATO_TRY(auto changed, with_changes(body.content, sweep.changes));
  SystemSweep planned{{body.name}, sweep, {{body.name, std::move(changed)}}, {}, {}, {}};
  SOMATO_TRY_VOID(take_own_values(explore_defaults, planned));
  return planned;
}

Result<std::vector<NamedFile>> files_at(const SystemSweep& sweep, const SweepPoint& point) {
  std::vector<NamedFile> files;
  for (const NamedFile& system : sweep.files) {
    SOMATO_TRY(auto file,
               with_changes(system.content, changes_at(sweep.sweep, point, system.content)));
    files.push_back({system.name, std::move(file)});
  }
  return files;
}

Result<ReproductionPlan> plan_of_point(const SystemSweep& sweep, const SweepPoint& point) {
  ReproductionPlan plan;
  SOMATO_TRY(const auto files, files_at(sweep, point));
  for (const NamedFile& file : files) {
    SOMATO_TRY_VOID(add_to_plan(file, {}, plan));
  }
  plan.claims = sweep.claims;
  std::erase_if(plan.parts, [&](const ReproductionPart& part) { return !is_needed(sweep, part); });
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
