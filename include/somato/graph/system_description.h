#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/value.h"
#include "somato/graph/module.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// A module as described by its table `[module.NAME]`.
struct ModuleDescription {
  std::string name;
  Table settings;  ///< `type`, connections of the ports, and parameters.
};

/// A phase of learning, as described by a table `[[phase]]`.
struct PhaseDescription {
  std::vector<std::string> learn;      ///< Names of modules.
  std::optional<std::uint64_t> draws;  ///< Automatic: the module's own number.
  std::optional<Draws> order;          ///< Automatic: the module's own order.
  std::optional<Rate> of;              ///< Automatic: according to the rate of the modules' inputs.
  std::string where = {};              ///< `FILE:LINE`, or another location.

  static const Declarations<PhaseDescription>& declarations();
};

/// A system as described by its text: modules in order, and phases of learning.
struct SystemDescription {
  std::string name;
  std::vector<ModuleDescription> modules;
  std::vector<PhaseDescription> phases;
};

/// Reads a system from the tables `[system]` (which may contain a `name`), `[module.NAME]` and
/// `[[phase]]`; tables named in `others` are ignored. The settings of modules are checked when the
/// system is built. Errors (kUsage) with their location.
Result<SystemDescription> read_system(const Table& file,
                                      const std::vector<std::string>& others = {});

/// The description as TOML that is read back to the same description.
std::string to_toml(const SystemDescription& description);

/// Composes a description in C++.
class SystemBuilder {
 public:
  /// The connections of a port, or the value of a parameter.
  struct Setting {
    std::string name;
    Value value;
  };

  explicit SystemBuilder(std::string name);

  /// Adds a module of type `type` with ports and parameters as in TOML.
  SystemBuilder& module(const std::string& name, const std::string& type,
                        const std::vector<Setting>& settings);

  /// The same with the parameters of a struct such as SomParameters. A `seed` is omitted: the
  /// system sets it.
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
