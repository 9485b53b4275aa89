#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "graph/modules/delay.h"
#include "graph/modules/support.h"

namespace somato::modules {
namespace {

// Gives the first frame again and again, or each as it comes.
class FrameStepper : public Stepper {
 public:
  FrameStepper(PortType type, bool first) : type_(std::move(type)), first_(first) {}

  Result<Signal> step(std::span<const SignalView> inputs) override {
    return advance(inputs).map([&](const SignalView& view) { return copy_of(view, type_.shape); });
  }

  Result<SignalView> advance(std::span<const SignalView> inputs) override {
    if (!first_ || !has_frame_) frame_.assign(inputs.front());
    has_frame_ = true;
    return frame_.view();
  }

 private:
  PortType type_;
  bool first_;
  bool has_frame_ = false;
  SignalBuffer frame_;
};

// Frames become one value an exploration.
class ClosingModule : public Module {
 public:
  using Parameters = NoParameters;

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    if (auto frames = expect_frames(inputs.front()); !frames) return fail(frames.error());
    type_ = once(inputs.front().type);
    return checked_size(type_, inputs.front().port);
  }

 protected:
  PortType type_;
};

class FirstModule : public ClosingModule {
 public:
  explicit FirstModule(const Parameters& /*parameters*/) {}

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override {
    return single(copy_of(inputs.front()->values[0], type_.shape), inputs.front()->rate);
  }

  std::unique_ptr<Stepper> start_live() const override {
    return std::make_unique<FrameStepper>(type_, true);
  }
};

class LastModule : public ClosingModule {
 public:
  explicit LastModule(const Parameters& /*parameters*/) {}

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override {
    const Samples& values = inputs.front()->values;
    return single(copy_of(values[values.count() - 1], type_.shape), inputs.front()->rate);
  }

  std::unique_ptr<Stepper> start_live() const override {
    return std::make_unique<FrameStepper>(type_, false);
  }
};

struct DelayParameters {
  std::vector<std::size_t> shape;

  static const Declarations<DelayParameters>& declarations() {
    using P = DelayParameters;
    static const auto declared =
        Declarations<P>().add("shape", &P::shape, "", Range::between(1, 1 << 20),
                              "Shape of the signal; needed where the delay closes a loop.");
    return declared;
  }
};

class DelayStepper : public Stepper {
 public:
  explicit DelayStepper(const PortType& type)
      : before_(Signal::dense(type.shape, std::vector<float>(type.size()))), shape_(type.shape) {}

  Result<Signal> step(std::span<const SignalView> inputs) override {
    Signal now = copy_of(inputs.front(), shape_);
    if (now.is_sparse()) now = Signal::dense(shape_, now.to_dense());
    std::swap(now, before_);
    return now;
  }

 private:
  Signal before_;
  std::vector<std::size_t> shape_;
};

}  // namespace

class DelayModule : public Delay {
 public:
  using Parameters = DelayParameters;
  explicit DelayModule(Parameters parameters) : parameters_(std::move(parameters)) {}

  const std::vector<std::size_t>& promised_shape() const override { return parameters_.shape; }

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    if (auto frames = expect_frames(inputs.front()); !frames) return fail(frames.error());
    type_ = inputs.front().type;
    type_.sparse = false;
    if (!parameters_.shape.empty() && parameters_.shape != type_.shape) {
      return fail(ErrorKind::kUsage,
                  fmt::format("its 'shape' is {}, but {} comes in",
                              fmt::join(parameters_.shape, " x "), fmt::join(type_.shape, " x ")),
                  inputs.front().port, "give the shape of what comes in");
    }
    return checked_size(type_, inputs.front().port);
  }

  std::unique_ptr<Stepper> start() const override { return std::make_unique<DelayStepper>(type_); }

 private:
  Parameters parameters_;
  PortType type_;
};

std::vector<ModuleType> frame_types() {
  return {
      describe<FirstModule>("first", "The first frame of an exploration.", {input_port("Frames.")},
                            "The frame."),
      describe<LastModule>("last",
                           "The last frame of an exploration: P11 III reads the closed hand once.",
                           {input_port("Frames.")}, "The frame."),
      describe<DelayModule>("delay", "The frame before; zeros at the start. It may close a loop.",
                            {input_port("Frames.")}, "The shape of the input.")};
}

}  // namespace somato::modules
