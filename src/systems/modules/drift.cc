#include "systems/modules/support.h"

#include <optional>
#include <utility>

#include "somato/core/check.h"
#include "systems/signals/high_pass.h"
#include "systems/signals/tare.h"

namespace somato::modules {
namespace {

// Runs a filter that changes each frame in place.
template <typename Filter>
class FilterRunner : public Runner {
 public:
  explicit FilterRunner(Filter filter) : filter_(std::move(filter)) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    std::vector<float>& frame = out.begin_dense(inputs.front().size);
    write_dense(inputs.front(), frame);
    filter_.step(frame);
    return {};
  }

 private:
  Filter filter_;
};

Result<PortType> filtered(const Connection& input) {
  SOMATO_TRY_VOID(expect_frames(input));
  PortType type = input.type;
  type.sparse = false;
  return checked_size(std::move(type), input.port);
}

class TareModule : public Module {
 public:
  using Parameters = TareParameters;
  explicit TareModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    elements_ = inputs.front().type.size();
    return filtered(inputs.front());
  }

  std::unique_ptr<Runner> start() const override {
    return std::make_unique<FilterRunner<Tare>>(Tare(elements_, parameters_));
  }

 private:
  Parameters parameters_;
  std::size_t elements_ = 0;
};

// The rate of the channels that share the clock; 0 if unknown.
double rate_of(const std::string& clock, const RecordingLayout& layout) {
  for (std::size_t i = 0; i < layout.rates.size(); ++i) {
    if (layout.channels[i].clock == clock && layout.rates[i].first > 0.0) {
      return layout.rates[i].first;
    }
  }
  return 0.0;
}

// A rate that is estimated from times is only known after some frames: it is decided once, so that
// each exploration is filtered in the same way while it grows and as a whole.
class HighPassModule : public Module {
 public:
  using Parameters = HighPassParameters;
  explicit HighPassModule(const Parameters& parameters) : parameters_(parameters) {}

  Table decide(const std::vector<Connection>& inputs, const RecordingLayout& layout) override {
    has_layout_ = !layout.channels.empty();
    const double rate = rate_of(inputs.front().type.clock, layout);
    if (parameters_.rate || rate == 0.0) return {};
    parameters_.rate = rate;
    return {{}, {{"rate", {}, Parameters::declarations().find("rate")->read(parameters_)}}};
  }

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    elements_ = inputs.front().type.size();
    SOMATO_TRY(auto type, filtered(inputs.front()));
    if (parameters_.rate || !has_layout_) return type;
    return fail(ErrorKind::kUsage, "the frame rate of its input is unknown", inputs.front().port,
                "set 'rate'");
  }

  std::unique_ptr<Runner> start() const override {
    require(parameters_.rate.has_value(), "an automatic rate requires a recording");
    return std::make_unique<FilterRunner<HighPass>>(
        HighPass(elements_, parameters_.time_constant, *parameters_.rate));
  }

 private:
  Parameters parameters_;
  bool has_layout_ = false;
  std::size_t elements_ = 0;
};

}  // namespace

std::vector<ModuleType> drift_types() {
  return {
      describe<TareModule>("tare",
                           "Frames minus the mean of the first frames of the exploration, for "
                           "sensors whose zero drifts between explorations.",
                           {input_port("Frames.")}, "Frames of the same shape."),
      describe<HighPassModule>("high_pass",
                               "First-order high-pass filter over the frames of an exploration, "
                               "for slow drift: y(t) = a (y(t-1) + x(t) - x(t-1)), y(1) = 0, with "
                               "a = T / (T + 1 / rate) for the time constant T.",
                               {input_port("Frames.")}, "Frames of the same shape.")};
}

}  // namespace somato::modules
