#include "systems/modules/support.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "maps/som/map_parts.h"
#include "somato/codes/standardization.h"
#include "somato/core/check.h"
#include "systems/signals/logarithm.h"

namespace somato::modules {
namespace {

class StandardizationModule : public MappedModule, public Learner {
 public:
  using Parameters = StandardizationParameters;
  explicit StandardizationModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    PortType type = inputs.front().type;
    type.sparse = false;
    columns_ = type.size();
    return checked_size(std::move(type), inputs.front().port);
  }

  Learner* learner() override { return this; }
  std::size_t memory() const override { return 2 * columns_ * sizeof(double); }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& /*scratch*/) const override {
    require(standardization_.has_value(), "a standardization must be fitted first");
    standardization_->apply(inputs.front(), out.begin_dense(columns_));
    return {};
  }

  bool learns_at_once() const override { return true; }
  bool learns_by_draws() const override { return false; }

  Result<void> learn(const LearningPlan& /*plan*/, const TrainingInputs& explorations) override {
    SOMATO_TRY(auto fitted, Standardization::fit(all_values(explorations), parameters_));
    standardization_ = std::move(fitted);
    return {};
  }

  void save(Archive& archive, const std::string& prefix) const override {
    require(standardization_.has_value(), "a standardization must be fitted first");
    archive.add(prefix + "means", Array<double>{{columns_}, standardization_->means});
    archive.add(prefix + "deviations", Array<double>{{columns_}, standardization_->deviations});
  }

  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override {
    SOMATO_TRY(auto means, archive.get<Array<double>>(prefix + "means", where));
    SOMATO_TRY(auto deviations, archive.get<Array<double>>(prefix + "deviations", where));
    const std::vector<std::uint64_t> shape{columns_};
    bool possible = means->shape == shape && deviations->shape == shape;
    for (std::size_t i = 0; possible && i < columns_; ++i) {
      const double deviation = deviations->values[i];
      possible = std::isfinite(means->values[i]) && std::isfinite(deviation) && deviation >= 0.0;
    }
    if (!possible) return damaged_model("a standardization does not fit or is not finite", where);
    standardization_ = Standardization{means->values, deviations->values};
    return {};
  }

 private:
  Parameters parameters_;
  std::size_t columns_ = 0;
  std::optional<Standardization> standardization_;
};

struct ScaleParameters {
  double factor = 1.0;
  double offset = 0.0;
  bool rectify = false;

  static const Declarations<ScaleParameters>& declarations() {
    using P = ScaleParameters;
    static const auto declared = Declarations<P>()
                                     .add("factor", &P::factor, "", Range::between(-1e30, 1e30),
                                          "Factor by which every element is multiplied.")
                                     .add("offset", &P::offset, "", Range::between(-1e30, 1e30),
                                          "Value added after the multiplication.")
                                     .add("rectify", &P::rectify, "", Range::any(),
                                          "Whether negative results are set to 0.");
    return declared;
  }
};

class ScaleModule : public MappedModule {
 public:
  using Parameters = ScaleParameters;
  explicit ScaleModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    PortType type = inputs.front().type;
    type.sparse = type.sparse && parameters_.offset == 0.0;
    stays_sparse_ = type.sparse;
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& /*scratch*/) const override {
    const SignalView& input = inputs.front();
    if (stays_sparse_) {
      out.assign(input);
    } else {
      write_dense(input, out.begin_dense(input.size));
    }
    for (float& value : out.values()) {
      const double scaled = parameters_.factor * double{value} + parameters_.offset;
      value = static_cast<float>(parameters_.rectify && scaled < 0.0 ? 0.0 : scaled);
      if (std::isfinite(value)) continue;
      return fail(ErrorKind::kData, "a scaled value is too large for single precision", {},
                  "use a smaller 'factor' or 'offset'");
    }
    return {};
  }

 private:
  Parameters parameters_;
  bool stays_sparse_ = false;
};

class LogarithmModule : public MappedModule {
 public:
  using Parameters = LogarithmParameters;
  explicit LogarithmModule(const Parameters& parameters) : parameters_(parameters) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    return checked_size(inputs.front().type, inputs.front().port);
  }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& /*scratch*/) const override {
    out.assign(inputs.front());
    for (float& value : out.values()) {
      value = static_cast<float>(signed_logarithm(value, parameters_.unit));
    }
    return {};
  }

 private:
  Parameters parameters_;
};

}  // namespace

std::vector<ModuleType> scaling_types() {
  return {
      describe<LogarithmModule>(
          "logarithm",
          "The logarithm of the magnitude of every element, with its sign: sign(x) log(1 + |x| / "
          "unit). Small differences of small values count as much as large ones of large values.",
          {input_port("Any signal.")}, "The shape of the input."),
      describe<ScaleModule>("scale", "Every element multiplied by a factor, plus an offset.",
                            {input_port("Any signal.")}, "The shape of the input."),
      describe<StandardizationModule>(
          "standardization",
          "Every element standardized to mean 0 and standard deviation 1 over the training data.",
          {input_port("Any signal.")}, "The shape of the input.", true)};
}

}  // namespace somato::modules
