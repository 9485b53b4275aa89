#include "graph/modules/support.h"

#include <fmt/format.h>

#include "somato/core/check.h"

namespace somato::modules {
namespace {

constexpr std::size_t kMostElements = (std::size_t{1} << 32) - 1;
constexpr std::size_t kMostDenseElements = std::size_t{1} << 26;

class MappedStepper : public Stepper {
 public:
  explicit MappedStepper(const MappedModule& module) : module_(module) {}

  Result<Signal> step(std::span<const SignalView> inputs) override { return module_.map(inputs); }

  Result<SignalView> advance(std::span<const SignalView> inputs) override {
    if (auto written = module_.write(inputs, room_); !written) return fail(written.error());
    return room_.output.view();
  }

 private:
  const MappedModule& module_;
  MappedModule::Room room_;
};

}  // namespace

const Declarations<NoParameters>& NoParameters::declarations() {
  static const Declarations<NoParameters> none;
  return none;
}

Result<void> expect_frames(const Connection& input) {
  if (input.type.rate == Rate::kFrame) return {};
  return fail(ErrorKind::kUsage, "it takes frames, but what comes in is one value an exploration",
              input.port, "connect it before the frames are put together");
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
                  "one input comes with every frame and another once an exploration", input.port,
                  "put the frames together first, as with 'last' or 'accumulate'");
    }
    if (input.type.clock != first.clock) {
      return fail(ErrorKind::kUsage,
                  fmt::format("the frames of '{}' and of '{}' are not taken together", first.clock,
                              input.type.clock),
                  input.port, "bring each to one value an exploration first");
    }
  }
  return {};
}

Result<PortType> checked_size(PortType type, const std::string& port) {
  const std::size_t most = type.sparse ? kMostElements : kMostDenseElements;
  if (type.size() == 0) {
    return fail(ErrorKind::kUsage, "its output would have no elements", port);
  }
  if (type.size() <= most) return type;
  return fail(ErrorKind::kUsage,
              fmt::format("its output of {} elements would have more than {}",
                          fmt::join(type.shape, " x "), most),
              port, "give fewer elements to what comes in");
}

Result<std::size_t> common_count(std::span<const Sequence* const> inputs) {
  const std::size_t count = inputs.front()->values.count();
  for (const Sequence* input : inputs) {
    if (input->values.count() == count) continue;
    return fail(ErrorKind::kData,
                fmt::format("{} frames come in at one port and {} at another", count,
                            input->values.count()),
                {}, "record the channels together, frame by frame");
  }
  return count;
}

Matrix<float> dense_rows(const Sequence& sequence) {
  Matrix<float> rows(sequence.values.count(), sequence.values.size());
  for (std::size_t i = 0; i < rows.rows(); ++i) write_dense(sequence.values[i], rows.row(i));
  return rows;
}

Sequence single(Signal signal, double rate) {
  return {Samples::from_signals({std::move(signal)}), rate};
}

Result<Sequence> SteppedModule::run(std::span<const Sequence* const> inputs) const {
  const Result<std::size_t> count = common_count(inputs);
  if (!count) return fail(count.error());
  const std::unique_ptr<Stepper> stepper = start();
  std::vector<SignalView> views(inputs.size());
  std::vector<Signal> outputs;
  outputs.reserve(*count);
  for (std::size_t frame = 0; frame < *count; ++frame) {
    for (std::size_t i = 0; i < inputs.size(); ++i) views[i] = inputs[i]->values[frame];
    Result<Signal> output = stepper->step(views);
    if (!output) {
      output.error().what += fmt::format(" (frame {})", frame + 1);
      return fail(std::move(output.error()));
    }
    outputs.push_back(std::move(*output));
  }
  return Sequence{Samples::from_signals(outputs), inputs.front()->rate};
}

std::unique_ptr<Stepper> MappedModule::start() const {
  return std::make_unique<MappedStepper>(*this);
}

Result<void> MappedModule::write(std::span<const SignalView> inputs, Room& room) const {
  const Result<Signal> output = map(inputs);
  if (!output) return fail(output.error());
  room.output.assign(output->view());
  return {};
}

Signal copy_of(const SignalView& view, const std::vector<std::size_t>& shape) {
  std::vector<float> values(view.values.begin(), view.values.end());
  if (!view.sparse) return Signal::dense(shape, std::move(values));
  return Signal::sparse(shape, {view.indices.begin(), view.indices.end()}, std::move(values));
}

Samples all_values(const TrainingInputs& explorations) {
  std::vector<Signal> signals;
  for (const auto& ports : explorations) {
    const Samples& values = ports.front()->values;
    for (std::size_t i = 0; i < values.count(); ++i) {
      signals.push_back(copy_of(values[i], {values.size()}));
    }
  }
  return Samples::from_signals(signals);
}

InputPort input_port(std::string text) {
  return {"input", std::move(text), true, false};
}

InputPort input_ports(std::string text) {
  return {"inputs", std::move(text), true, true};
}

}  // namespace somato::modules
