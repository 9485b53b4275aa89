#include "systems/modules/support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/core/dense_rows.h"
#include "maps/som/map_parts.h"
#include "somato/codes/concatenation.h"
#include "somato/codes/normalization.h"
#include "somato/codes/one_hot.h"
#include "somato/codes/tensor_product.h"
#include "somato/core/check.h"
#include "systems/modules/sum_of_frames.h"

namespace somato::modules {
namespace {

struct OneHotModuleParameters {
  std::vector<double> low;
  std::vector<double> high;
  OneHotParameters code;  // but for its range

  static const Declarations<OneHotModuleParameters>& declarations() {
    using P = OneHotModuleParameters;
    static const auto declared =
        Declarations<P>()
            .add("low", &P::low, "the input's", Range::any(),
                 "Lower end of the range, one value for all elements or one for each; empty: the "
                 "smallest value in training. Not given in the paper.")
            .add("high", &P::high, "the input's", Range::any(),
                 "Upper end of the range, as for 'low'. Not given in the paper.")
            .add_from(&P::code, OneHotParameters::declarations(), {"elements", "outside"});
    return declared;
  }
};

class OneHotModule : public MappedModule, public Learner {
 public:
  using Parameters = OneHotModuleParameters;
  explicit OneHotModule(Parameters parameters) : parameters_(std::move(parameters)) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    const PortType& input = inputs.front().type;
    inputs_ = input.size();
    for (const auto& [name, ends] :
         {std::pair{"low", &parameters_.low}, std::pair{"high", &parameters_.high}}) {
      if (ends->empty() || ends->size() == 1 || ends->size() == inputs_) continue;
      return fail(ErrorKind::kUsage,
                  fmt::format("'{}' has {} numbers, but the input has {} elements", name,
                              ends->size(), inputs_),
                  {}, "use one number for all elements, or one for each");
    }
    // Checked as if it were dense: the edges of all bins are kept.
    PortType type{input.rate, input.shape, false, input.clock};
    if (type.size() == 1) type.shape.clear();
    type.shape.push_back(parameters_.code.elements);
    auto checked = checked_size(std::move(type), inputs.front().port);
    if (!checked) return checked;
    checked->sparse = true;
    if (learner() != nullptr) return checked;
    SOMATO_TRY_VOID(make(parameters_.low, parameters_.high));
    return checked;
  }

  Learner* learner() override {
    return parameters_.low.empty() || parameters_.high.empty() ? this : nullptr;
  }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& scratch) const override {
    require(code_.has_value(), "the ranges of a one-hot code must be learned first");
    std::vector<float>& values = scratch.begin_dense(inputs_);
    write_dense(inputs.front(), values);
    return code_->encode(values, out);
  }

  bool learns_at_once() const override { return true; }
  bool learns_by_draws() const override { return false; }

  Result<void> learn(const LearningPlan& /*plan*/, const TrainingInputs& explorations) override {
    std::vector<double> low(inputs_, std::numeric_limits<double>::infinity());
    std::vector<double> high(inputs_, -std::numeric_limits<double>::infinity());
    for (const auto& ports : explorations) widen(dense_rows(ports.front()->values), low, high);
    const bool learns_both = parameters_.low.empty() && parameters_.high.empty();
    for (std::size_t i = 0; learns_both && i < inputs_; ++i) {
      if (low[i] < high[i]) continue;
      return fail(ErrorKind::kData,
                  fmt::format("element {} is {} in all training data", i + 1, low[i]), {},
                  "set its range with 'low' and 'high', or leave the element out");
    }
    return make(parameters_.low.empty() ? low : parameters_.low,
                parameters_.high.empty() ? high : parameters_.high);
  }

  void save(Archive& archive, const std::string& prefix) const override {
    require(code_.has_value(), "the ranges of a one-hot code must be learned first");
    archive.add(prefix + "low", Array<double>{{low_.size()}, low_});
    archive.add(prefix + "high", Array<double>{{high_.size()}, high_});
  }

  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override {
    SOMATO_TRY(auto low, archive.get<Array<double>>(prefix + "low", where));
    SOMATO_TRY(auto high, archive.get<Array<double>>(prefix + "high", where));
    const std::vector<std::uint64_t> shape{inputs_};
    if (low->shape != shape || high->shape != shape) {
      return damaged_model("the ranges of a one-hot code do not fit", where);
    }
    auto made = make(low->values, high->values);
    return made ? made : damaged_model(std::move(made.error()), where);
  }

 private:
  static void widen(const Matrix<float>& rows, std::vector<double>& low,
                    std::vector<double>& high) {
    for (std::size_t row = 0; row < rows.rows(); ++row) {
      for (std::size_t i = 0; i < rows.columns(); ++i) {
        low[i] = std::min(low[i], double{rows(row, i)});
        high[i] = std::max(high[i], double{rows(row, i)});
      }
    }
  }

