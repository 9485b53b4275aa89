#include "somato/graph/system_description.h"

#include <fmt/format.h>

#include <algorithm>

namespace somato {
namespace {

constexpr std::size_t kMostModules = 256;
constexpr std::size_t kLongestName = 100;  // So that a model file can name its parts.

tl::unexpected<Error> refuse(std::string what, const std::string& where, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), where, std::move(advice));
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

Result<void> read_name(const Table::Entry& entry, SystemDescription& description) {
  const Table* table = std::get_if<Table>(&entry.content);
  if (!table) {
    return refuse("'system' must be a table", entry.where,
                  "write [system] on a separate line, its keys below");
  }
  for (const Table::Entry& key : table->entries) {
    const Value* value = std::get_if<Value>(&key.content);
    const auto* text = value ? std::get_if<std::string>(&value->content) : nullptr;
    if (key.name != "name") return fail(unknown_name("key", key.name, key.where, {"name"}));
    if (!text) return refuse("'name' must be a text", key.where, "write name = \"...\"");
    description.name = *text;
  }
  return {};
}

Result<void> read_modules(const Table::Entry& entry, SystemDescription& description) {
  const Table* modules = std::get_if<Table>(&entry.content);
  if (!modules) {
    return refuse("'module' must hold tables", entry.where,
                  "write [module.NAME] on a separate line, its keys below");
  }
  for (const Table::Entry& module : modules->entries) {
    const Table* settings = std::get_if<Table>(&module.content);
    if (!settings) {
      return refuse("'" + module.name + "' must be a table", module.where,
                    "write [module." + module.name + "] on a separate line, its keys below");
    }
    if (!std::all_of(module.name.begin(), module.name.end(), is_plain) || module.name.empty() ||
        module.name.size() > kLongestName) {
      return refuse("a module cannot be called '" + module.name + "'", module.where,
                    fmt::format("use letters, digits, '_' and '-', {} at most", kLongestName));
    }
    description.modules.push_back({module.name, *settings});
    description.modules.back().settings.where = module.where;
  }
  return {};
}

Result<void> read_phases(const Table::Entry& entry, SystemDescription& description) {
  const auto* phases = std::get_if<std::vector<Table>>(&entry.content);
  if (!phases) {
    return refuse("'phase' must be a list of tables", entry.where,
                  "write [[phase]] on a separate line, its keys below");
  }
  for (const Table& table : *phases) {
    SOMATO_TRY(auto phase, read_parameters<PhaseDescription>(table));
    phase.where = table.where;
    description.phases.push_back(std::move(phase));
  }
  return {};
}

Result<void> check_count(const SystemDescription& description, const std::string& where) {
  if (description.modules.empty()) {
    return refuse("the description has no modules", where, "add [module.NAME] with a type");
  }
  if (description.modules.size() <= kMostModules) return {};
  return refuse(
      fmt::format("{} modules exceed the maximum of {}", description.modules.size(), kMostModules),
      where, "remove some of them");
}

std::string settings_to_toml(const Table& settings) {
  std::string text;
  for (const Table::Entry& entry : settings.entries) {
    if (const auto* value = std::get_if<Value>(&entry.content)) {
      text += entry.name + " = " + to_toml(*value) + "\n";
    }
  }
  return text;
}

std::string phase_to_toml(const PhaseDescription& phase) {
  std::string text = "\n[[phase]]\n";
  for (const auto& parameter : PhaseDescription::declarations().all()) {
    const std::string value = to_toml(parameter.read(phase));
    if (value != "\"automatic\"") text += parameter.info.name + " = " + value + "\n";
  }
  return text;
}

}  // namespace

const Declarations<PhaseDescription>& PhaseDescription::declarations() {
  using P = PhaseDescription;
  static const auto declared =
      Declarations<P>()
          .add("learn", &P::learn, "", Range::any(),
               "Names of the modules that learn, all at the same time; all others remain "
               "unchanged. Required.")
          .add("draws", &P::draws, "", Range::between(1, 1e15),
               "Number of frames or explorations drawn; automatic: the module's own setting. "
               "Required if several modules learn.")
          .add("order", &P::order, "", Range::any(),
               "Order of the explorations drawn; automatic: the module's own setting, or with "
               "replacement. Not given in the paper.")
          .add("of", &P::of, "", Range::any(),
               "Unit of a draw: explorations, or frames, which are those of drawn explorations in "
               "order; automatic: according to the inputs of the modules. With frames, a module "
               "whose input is one value per exploration learns after every frame, from the "
               "exploration so far, like neurons that integrate while the hand explores.");
  return declared;
}

Result<SystemDescription> read_system(const Table& file, const std::vector<std::string>& others) {
  SystemDescription description;
  std::vector<std::string> known{"system", "module", "phase"};
  known.insert(known.end(), others.begin(), others.end());
  for (const Table::Entry& entry : file.entries) {
    Result<void> read;
    if (entry.name == "system") {
      read = read_name(entry, description);
    } else if (entry.name == "module") {
      read = read_modules(entry, description);
    } else if (entry.name == "phase") {
      read = read_phases(entry, description);
    } else if (std::find(others.begin(), others.end(), entry.name) == others.end()) {
      read = fail(unknown_name("table", entry.name, entry.where, known));
    }
    if (!read) return fail(std::move(read.error()));
  }
  SOMATO_TRY_VOID(check_count(description, file.where));
  return description;
}

std::string to_toml(const SystemDescription& description) {
  std::string text = "[system]\nname = " + to_toml(Value{description.name}) + "\n";
  for (const ModuleDescription& module : description.modules) {
    text += "\n[module." + module.name + "]\n" + settings_to_toml(module.settings);
  }
  for (const PhaseDescription& phase : description.phases) text += phase_to_toml(phase);
  return text;
}

SystemBuilder::SystemBuilder(std::string name) {
  description_.name = std::move(name);
}

SystemBuilder& SystemBuilder::module(const std::string& name, const std::string& type,
                                     const std::vector<Setting>& settings) {
  Table table;
  table.entries.push_back({"type", {}, Value{type}});
  for (const Setting& setting : settings) {
    table.entries.push_back({setting.name, {}, setting.value});
  }
  description_.modules.push_back({name, std::move(table)});
  return *this;
}

SystemBuilder& SystemBuilder::phase(PhaseDescription phase) {
  description_.phases.push_back(std::move(phase));
  return *this;
}

}  // namespace somato
