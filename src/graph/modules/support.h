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

/// A frame port as it is once an exploration; the clock is gone.
PortType once(PortType type);

/// Refuses inputs that do not come together: of another rate, or frames of other channels.
Result<void> expect_together(const std::vector<Connection>& inputs);

/// Refuses a size that no machine could hold, with the port of the input at fault.
Result<PortType> checked_size(PortType type, const std::string& port);

/// The number of values of the inputs, which must all have as many. Errors: kData.
Result<std::size_t> common_count(std::span<const Sequence* const> inputs);

/// All values of a sequence, a row each, zeros written out.
Matrix<float> dense_rows(const Sequence& sequence);

/// A sequence of a single value.
Sequence single(Signal signal, double rate = 0.0);

/// A module that turns its inputs into its output frame by frame; see Module::start().
class SteppedModule : public Module {
 public:
  bool is_stepped() const final { return true; }
  Result<Sequence> run(std::span<const Sequence* const> inputs) const final;
};

/// A module whose output depends on the present input alone: whatever the rate, value by value.
class MappedModule : public SteppedModule {
 public:
  std::unique_ptr<Stepper> start() const override;

  /// The output for one value of each input. Errors: kData.
  virtual Result<Signal> map(std::span<const SignalView> inputs) const = 0;

  /// The same, flat, into `room.output`; for modules that run live, without allocation once the
  /// room has grown.
  struct Room {
    SignalBuffer output;
    SignalBuffer scratch;
  };
  virtual Result<void> write(std::span<const SignalView> inputs, Room& room) const;
};

/// A signal of that shape from a view.
Signal copy_of(const SignalView& view, const std::vector<std::size_t>& shape);

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
            Result<Parameters> parameters = read_parameters<Parameters>(table);
            if (!parameters) return fail(std::move(parameters.error()));
            return std::make_unique<M>(std::move(*parameters));
          }};
}

/// The port of most modules.
InputPort input_port(std::string text);
InputPort input_ports(std::string text);

/// The types, a function for each source file.
std::vector<ModuleType> source_types();
std::vector<ModuleType> code_types();
std::vector<ModuleType> frame_types();
std::vector<ModuleType> feature_types();
std::vector<ModuleType> memory_types();
std::vector<ModuleType> scaling_types();
std::vector<ModuleType> map_types();

}  // namespace somato::modules
