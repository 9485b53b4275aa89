#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "graph/modules/sum_of_frames.h"
#include "graph/modules/support.h"
#include "maps/map_parts.h"
#include "somato/codes/concatenation.h"
#include "somato/codes/normalization.h"
#include "somato/codes/one_hot.h"
#include "somato/codes/tensor_product.h"
#include "somato/core/check.h"

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
                 "Lower end of the range, one for all elements or one each; none: the least value "
                 "met while learning. Not given in the paper.")
            .add("high", &P::high, "the input's", Range::any(),
                 "Upper end of the range, as 'low'. Not given in the paper.")
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
      return fail(
          ErrorKind::kUsage,
          fmt::format("'{}' has {} numbers, but {} elements come in", name, ends->size(), inputs_),
          {}, "give one number for all or one for each");
    }
    // Checked as if it were dense: the edges of all bins are kept.
    PortType type{input.rate, input.shape, false, input.clock};
    if (type.size() == 1) type.shape.clear();
    type.shape.push_back(parameters_.code.elements);
    shape_ = type.shape;
    auto checked = checked_size(std::move(type), inputs.front().port);
    if (!checked) return checked;
    checked->sparse = true;
    if (learner() != nullptr) return checked;
    if (auto made = make(parameters_.low, parameters_.high); !made) return fail(made.error());
    return checked;
  }

  Learner* learner() override {
    return parameters_.low.empty() || parameters_.high.empty() ? this : nullptr;
  }

  Result<Signal> map(std::span<const SignalView> inputs) const override {
    require(code_.has_value(), "a one-hot code whose ranges are not learned");
    std::vector<float> values(inputs_);
    write_dense(inputs.front(), values);
    Result<Signal> code = code_->encode(values);
    if (!code) return code;
    return copy_of(code->view(), shape_);
  }

  Result<void> write(std::span<const SignalView> inputs, Room& room) const override {
    require(code_.has_value(), "a one-hot code whose ranges are not learned");
    std::vector<float>& values = room.scratch.begin_dense(inputs_);
    write_dense(inputs.front(), values);
    return code_->encode(values, room.output);
  }

  bool learns_at_once() const override { return true; }
  bool learns_by_draws() const override { return false; }

  Result<void> learn(const Lesson& /*lesson*/, const TrainingInputs& explorations) override {
    std::vector<double> low(inputs_, std::numeric_limits<double>::infinity());
    std::vector<double> high(inputs_, -std::numeric_limits<double>::infinity());
    for (const auto& ports : explorations) widen(dense_rows(*ports.front()), low, high);
    const bool learns_both = parameters_.low.empty() && parameters_.high.empty();
    for (std::size_t i = 0; learns_both && i < inputs_; ++i) {
      if (low[i] < high[i]) continue;
      return fail(
          ErrorKind::kData,
          fmt::format("element {} is {} in everything there is to learn from", i + 1, low[i]), {},
          "give its range as 'low' and 'high', or leave it out");
    }
    return make(parameters_.low.empty() ? low : parameters_.low,
                parameters_.high.empty() ? high : parameters_.high);
  }

  void save(Archive& archive, const std::string& prefix) const override {
    require(code_.has_value(), "a one-hot code whose ranges are not learned");
    archive.add(prefix + "low", Array<double>{{low_.size()}, low_});
    archive.add(prefix + "high", Array<double>{{high_.size()}, high_});
  }

  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override {
    auto low = archive.get<Array<double>>(prefix + "low", where);
    if (!low) return fail(std::move(low.error()));
    auto high = archive.get<Array<double>>(prefix + "high", where);
    if (!high) return fail(std::move(high.error()));
    const std::vector<std::uint64_t> shape{inputs_};
    if ((*low)->shape != shape || (*high)->shape != shape) {
      return damaged_model("the ranges of a one-hot code do not fit", where);
    }
    auto made = make((*low)->values, (*high)->values);
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
            fmt::format("'low' is {} and 'high' {} for element {}", low_[i], high_[i], i + 1), {},
            "'low' must be less than 'high', both in the range of single precision");
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
  std::vector<std::size_t> shape_;
  std::vector<double> low_;
  std::vector<double> high_;
  std::optional<OneHotSequence> code_;
};

// Several inputs that come together become one.
class CombiningModule : public MappedModule {
 public:
  using Parameters = NoParameters;

 protected:
  std::vector<Signal> shaped(std::span<const SignalView> inputs) const {
    std::vector<Signal> signals;
    signals.reserve(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      signals.push_back(copy_of(inputs[i], types_[i].shape));
    }
    return signals;
  }

  Result<void> remember(const std::vector<Connection>& inputs) {
    for (const Connection& input : inputs) types_.push_back(input.type);
    return expect_together(inputs);
  }

  const std::vector<PortType>& types() const { return types_; }

 private:
  std::vector<PortType> types_;
};

