#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "graph/modules/support.h"
#include "maps/map_parts.h"
#include "somato/codes/standardization.h"
#include "somato/core/check.h"

namespace somato::modules {
namespace {

class StandardizationModule : public MappedModule, public Learner {
 public:
  using Parameters = StandardizationParameters;
  explicit StandardizationModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    PortType type = inputs.front().type;
    type.sparse = false;
    shape_ = type.shape;
    columns_ = type.size();
    return checked_size(std::move(type), inputs.front().port);
  }

  Learner* learner() override { return this; }
  std::size_t memory() const override { return 2 * columns_ * sizeof(double); }

  Result<Signal> map(std::span<const SignalView> inputs) const override {
    require(standardization_.has_value(), "a standardization that has learned nothing");
    std::vector<float> values(columns_);
    standardization_->apply(inputs.front(), values);
    return Signal::dense(shape_, std::move(values));
  }

  bool learns_at_once() const override { return true; }
  bool learns_by_draws() const override { return false; }

  Result<void> learn(const Lesson& /*lesson*/, const TrainingInputs& explorations) override {
    auto fitted = Standardization::fit(all_values(explorations), parameters_);
    if (!fitted) return fail(std::move(fitted.error()));
    standardization_ = std::move(*fitted);
    return {};
  }

  void save(Archive& archive, const std::string& prefix) const override {
    require(standardization_.has_value(), "a standardization that has learned nothing");
    archive.add(prefix + "means", Array<double>{{columns_}, standardization_->means});
    archive.add(prefix + "deviations", Array<double>{{columns_}, standardization_->deviations});
  }

  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override {
    auto means = archive.get<Array<double>>(prefix + "means", where);
    if (!means) return fail(std::move(means.error()));
    auto deviations = archive.get<Array<double>>(prefix + "deviations", where);
    if (!deviations) return fail(std::move(deviations.error()));
    const std::vector<std::uint64_t> shape{columns_};
    bool possible = (*means)->shape == shape && (*deviations)->shape == shape;
    for (std::size_t i = 0; possible && i < columns_; ++i) {
      const double deviation = (*deviations)->values[i];
      possible = std::isfinite((*means)->values[i]) && std::isfinite(deviation) && deviation >= 0.0;
    }
    if (!possible) return damaged_model("a standardization does not fit or is not finite", where);
    standardization_ = Standardization{(*means)->values, (*deviations)->values};
    return {};
  }

 private:
  Parameters parameters_;
  std::vector<std::size_t> shape_;
  std::size_t columns_ = 0;
  std::optional<Standardization> standardization_;
};

struct ScaleParameters {
  double factor = 1.0;
  double offset = 0.0;
  bool rectify = false;

  static const Declarations<ScaleParameters>& declarations() {
    using P = ScaleParameters;
    static const auto declared =
        Declarations<P>()
            .add("factor", &P::factor, "", Range::between(-1e30, 1e30),
                 "What every element is multiplied by.")
            .add("offset", &P::offset, "", Range::between(-1e30, 1e30), "What is then added.")
            .add("rectify", &P::rectify, "", Range::any(),
                 "Whether what is then below 0 becomes 0.");
    return declared;
  }
};

class ScaleModule : public MappedModule {
 public:
  using Parameters = ScaleParameters;
  explicit ScaleModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    type_ = inputs.front().type;
    type_.sparse = type_.sparse && parameters_.offset == 0.0;
    return checked_size(type_, inputs.front().port);
  }

  Result<Signal> map(std::span<const SignalView> inputs) const override {
    Signal signal = copy_of(inputs.front(), type_.shape);
    if (signal.is_sparse() && !type_.sparse) signal = Signal::dense(type_.shape, signal.to_dense());
    for (float& value : signal.values()) {
      const double scaled = parameters_.factor * double{value} + parameters_.offset;
      value = static_cast<float>(parameters_.rectify && scaled < 0.0 ? 0.0 : scaled);
      if (std::isfinite(value)) continue;
      return fail(ErrorKind::kData, "a scaled value is too large for single precision", {},
                  "choose a smaller 'factor' or 'offset'");
    }
    return signal;
  }

 private:
  Parameters parameters_;
  PortType type_;
};

}  // namespace

std::vector<ModuleType> scaling_types() {
  return {describe<ScaleModule>("scale", "Every element times a factor, plus an offset.",
                                {input_port("Any signal.")}, "The shape of the input."),
          describe<StandardizationModule>(
              "standardization",
              "Every element with mean 0 and standard deviation 1 over what is learned from.",
              {input_port("Any signal.")}, "The shape of the input.", true)};
}

}  // namespace somato::modules
