#include "systems/modules/support.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "systems/modules/delay.h"

namespace somato::modules {
namespace {

class FirstRunner : public Runner {
 public:
  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    if (!has_frame_) out.assign(inputs.front());
    has_frame_ = true;
    return {};
  }

 private:
  bool has_frame_ = false;
};

class LastRunner : public Runner {
 public:
  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    out.assign(inputs.front());
    return {};
  }
};

// One of the frames becomes the value of the exploration.
template <typename R>
class ChosenFrameModule : public Module {
 public:
  using Parameters = NoParameters;
  explicit ChosenFrameModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_frames(inputs.front()));
    return checked_size(once(inputs.front().type), inputs.front().port);
  }

  std::unique_ptr<Runner> start() const override { return std::make_unique<R>(); }
};

using FirstModule = ChosenFrameModule<FirstRunner>;
using LastModule = ChosenFrameModule<LastRunner>;

struct DelayParameters {
  std::vector<std::size_t> shape;

  static const Declarations<DelayParameters>& declarations() {
    using P = DelayParameters;
    static const auto declared =
        Declarations<P>().add("shape", &P::shape, "", Range::between(1, 1 << 20),
                              "Shape of the signal; required if the delay closes a loop.");
    return declared;
  }
};

class DelayRunner : public Runner {
 public:
  explicit DelayRunner(std::size_t size) : before_(size) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    std::swap(out.begin_dense(before_.size()), before_);
    before_.resize(inputs.front().size);
    write_dense(inputs.front(), before_);
    return {};
  }

 private:
  std::vector<float> before_;
};

}  // namespace

class DelayModule : public Delay {
 public:
  using Parameters = DelayParameters;
  explicit DelayModule(Parameters parameters) : parameters_(std::move(parameters)) {}

  const std::vector<std::size_t>& promised_shape() const override { return parameters_.shape; }

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_frames(inputs.front()));
    PortType type = inputs.front().type;
    type.sparse = false;
    size_ = type.size();
    if (!parameters_.shape.empty() && parameters_.shape != type.shape) {
      return fail(ErrorKind::kUsage,
                  fmt::format("its 'shape' is {}, but the input has {}",
                              fmt::join(parameters_.shape, " x "), fmt::join(type.shape, " x ")),
                  inputs.front().port, "use the shape of the input");
    }
    return checked_size(std::move(type), inputs.front().port);
  }

  std::unique_ptr<Runner> start() const override { return std::make_unique<DelayRunner>(size_); }

 private:
  Parameters parameters_;
  std::size_t size_ = 0;
};

std::vector<ModuleType> frame_types() {
  return {
      describe<FirstModule>("first", "The first frame of an exploration.", {input_port("Frames.")},
                            "The frame."),
      describe<LastModule>(
          "last", "The last frame of an exploration: P11 III uses one frame of the closed hand.",
          {input_port("Frames.")}, "The frame."),
      describe<DelayModule>("delay",
                            "The preceding frame; zeros at the start. It may close a loop.",
                            {input_port("Frames.")}, "The shape of the input.")};
}

}  // namespace somato::modules