  Result<void> make(const std::vector<double>& low, const std::vector<double>& high) {
    low_.assign(inputs_, 0.0);
    high_.assign(inputs_, 0.0);
    std::vector<OneHotParameters> joints;
    joints.reserve(inputs_);
    for (std::size_t i = 0; i < inputs_; ++i) {
      low_[i] = low[low.size() == 1 ? 0 : i];
      high_[i] = high[high.size() == 1 ? 0 : i];
      const auto first = static_cast<float>(low_[i]);
      const auto last = static_cast<float>(high_[i]);
      if (!std::isfinite(first) || !std::isfinite(last) || first >= last) {
        return fail(
            ErrorKind::kUsage,
            fmt::format("'low' is {} and 'high' is {} for element {}", low_[i], high_[i], i + 1),
            {}, "'low' must be below 'high', both within the range of single precision");
      }
      joints.push_back(parameters_.code);
      joints.back().low = low_[i];
      joints.back().high = high_[i];
    }
    code_.emplace(joints);
    return {};
  }

  Parameters parameters_;
  std::size_t inputs_ = 0;
  std::vector<double> low_;
  std::vector<double> high_;
  std::optional<OneHotSequence> code_;
};

class TensorProductModule : public MappedModule {
 public:
  using Parameters = NoParameters;
  explicit TensorProductModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_together(inputs));
    const PortType& first = inputs.front().type;
    PortType type{first.rate, {}, false, first.clock};
    for (const Connection& input : inputs) {
      type.shape.insert(type.shape.end(), input.type.shape.begin(), input.type.shape.end());
      type.sparse = type.sparse || input.type.sparse;
    }
    return checked_size(std::move(type), inputs.back().port);
  }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& scratch) const override {
    tensor_product(inputs, scratch, out);
    return {};
  }
};

class ConcatenationModule : public MappedModule {
 public:
  using Parameters = NoParameters;
  explicit ConcatenationModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_together(inputs));
    const PortType& first = inputs.front().type;
    PortType type{first.rate, {0}, true, first.clock};
    for (const Connection& input : inputs) {
      type.shape[0] += input.type.size();
      type.sparse = type.sparse && input.type.sparse;
    }
    return checked_size(std::move(type), inputs.back().port);
  }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& /*scratch*/) const override {
    concatenation(inputs, out);
    return {};
  }
};

class SumModule : public MappedModule {
 public:
  using Parameters = NoParameters;
  explicit SumModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_together(inputs));
    PortType type = inputs.front().type;
    for (const Connection& input : inputs) {
      if (input.type.shape == type.shape) continue;
      return fail(ErrorKind::kUsage,
                  fmt::format("{} elements cannot be added to {}",
                              fmt::join(input.type.shape, " x "), fmt::join(type.shape, " x ")),
                  input.port, "use inputs of the same shape");
    }
    type.sparse = false;
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& scratch) const override {
    std::vector<float>& sum = out.begin_dense(inputs.front().size);
    std::vector<float>& values = scratch.begin_dense(sum.size());
    std::fill(sum.begin(), sum.end(), 0.0F);
    for (const SignalView& input : inputs) {
      write_dense(input, values);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += values[i];
    }
    return {};
  }
};

struct NormalizationParameters {
  Norm norm = Norm::kL2;

  static const Declarations<NormalizationParameters>& declarations() {
    using P = NormalizationParameters;
    static const auto declared = Declarations<P>().add(
        "norm", &P::norm, "", Range::any(), "The norm that becomes 1. Not given in the paper.");
    return declared;
  }
};

class NormalizationModule : public MappedModule {
 public:
  using Parameters = NormalizationParameters;
  explicit NormalizationModule(const Parameters& parameters) : norm_(parameters.norm) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    return inputs.front().type;
  }

  Result<void> map(std::span<const SignalView> inputs, SignalBuffer& out,
                   SignalBuffer& /*scratch*/) const override {
    out.assign(inputs.front());
    normalize(norm_, out.values());
    return {};
  }

  Norm norm() const { return norm_; }

 private:
  Norm norm_;
};

}  // namespace

std::optional<Norm> norm_divided_by(const Module& module) {
  const auto* normalization = dynamic_cast<const NormalizationModule*>(&module);
  if (normalization == nullptr) return {};
  return normalization->norm();
}

std::vector<ModuleType> code_types() {
  return {
      describe<OneHotModule>(
          "one_hot",
          "One-hot code of each element: the bin that contains its value (P06 section 2.1).",
          {input_port("Numbers.")},
          "The input's shape with an axis of bins appended; sparse. For a single number: the bins.",
          true),
      describe<TensorProductModule>(
          "tensor_product",
          "Tensor product: one element for each combination of input elements (P06 section 1).",
          {input_ports("One or more signals, in order.")},
          "The shapes of the inputs, concatenated."),
      describe<ConcatenationModule>("concatenation", "Concatenation of signals.",
                                    {input_ports("One or more signals, in order.")},
                                    "A vector of all elements."),
      describe<SumModule>("sum", "Sum of signals, element by element.",
                          {input_ports("Signals of the same shape.")}, "The shape of the inputs."),
      describe<NormalizationModule>("normalization", "A signal divided by its norm.",
                                    {input_port("Any signal; zeros are preserved.")},
                                    "The shape of the input.")};
}

}  // namespace somato::modules
