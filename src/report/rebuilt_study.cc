#include "report/rebuilt_study.h"

#include <algorithm>
#include <utility>

#include "somato/files/toml_file.h"
#include "somato/graph/module.h"
#include "somato/maps/som_parameters.h"

namespace somato::detail {
namespace {

const std::string kModule = "module.";
const std::string kPhase = "phase.";
const std::string kAutomatic = "\"automatic\"";

bool is_of_system(const Settings& part) {
  return part.part.starts_with(kModule) || part.part.starts_with(kPhase);
}

std::vector<ParameterInfo> parameters_of(const Settings& part) {
  if (part.part == "study") return StudyParameters::declarations().infos();
  if (part.part == "recording") return RecordingParameters::declarations().infos();
  const ModuleType* type = type_of(part);
  return type ? type->parameters : std::vector<ParameterInfo>{};
}

bool is_default(const std::vector<ParameterInfo>& parameters, const Setting& setting) {
  if (setting.value == kAutomatic) return true;
  return std::any_of(parameters.begin(), parameters.end(), [&](const ParameterInfo& info) {
    return info.name == setting.name && info.default_text == setting.value;
  });
}

std::string lines_of(const Settings& part) {
  const std::vector<ParameterInfo> parameters = parameters_of(part);
  std::string text;
  for (const Setting& setting : part.settings) {
    if (!is_default(parameters, setting)) text += setting.name + " = " + setting.value + "\n";
  }
  return text;
}

// What a map's training decided may be something that a person could not have asked for.
void leave_out_without_effect(ModuleDescription& module) {
  const Table::Entry* type = module.settings.find("type");
  const auto* name = type ? std::get_if<Value>(&type->content) : nullptr;
  if (!name || *name != Value{"som"}) return;
  SomParameters parameters;
  for (const Table::Entry& entry : module.settings.entries) {
    const auto declared = SomParameters::declarations().find(entry.name);
    const auto* value = std::get_if<Value>(&entry.content);
    if (declared && value) static_cast<void>(declared->assign(parameters, *value));
  }
  std::erase_if(module.settings.entries, [&](const Table::Entry& entry) {
    return !reason_without_effect(parameters, entry.name).empty();
  });
}

// A trained module says how long it learned and how it drew, which was for its phase to say.
void leave_to_phase(const PhaseDescription& phase, ModuleDescription& module) {
  if (std::find(phase.learn.begin(), phase.learn.end(), module.name) == phase.learn.end()) return;
  std::erase_if(module.settings.entries, [&](const Table::Entry& entry) {
    return (entry.name == "iterations" && phase.draws) ||
           (entry.name == "draws" && (phase.order || phase.learn.size() > 1));
  });
}

const std::string* find_value(const Settings& part, const std::string& name) {
  for (const Setting& setting : part.settings) {
    if (setting.name == name) return &setting.value;
  }
  return nullptr;
}

bool same_part(const Settings& own, const Settings& other) {
  if (own.settings.size() != other.settings.size()) return false;
  return std::all_of(own.settings.begin(), own.settings.end(), [&](const Setting& setting) {
    const std::string* value = find_value(other, setting.name);
    return value && (*value == setting.value || setting.value == kAutomatic);
  });
}

}  // namespace

const Settings* find_part(const std::vector<Settings>& settings, const std::string& part) {
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [&](const Settings& one) { return one.part == part; });
  return found == settings.end() ? nullptr : &*found;
}

const ModuleType* type_of(const Settings& module) {
  for (const Setting& setting : module.settings) {
    if (setting.name != "type") continue;
    for (const ModuleType& type : module_types()) {
      if (to_toml(Value{type.name}) == setting.value) return &type;
    }
  }
  return nullptr;
}

const std::string* find_setting(const std::vector<Settings>& settings, const std::string& part,
                                const std::string& name) {
  const Settings* found = find_part(settings, part);
  return found ? find_value(*found, name) : nullptr;
}

Result<StudyDescription> rebuilt_study(const std::vector<Settings>& settings) {
  std::string text;
  for (const Settings& part : settings) {
    if (part.part.starts_with(kPhase)) {
      text += "[[phase]]\n" + lines_of(part);
    } else if (is_of_system(part) || part.part == "study" || part.part == "recording") {
      text += "[" + part.part + "]\n" + lines_of(part);
    }
  }
  const auto table = parse_toml(text, "settings");
  if (!table) return fail(table.error());
  auto study = read_study(*table);
  if (!study) return study;
  for (ModuleDescription& module : study->system.modules) {
    leave_out_without_effect(module);
    for (const PhaseDescription& phase : study->system.phases) leave_to_phase(phase, module);
  }
  return study;
}

bool same_system(const std::vector<Settings>& own, const std::vector<Settings>& settings) {
  const auto parts = [](const std::vector<Settings>& all) {
    return std::count_if(all.begin(), all.end(), is_of_system);
  };
  if (parts(own) != parts(settings)) return false;
  return std::all_of(own.begin(), own.end(), [&](const Settings& part) {
    const Settings* other = is_of_system(part) ? find_part(settings, part.part) : &part;
    return other && (other == &part || same_part(part, *other));
  });
}

}  // namespace somato::detail
