#include "systems/modules/support.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/core/dense_rows.h"
#include "somato/codes/spectrum.h"
#include "systems/signals/change.h"
#include "systems/signals/mean_removal.h"
#include "systems/signals/onset.h"
#include "systems/signals/resampling.h"

namespace somato::modules {
namespace {

class MeanRemovalModule : public WholeModule {
 public:
  using Parameters = NoParameters;
  explicit MeanRemovalModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_frames(inputs.front()));
    PortType type = inputs.front().type;
    type.sparse = false;
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override {
    return Sequence{Samples(mean_removed(dense_rows(inputs.front()->values))),
                    inputs.front()->rate};
  }
};

class ChangeModule : public WholeModule {
 public:
  using Parameters = NoParameters;
  explicit ChangeModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_frames(inputs.front()));
    PortType type = once(inputs.front().type);
    type.sparse = false;
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override {
    return change_of(dense_rows(inputs.front()->values)).map([&](Signal change) {
      return single(std::move(change), inputs.front()->rate);
    });
  }
};

class ResamplingModule : public WholeModule {
 public:
  using Parameters = ResamplingParameters;
  explicit ResamplingModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_frames(inputs.front()));
    PortType type = once(inputs.front().type);
    type.sparse = false;
    type.shape.insert(type.shape.begin(), parameters_.points);
    shape_ = type.shape;
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override {
    return resampled(dense_rows(inputs.front()->values), parameters_)
        .map([&](const Matrix<float>& points) {
          const auto values = points.values();
          return single(Signal::dense(shape_, {values.begin(), values.end()}));
        });
  }

 private:
  Parameters parameters_;
  std::vector<std::size_t> shape_;
};

struct WindowParameters {
  std::size_t start = 0;
  std::size_t length = 1;
  BeyondFrames beyond = BeyondFrames::kRefuse;

  static const Declarations<WindowParameters>& declarations() {
    using P = WindowParameters;
    static const auto declared =
        Declarations<P>()
            .add("start", &P::start, "frames", Range::between(0, 1e9),
                 "Number of frames skipped at the start of an exploration.")
            .add("length", &P::length, "frames", Range::between(1, 1e9),
                 "Number of frames of the window.")
            .add("beyond", &P::beyond, "", Range::any(),
                 "Treatment of a window that extends beyond the last frame: an error, or the last "
                 "frame is repeated.");
    return declared;
  }
};

class WindowModule : public WholeModule {
 public:
  using Parameters = WindowParameters;
  explicit WindowModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_frames(inputs.front()));
    PortType type = inputs.front().type;
    type.sparse = false;
    type.clock = fmt::format("{} frames from frame {} of {}", parameters_.length,
                             parameters_.start + 1, type.clock);
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override {
    const Samples& frames = inputs.front()->values;
    const std::size_t end = parameters_.start + parameters_.length;
    if (end > frames.count() && parameters_.beyond == BeyondFrames::kRefuse) {
      return fail(ErrorKind::kData,
                  fmt::format("the window ends at frame {}, but the exploration has {}", end,
                              frames.count()),
                  {}, "use a shorter 'length', or beyond = \"hold\"");
    }
    Matrix<float> window(parameters_.length, frames.size());
    for (std::size_t i = 0; i < window.rows(); ++i) {
      write_dense(frames[std::min(parameters_.start + i, frames.count() - 1)], window.row(i));
    }
    return Sequence{Samples(std::move(window)), inputs.front()->rate};
  }

 private:
  Parameters parameters_;
};

class OnsetWindowModule : public WholeModule {
 public:
  using Parameters = OnsetParameters;
  explicit OnsetWindowModule(const Parameters& parameters) : parameters_(parameters) {}

