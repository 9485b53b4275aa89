#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/module.h"
#include "somato/graph/system_description.h"
#include "somato/recording/layout.h"

namespace somato {

class Wiring;

/// A module in its place.
struct SystemModule {
  std::string name;
  std::string where;  ///< `file:line`, or empty.
  const ModuleType* type = nullptr;
  std::unique_ptr<Module> module;
  std::vector<std::size_t> inputs;  ///< Numbers of modules, in the order of the ports.
  std::vector<std::string> ports;   ///< Their ports.
  PortType output;
};

/// A stretch of learning, checked.
struct Phase {
  std::vector<std::size_t> learners;  ///< Numbers of modules, in the order they run.
  std::optional<std::uint64_t> draws;
  std::optional<Draws> order;
  Rate of = Rate::kExploration;
};

/// Modules put together: every port connected, every shape known, every phase possible. Whatever
/// has learned is kept in its modules; train_system() makes them learn.
class System {
 public:
  /// Builds a system for recordings of that layout. Errors (kUsage) name file, line, module and
  /// port: unknown types, keys and names (with the nearest known), ports left open, loops without a
  /// delay, shapes and rates that do not fit, phases that cannot be.
  static Result<System> build(SystemDescription description, RecordingLayout layout);

  /// A system without modules.
  System();
  System(System&&) noexcept;
  System& operator=(System&&) noexcept;
  System(const System&) = delete;
  System& operator=(const System&) = delete;
  ~System();

  const SystemDescription& description() const { return description_; }
  const RecordingLayout& layout() const { return layout_; }
  const std::vector<SystemModule>& modules() const { return modules_; }

  /// The phases in their order: those of the description, and one for each learning module that
  /// none of them names, as soon as it is needed.
  const std::vector<Phase>& phases() const { return phases_; }

  /// In groups, in the order in which they can run; see Wiring.
  const Wiring& wiring() const { return *wiring_; }

  /// The number of the module of that name; unknown: kUsage, at `where`, with the nearest name.
  Result<std::size_t> find(const std::string& name, const std::string& where = {}) const;

  /// Whether what the module gives never depends on learning.
  bool is_fixed(std::size_t module) const;

  /// An error of a module, with its name and place.
  Error at_module(Error error, std::size_t module) const;

 private:
  Result<void> make_modules();
  Result<void> connect_ports();
  Result<void> wire();
  Result<void> infer_types();
  Result<void> infer_loop(const std::vector<std::size_t>& group);
  Result<void> promise(std::size_t member, const std::string& clock);
  Result<void> infer_module(std::size_t module);
  Result<void> plan_phases();
  Error at_port(Error error, std::size_t module, const std::string& port) const;

  SystemDescription description_;
  RecordingLayout layout_;
  std::vector<SystemModule> modules_;
  std::vector<Phase> phases_;
  std::unique_ptr<Wiring> wiring_;
};

}  // namespace somato
