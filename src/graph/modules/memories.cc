#include <fmt/format.h>

#include <vector>

#include "graph/modules/sum_of_frames.h"
#include "graph/modules/support.h"
#include "somato/codes/memory.h"
#include "somato/codes/number_codes.h"

namespace somato::modules {
namespace {

struct AccumulateParameters {
  bool every_frame = false;

  static const Declarations<AccumulateParameters>& declarations() {
    using P = AccumulateParameters;
    static const auto declared = Declarations<P>().add(
        "every_frame", &P::every_frame, "", Range::any(),
        "Whether the memory is put out with every frame, rather than once it holds them all.");
    return declared;
  }
};

struct LeakyAccumulateParameters {
  MemoryParameters memory;
  bool every_frame = false;

  static const Declarations<LeakyAccumulateParameters>& declarations() {
    using P = LeakyAccumulateParameters;
    static const auto declared =
        Declarations<P>()
            .add_from(&P::memory, MemoryParameters::declarations(), {"leak"})
            .add("every_frame", &P::every_frame, "", Range::any(),
                 "Whether the memory is put out with every frame, rather than once it has met them "
                 "all.");
    return declared;
  }
};

class MemoryStepper : public Stepper {
 public:
  explicit MemoryStepper(Memory memory) : memory_(std::move(memory)) {}

  Result<Signal> step(std::span<const SignalView> inputs) override {
    memory_.add(inputs.front());
    return memory_.value();
  }

  Result<SignalView> advance(std::span<const SignalView> inputs) override {
    memory_.add(inputs.front());
    memory_.write(value_);
    return value_.view();
  }

 private:
  Memory memory_;
  SignalBuffer value_;
};

class MemoryModule : public Module {
 public:
  MemoryModule(const MemoryParameters& parameters, bool every_frame)
      : parameters_(parameters), every_frame_(every_frame) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    if (auto frames = expect_frames(inputs.front()); !frames) return fail(frames.error());
    type_ = inputs.front().type;
    return checked_size(every_frame_ ? type_ : once(type_), inputs.front().port);
  }

  bool is_stepped() const override { return every_frame_; }

  std::unique_ptr<Stepper> start() const override { return every_frame_ ? start_live() : nullptr; }

  std::unique_ptr<Stepper> start_live() const override {
    return std::make_unique<MemoryStepper>(Memory(type_.shape, parameters_));
  }

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override {
    const Samples& frames = inputs.front()->values;
    Memory memory(type_.shape, parameters_);
    std::vector<Signal> outputs;
    for (std::size_t frame = 0; frame < frames.count(); ++frame) {
      memory.add(frames[frame]);
      if (every_frame_) outputs.push_back(memory.value());
    }
    if (!every_frame_) outputs.push_back(memory.value());
    return Sequence{Samples::from_signals(outputs), inputs.front()->rate};
  }

 private:
  MemoryParameters parameters_;
  bool every_frame_;
  PortType type_;
};

class AccumulateModule : public MemoryModule, public SumOfFrames {
 public:
  using Parameters = AccumulateParameters;
  explicit AccumulateModule(const Parameters& parameters)
      : MemoryModule({}, parameters.every_frame) {}
};

class LeakyAccumulateModule : public MemoryModule {
 public:
  using Parameters = LeakyAccumulateParameters;
  explicit LeakyAccumulateModule(const Parameters& parameters)
      : MemoryModule(parameters.memory, parameters.every_frame) {}
};

class NumberCodeModule : public MappedModule {
 public:
  using Parameters = NumberCodeParameters;
  explicit NumberCodeModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    if (auto valid = parameters_.validate(); !valid) return fail(std::move(valid.error()));
    PortType type = inputs.front().type;
    type.sparse = false;
    if (type.size() == 1) type.shape.clear();
    type.shape.push_back(parameters_.bits);
    shape_ = type.shape;
    numbers_ = inputs.front().type.size();
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<Signal> map(std::span<const SignalView> inputs) const override {
    const NumberCode code(parameters_);
    std::vector<float> numbers(numbers_);
    write_dense(inputs.front(), numbers);
    std::vector<float> bits;
    bits.reserve(numbers_ * code.bits());
    for (const float number : numbers) {
      const auto coded = code.encode(number);
      if (!coded) return fail(coded.error());
      bits.insert(bits.end(), coded->values().begin(), coded->values().end());
    }
    return Signal::dense(shape_, std::move(bits));
  }

 private:
  Parameters parameters_;
  std::vector<std::size_t> shape_;
  std::size_t numbers_ = 0;
};

}  // namespace

std::vector<ModuleType> memory_types() {
  return {describe<AccumulateModule>(
              "accumulate", "The sum of all frames of an exploration: the STM (P06 section 2.1).",
              {input_port("Frames.")}, "The shape of a frame."),
          describe<LeakyAccumulateModule>(
              "leaky_accumulate",
              "A leaky integrator over the frames of an exploration (P06 section 5).",
              {input_port("Frames.")}, "The shape of a frame."),
          describe<NumberCodeModule>(
              "number_code", "Each number as so many binary digits (P11 section IV-C).",
              {input_port("Numbers.")},
              "The input's shape with an axis of digits added. A single number: the digits.")};
}

}  // namespace somato::modules
