#include "studies/results/settings.h"

#include <iterator>
#include <string>
#include <utility>

#include "somato/graph/system_model.h"

namespace somato {
namespace {

template <typename Parameters>
Settings settings_of(std::string part, const Parameters& parameters) {
  Settings settings{std::move(part), {}};
  for (const auto& parameter : Parameters::declarations().all()) {
    settings.settings.push_back({parameter.info.name, to_toml(parameter.read(parameters))});
  }
  return settings;
}

// The resolved values of automatic parameters.
std::string decided(const ParameterInfo& parameter, const Som* som) {
  const bool is_automatic = parameter.default_text.find("automatic") != std::string::npos;
  const auto known =
      som && is_automatic ? SomParameters::declarations().find(parameter.name) : std::nullopt;
  return known ? to_toml(known->read(som->parameters())) : parameter.default_text;
}

// The settings of a module in the description, and its defaults.
Settings settings_of(const ModuleDescription& module, const ModuleType& type, const Som* som) {
  Settings settings{"module." + module.name, {}};
  for (const Table::Entry& entry : module.settings.entries) {
    if (const auto* value = std::get_if<Value>(&entry.content)) {
      settings.settings.push_back({entry.name, to_toml(*value)});
    }
  }
  for (const ParameterInfo& parameter : type.parameters) {
    if (module.settings.find(parameter.name)) continue;
    settings.settings.push_back({parameter.name, decided(parameter, som)});
  }
  return settings;
}

}  // namespace

std::vector<Settings> system_settings(const System& system) {
  const SystemDescription& description = system.description();
  std::vector<Settings> settings;
  settings.reserve(system.modules().size() + description.phases.size());
  for (std::size_t i = 0; i < system.modules().size(); ++i) {
    settings.push_back(
        settings_of(description.modules[i], *system.modules()[i].type, som_of(system, i)));
  }
  for (std::size_t i = 0; i < description.phases.size(); ++i) {
    settings.push_back(settings_of("phase." + std::to_string(i + 1), description.phases[i]));
  }
  return settings;
}

std::vector<Settings> study_settings(const StudyDescription& description, const System& trained) {
  std::vector<Settings> settings{settings_of("study", description.study),
                                 settings_of("recording", description.recording)};
  for (const Alteration& alteration : description.altered) {
    settings.push_back(settings_of("altered." + alteration.name, alteration));
  }
  std::vector<Settings> more = system_settings(trained);
  std::move(more.begin(), more.end(), std::back_inserter(settings));
  return settings;
}

}  // namespace somato