class TensorProductModule : public CombiningModule {
 public:
  explicit TensorProductModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    if (auto together = remember(inputs); !together) return fail(together.error());
    PortType type{types().front().rate, {}, false, types().front().clock};
    for (const PortType& input : types()) {
      type.shape.insert(type.shape.end(), input.shape.begin(), input.shape.end());
      type.sparse = type.sparse || input.sparse;
    }
    return checked_size(std::move(type), inputs.back().port);
  }

  Result<Signal> map(std::span<const SignalView> inputs) const override {
    return tensor_product(shaped(inputs));
  }

  Result<void> write(std::span<const SignalView> inputs, Room& room) const override {
    tensor_product(inputs, room.scratch, room.output);
    return {};
  }
};

class ConcatenationModule : public CombiningModule {
 public:
  explicit ConcatenationModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    if (auto together = remember(inputs); !together) return fail(together.error());
    PortType type{types().front().rate, {0}, true, types().front().clock};
    for (const PortType& input : types()) {
      type.shape[0] += input.size();
      type.sparse = type.sparse && input.sparse;
    }
    return checked_size(std::move(type), inputs.back().port);
  }

  Result<Signal> map(std::span<const SignalView> inputs) const override {
    return concatenation(shaped(inputs));
  }

  Result<void> write(std::span<const SignalView> inputs, Room& room) const override {
    std::size_t size = 0;
    bool sparse = true;
    for (const SignalView& input : inputs) {
      size += input.size;
      sparse = sparse && input.sparse;
    }
    if (sparse) {
      write_sparse(inputs, size, room.output);
    } else {
      write_all(inputs, room.output.begin_dense(size));
    }
    return {};
  }

 private:
  static void write_sparse(std::span<const SignalView> inputs, std::size_t size,
                           SignalBuffer& out) {
    out.begin_sparse(size);
    std::uint32_t start = 0;
    for (const SignalView& input : inputs) {
      for (std::size_t i = 0; i < input.indices.size(); ++i) {
        out.add(start + input.indices[i], input.values[i]);
      }
      start += static_cast<std::uint32_t>(input.size);
    }
  }

  static void write_all(std::span<const SignalView> inputs, std::span<float> out) {
    for (const SignalView& input : inputs) {
      write_dense(input, out.first(input.size));
      out = out.subspan(input.size);
    }
  }
};

class SumModule : public CombiningModule {
 public:
  explicit SumModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    if (auto together = remember(inputs); !together) return fail(together.error());
    for (const Connection& input : inputs) {
      if (input.type.shape == types().front().shape) continue;
      return fail(
          ErrorKind::kUsage,
          fmt::format("{} elements cannot be added to {}", fmt::join(input.type.shape, " x "),
                      fmt::join(types().front().shape, " x ")),
          input.port, "give it inputs of one shape");
    }
    PortType type = types().front();
    type.sparse = false;
    return checked_size(std::move(type), inputs.front().port);
  }

  Result<Signal> map(std::span<const SignalView> inputs) const override {
    std::vector<float> sum(inputs.front().size);
    std::vector<float> values(sum.size());
    for (const SignalView& input : inputs) {
      write_dense(input, values);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += values[i];
    }
    return Signal::dense(types().front().shape, std::move(sum));
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

class NormalizationModule : public MappedModule, public DividedByNorm {
 public:
  using Parameters = NormalizationParameters;
  explicit NormalizationModule(const Parameters& parameters) : norm_(parameters.norm) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    type_ = inputs.front().type;
    return type_;
  }

  Result<Signal> map(std::span<const SignalView> inputs) const override {
    return normalized(norm_, copy_of(inputs.front(), type_.shape));
  }

  Result<void> write(std::span<const SignalView> inputs, Room& room) const override {
    room.output.assign(inputs.front());
    normalize(norm_, room.output.values());
    return {};
  }

  Norm norm() const override { return norm_; }

 private:
  Norm norm_;
  PortType type_;
};

}  // namespace

std::vector<ModuleType> code_types() {
  return {
      describe<OneHotModule>(
          "one_hot", "Each element by the one of several bins that holds it (P06 section 2.1).",
          {input_port("Numbers.")},
          "The input's shape with an axis of bins added; sparse. A single number: the bins.", true),
      describe<TensorProductModule>("tensor_product",
                                    "A place for every combination of elements (P06 section 1).",
                                    {input_ports("One or more signals, in their order.")},
                                    "The shapes of the inputs, one after the other."),
      describe<ConcatenationModule>("concatenation", "Signals one after the other.",
                                    {input_ports("One or more signals, in their order.")},
                                    "A vector of all elements."),
      describe<SumModule>("sum", "Signals added, element by element.",
                          {input_ports("Signals of one shape.")}, "The shape of the inputs."),
      describe<NormalizationModule>("normalization", "A signal divided by its norm.",
                                    {input_port("Any signal; zeros stay.")},
                                    "The shape of the input.")};
}

}  // namespace somato::modules
