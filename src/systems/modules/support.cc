#include "systems/modules/support.h"

#include <fmt/format.h>

#include "base/core/memory.h"
#include "somato/core/check.h"

namespace somato::modules {
namespace {

constexpr std::size_t kMostSparseElements = (std::size_t{1} << 32) - 1;
constexpr std::size_t kMostDenseElements = std::size_t{1} << 26;

class MappedRunner : public Runner {
 public:
  explicit MappedRunner(const MappedModule& module) : module_(module) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    return module_.map(inputs, out, scratch_);
  }

 private:
  const MappedModule& module_;
  SignalBuffer scratch_;
};

}  // namespace

const Declarations<NoParameters>& NoParameters::declarations() {
  static const Declarations<NoParameters> none;
  return none;
}

Result<void> expect_frames(const Connection& input) {
  if (input.type.rate == Rate::kFrame) return {};
  return fail(ErrorKind::kUsage, "it requires frames, but its input has one value per exploration",
              input.port, "connect it before the frames are combined");
}

PortType once(PortType type) {
  type.rate = Rate::kExploration;
  type.clock.clear();
  return type;
}

Result<void> expect_together(const std::vector<Connection>& inputs) {
  const PortType& first = inputs.front().type;
  for (const Connection& input : inputs) {
    if (input.type.rate != first.rate) {
      return fail(ErrorKind::kUsage,
                  "one input has a value per frame and another one per exploration", input.port,
                  "combine the frames first, for example with 'last' or 'accumulate'");
    }
    if (input.type.clock != first.clock) {
      return fail(ErrorKind::kUsage,
                  fmt::format("the frames of '{}' and of '{}' are not recorded together",
                              first.clock, input.type.clock),
                  input.port, "reduce each to one value per exploration first");
    }
  }
  return {};
}

Result<PortType> checked_size(PortType type, const std::string& port) {
  const std::size_t most = type.sparse ? kMostSparseElements : kMostDenseElements;
  if (type.size() == 0) {
    return fail(ErrorKind::kUsage, "its output has no elements", port);
  }
  if (type.size() <= most) return type;
  return fail(ErrorKind::kUsage,
              fmt::format("its output of {} elements exceeds the maximum of {}",
                          fmt::join(type.shape, " x "), most),
              port, "reduce the number of elements of its input");
}

Result<void> check_memory(std::size_t neurons, std::size_t elements, const std::string& port) {
  const double needed =
      static_cast<double>(neurons) * static_cast<double>(elements) * sizeof(float);
  const auto there = static_cast<double>(memory_of_machine());
  if (needed <= there) return {};
  return fail(ErrorKind::kUsage,
              fmt::format("{} neurons with {} elements need {} of memory, and this machine has {}",
                          neurons, elements, memory_text(needed), memory_text(there)),
              port, "use fewer neurons or elements");
}

Sequence single(Signal signal, double rate) {
  return {Samples::from_signals({std::move(signal)}), rate};
}

std::unique_ptr<Runner> MappedModule::start() const {
  return std::make_unique<MappedRunner>(*this);
}

Samples all_values(const TrainingInputs& explorations) {
  SampleCollector all;
  for (const auto& ports : explorations) {
    const Samples& values = ports.front()->values;
    for (std::size_t i = 0; i < values.count(); ++i) all.add(values[i]);
  }
  return all.samples();
}

InputPort input_port(std::string text) {
  return {"input", std::move(text), true, false};
}

InputPort input_ports(std::string text) {
  return {"inputs", std::move(text), true, true};
}

}  // namespace somato::modules