  bool chooses_frames() const override { return true; }

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_frames(inputs.front()));
    PortType type = inputs.front().type;
    if (parameters_.element > type.size()) {
      return fail(ErrorKind::kUsage,
                  fmt::format("'element' is {}, but the input has {} elements", parameters_.element,
                              type.size()),
                  {}, "elements are counted from 1; 0 means any element");
    }
    type.sparse = false;
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override {
    return window_at_onset(dense_rows(inputs.front()->values), parameters_)
        .map([&](Matrix<float> window) {
          return Sequence{Samples(std::move(window)), inputs.front()->rate};
        });
  }

 private:
  Parameters parameters_;
};

class SpectrumModule : public WholeModule {
 public:
  using Parameters = SpectrumParameters;
  explicit SpectrumModule(const Parameters& parameters) : parameters_(parameters) {}

  // The lowest rate decides for all, so that a band is the same frequencies in every exploration.
  Table decide(const std::vector<Connection>& inputs, const RecordingLayout& /*layout*/) override {
    const double rate = inputs.front().rates.least;
    if (parameters_.rate || rate == 0.0 || !parameters_.depend_on_rate()) return {};
    parameters_.rate = rate;
    return {{}, {{"rate", {}, Parameters::declarations().find("rate")->read(parameters_)}}};
  }

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(parameters_.validate());
    const Connection& input = inputs.front();
    SOMATO_TRY_VOID(expect_frames(input));
    if (inputs.size() > 1 && inputs.back().type.size() != 1) {
      return fail(ErrorKind::kUsage, "a speed must be a single number", inputs.back().port,
                  "select one element");
    }
    if (inputs.size() > 1 && (parameters_.bands == 0 || !parameters_.high)) {
      return fail(ErrorKind::kUsage, "cycles per mm require 'bands' and 'high'", inputs.back().port,
                  "set both, or remove the speed");
    }
    spectrum_.emplace(parameters_);
    PortType type = once(input.type);
    type.sparse = false;
    type.shape = {input.type.size(), spectrum_->bands()};
    return checked_size(std::move(type), input.port);
  }

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override {
    std::optional<double> speed;
    if (inputs.size() > 1) speed = mean_of(*inputs.back());
    const Sequence& input = *inputs.front();
    return spectrum_->apply(dense_rows(input.values), input.rate, speed).map([](Signal spectrum) {
      return single(std::move(spectrum));
    });
  }

 private:
  static double mean_of(const Sequence& speed) {
    double sum = 0.0;
    for (std::size_t i = 0; i < speed.values.count(); ++i) {
      float value = 0.0F;
      write_dense(speed.values[i], {&value, 1});
      sum += double{value};
    }
    return sum / static_cast<double>(speed.values.count());
  }

  Parameters parameters_;
  std::optional<Spectrum> spectrum_;
};

}  // namespace

std::vector<ModuleType> feature_types() {
  return {
      describe<ChangeModule>("change",
                             "Difference between the last and the first frame of an exploration.",
                             {input_port("Frames.")}, "The shape of a frame."),
      describe<ResamplingModule>("resampling",
                                 "Resampling of an exploration of any length to a fixed number of "
                                 "points, by interpolation.",
                                 {input_port("Frames.")}, "Points x the shape of a frame."),
      describe<WindowModule>("window", "A fixed number of frames from a given one.",
                             {input_port("Frames.")}, "Frames of the same shape."),
      describe<OnsetWindowModule>("onset_window",
                                  "A fixed number of frames around the onset of contact.",
                                  {input_port("Frames.")}, "Frames of the same shape."),
      describe<MeanRemovalModule>("mean_removal", "Frames minus their mean over the exploration.",
                                  {input_port("Frames.")}, "Frames of the same shape."),
      describe<SpectrumModule>("spectrum",
                               "Power spectrum of each element of the frames (P11 IV-B).",
                               {input_port("Frames."),
                                {"speed",
                                 "A number in mm/s, averaged over its frames: frequencies are "
                                 "converted to cycles per mm.",
                                 false, false}},
                               "Elements x bands.")};
}

}  // namespace somato::modules
