#include "systems/modules/support.h"

#include <fmt/format.h>

#include <vector>

#include "somato/codes/memory.h"
#include "somato/codes/number_codes.h"
#include "systems/modules/sum_of_frames.h"

namespace somato::modules {
namespace {

struct AccumulateParameters {
  bool every_frame = false;

  static const Declarations<AccumulateParameters>& declarations() {
    using P = AccumulateParameters;
    static const auto declared = Declarations<P>().add(
        "every_frame", &P::every_frame, "", Range::any(),
        "Whether the memory is output with every frame, instead of once after the last frame.");
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
                 "Whether the memory is output with every frame, instead of once after the last "
                 "frame.");
    return declared;
  }
};

class MemoryRunner : public Runner {
 public:
  MemoryRunner(Memory memory, bool every_frame)
      : memory_(std::move(memory)), every_frame_(every_frame) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    memory_.add(inputs.front());
    if (every_frame_) memory_.write(out);
    return {};
  }

  void value(SignalBuffer& out) const override { memory_.write(out); }

 private:
  Memory memory_;
  bool every_frame_;
};

class MemoryModule : public Module {
 public:
  MemoryModule(const MemoryParameters& parameters, bool every_frame)
      : parameters_(parameters), every_frame_(every_frame) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_frames(inputs.front()));
    const PortType& type = inputs.front().type;
    shape_ = type.shape;
    return checked_size(every_frame_ ? type : once(type), inputs.front().port);
  }

  std::unique_ptr<Runner> start() const override {
    return std::make_unique<MemoryRunner>(Memory(shape_, parameters_), every_frame_);
  }

 private:
  MemoryParameters parameters_;
  bool every_frame_;
  std::vector<std::size_t> shape_;
};

class AccumulateModule : public MemoryModule {
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

class MeanRunner : public Runner {
 public:
  explicit MeanRunner(Memory sum) : sum_(std::move(sum)) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& /*out*/) override {
    sum_.add(inputs.front());
    ++frames_;
    return {};
  }

  void value(SignalBuffer& out) const override {
    sum_.write(out);
    for (float& value : out.values()) {
      value = static_cast<float>(double{value} / static_cast<double>(frames_));
    }
  }

 private:
  Memory sum_;
  std::size_t frames_ = 0;
};

class MeanModule : public Module {
 public:
  using Parameters = NoParameters;
  explicit MeanModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_frames(inputs.front()));
    shape_ = inputs.front().type.shape;
    return checked_size(once(inputs.front().type), inputs.front().port);
  }

  std::unique_ptr<Runner> start() const override {
    return std::make_unique<MeanRunner>(Memory(shape_));
  }

 private:
  std::vector<std::size_t> shape_;
};

class NumberCodeModule : public MappedModule {
 public:
  using Parameters = NumberCodeParameters;
  explicit NumberCodeModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(parameters_.validate());
    PortType type = inputs.front().type;
    type.sparse = false;
    if (type.size() == 1) type.shape.clear();
    type.shape.push_back(parameters_.bits);
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& scratch) const override {
    const NumberCode code(parameters_);
    std::vector<float>& numbers = scratch.begin_dense(inputs.front().size);
    write_dense(inputs.front(), numbers);
    std::span<float> bits = out.begin_dense(numbers.size() * code.bits());
    for (const float number : numbers) {
      SOMATO_TRY_VOID(code.encode(number, bits.first(code.bits())));
      bits = bits.subspan(code.bits());
    }
    return {};
  }

 private:
  Parameters parameters_;
};

}  // namespace

bool adds_frames(const Module& module) {
  return dynamic_cast<const AccumulateModule*>(&module) != nullptr;
}

std::vector<ModuleType> memory_types() {
  return {
      describe<AccumulateModule>(
          "accumulate", "The sum of all frames of an exploration: the STM (P06 section 2.1).",
          {input_port("Frames.")}, "The shape of a frame."),
      describe<LeakyAccumulateModule>(
          "leaky_accumulate",
          "A leaky integrator over the frames of an exploration (P06 section 5).",
          {input_port("Frames.")}, "The shape of a frame."),
      describe<MeanModule>("mean", "The mean of all frames of an exploration; not in the papers.",
                           {input_port("Frames.")}, "The shape of a frame."),
      describe<NumberCodeModule>(
          "number_code", "Binary code of each number (P11 section IV-C).", {input_port("Numbers.")},
          "The input's shape with an axis of digits appended. For a single number: the digits.")};
}

}  // namespace somato::modules
