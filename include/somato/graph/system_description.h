#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/value.h"
#include "somato/graph/port.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// A module as its table `[module.NAME]` describes it.
struct ModuleDescription {
  std::string name;
  Table settings;  ///< `type`, what is connected to the ports, and parameters.
};

/// A stretch of learning, as a table `[[phase]]` describes it.
struct PhaseDescription {
  std::vector<std::string> learn;      ///< Names of modules.
  std::optional<std::uint64_t> draws;  ///< Automatic: the module's own number.
  std::optional<Draws> order;          ///< Automatic: the module's own.
  std::optional<Rate> of;              ///< Automatic: by the rate of what the modules learn.
  std::string where = {};              ///< `file:line`, or another place to point at.

  static const Declarations<PhaseDescription>& declarations();
};

/// A system as its text describes it: modules in their order, and how they learn.
struct SystemDescription {
  std::string name;
  std::vector<ModuleDescription> modules;
  std::vector<PhaseDescription> phases;
};

/// Reads a system from the tables `[system]` (which may give a `name`), `[module.NAME]` and
/// `[[phase]]`; tables named in `others` belong to somebody else. What the modules say of
/// themselves is checked when the system is built. Errors (kUsage) with their place.
Result<SystemDescription> read_system(const Table& file,
                                      const std::vector<std::string>& others = {});

/// The description as TOML that reads back as the same.
std::string to_toml(const SystemDescription& description);

/// Puts a description together in C++.
class SystemBuilder {
 public:
  /// What is connected to a port, or what a parameter is.
  struct Setting {
    std::string name;
    Value value;
  };

  explicit SystemBuilder(std::string name);

  /// Adds a module of type `type` with ports and parameters as the text would have them.
  SystemBuilder& module(const std::string& name, const std::string& type,
                        const std::vector<Setting>& settings);

  /// The same with the parameters of a struct such as SomParameters. A `seed` is left out: a system
  /// gets its own.
  template <typename Parameters>
  SystemBuilder& module(const std::string& name, const std::string& type,
                        std::vector<Setting> connections, const Parameters& parameters) {
    const Parameters defaults{};
    for (const auto& parameter : Parameters::declarations().all()) {
      Value value = parameter.read(parameters);
      if (parameter.info.name == "seed" || value == parameter.read(defaults)) continue;
      connections.push_back({parameter.info.name, std::move(value)});
    }
    return module(name, type, connections);
  }

  /// Adds a phase.
  SystemBuilder& phase(PhaseDescription phase);

  const SystemDescription& description() const { return description_; }

 private:
  SystemDescription description_;
};

}  // namespace somato
