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

/// A module of a system.
struct SystemModule {
  std::string name;
  std::string where;  ///< `FILE:LINE`, or empty.
  const ModuleType* type = nullptr;
  std::unique_ptr<Module> module;
  std::vector<std::size_t> inputs;  ///< Numbers of modules, in the order of the ports.
  std::vector<std::string> ports;   ///< The ports of these connections.
  PortType output;
  FrameRates rates;  ///< Those of the channel from which its frames come.
};

/// A validated phase of learning.
struct Phase {
  std::vector<std::size_t> learners;  ///< Numbers of modules, in execution order.
  std::optional<std::uint64_t> draws;
  std::optional<Draws> order;
  Rate of = Rate::kExploration;  ///< Unit of a draw.
  /// Whether the inputs are values of explorations although a draw is a frame: the learners then
  /// learn after every frame, from the exploration so far.
  bool settles = false;
};

/// A system of connected modules with known shapes and valid phases. Learned values are stored in
/// its modules; train_system() trains them.
class System {
 public:
  /// Builds a system for recordings with that layout. Errors (kUsage) name file, line, module and
  /// port: unknown types, keys and names (with the nearest known), unconnected ports, loops without
  /// a delay, shapes and rates that do not fit, invalid phases.
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

  /// The phases in order: those of the description, and one for each learning module that they do
  /// not name, as soon as it is required.
  const std::vector<Phase>& phases() const { return phases_; }

  /// The modules in groups, in an order in which they can run; see Wiring.
  const Wiring& wiring() const { return *wiring_; }

  /// The number of the module with that name; an unknown name is an error (kUsage, at `where`) with
  /// the nearest name.
  Result<std::size_t> find(const std::string& name, const std::string& where = {}) const;

  /// Whether the module's output does not depend on learning.
  bool is_fixed(std::size_t module) const;

  /// Adds the name and location of a module to an error.
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
