#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/graph/module.h"

namespace somato::modules {

/// A module without parameters.
struct NoParameters {
  static const Declarations<NoParameters>& declarations();
};

/// Refuses values that come once an exploration where frames are needed.
Result<void> expect_frames(const Connection& input);

/// The type of a frame port after reduction to one value per exploration; it has no clock.
PortType once(PortType type);

/// Refuses inputs that do not come together: of another rate, or frames of other channels.
Result<void> expect_together(const std::vector<Connection>& inputs);

/// Refuses a size that no machine could hold, with the port of the input at fault.
Result<PortType> checked_size(PortType type, const std::string& port);

/// Refuses weights that exceed the machine's memory before allocation: on a system that overcommits
/// memory, the program would otherwise be killed later without a message.
Result<void> check_memory(std::size_t neurons, std::size_t elements, const std::string& port);

/// A sequence of a single value.
Sequence single(Signal signal, double rate = 0.0);

/// A module that needs explorations as a whole.
class WholeModule : public Module {
 public:
  bool is_stepped() const final { return false; }
};

/// A stepped module whose output depends only on the present input, for any rate.
class MappedModule : public Module {
 public:
  std::unique_ptr<Runner> start() const final;

  /// Writes the output for one value of each input to `out`; `scratch` is memory to use on the way.
  /// Errors: kData.
  virtual Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                           SignalBuffer& scratch) const = 0;
};

/// Everything that comes in at the first port, of all explorations one after the other.
Samples all_values(const TrainingInputs& explorations);

/// The type of modules M, which has Parameters, a constructor from them, and nothing else to know.
template <typename M>
ModuleType describe(std::string name, std::string text, std::vector<InputPort> ports,
                    std::string output, bool learns = false) {
  using Parameters = M::Parameters;
  return {std::move(name),
          std::move(text),
          std::move(ports),
          std::move(output),
          learns,
          Parameters::declarations().infos(),
          [](const Table& table) -> Result<std::unique_ptr<Module>> {
            SOMATO_TRY(auto parameters, read_parameters<Parameters>(table));
            return std::make_unique<M>(std::move(parameters));
          }};
}

/// The port of most modules.
InputPort input_port(std::string text);
InputPort input_ports(std::string text);

/// The types of a source of this room: declared and listed here, so that a new source changes one
/// other file.
using Types = std::vector<ModuleType>;
Types source_types();
Types code_types();
Types scaling_types();
Types frame_types();
Types feature_types();
Types drift_types();
Types memory_types();
Types som_types();
Types growing_types();
Types t_mpsom_types();
Types winner_types();
Types association_types();

inline constexpr Types (*kTypesOfSources[])() = {
    source_types, code_types, scaling_types, frame_types,   feature_types, drift_types,
    memory_types, som_types,  growing_types, t_mpsom_types, winner_types,  association_types};

}  // namespace somato::modules
