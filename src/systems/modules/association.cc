#include "systems/modules/support.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "maps/som/map_parts.h"
#include "somato/core/check.h"

namespace somato::modules {
namespace {

struct AssociationParameters {
  double learning_rate = 0.1;
  bool normalize_input = true;
  std::uint64_t iterations = 1000;

  static const Declarations<AssociationParameters>& declarations() {
    using P = AssociationParameters;
    static const auto declared =
        Declarations<P>()
            .add("learning_rate", &P::learning_rate, "", Range::between(0.0, 1.0),
                 "Share of the error that is removed when one value is learned, for an input of "
                 "length 1.")
            .add("normalize_input", &P::normalize_input, "", Range::any(),
                 "Whether the input is scaled to Euclidean length 1; zeros are preserved. Without, "
                 "learning diverges for inputs longer than sqrt(2 / learning_rate).")
            .add("iterations", &P::iterations, "", Range::between(1, 1e15),
                 "Number of draws, unless its [[phase]] sets it.");
    return declared;
  }
};

// Weights from an input, here called x, to a target of another length; W x is the prediction.
class Association {
 public:
  Association() = default;
  Association(std::size_t targets, std::size_t inputs) : weights_(inputs, targets) {}

  std::size_t targets() const { return weights_.columns(); }
  const Matrix<float>& weights() const { return weights_; }
  Matrix<float>& weights() { return weights_; }

  void predict(std::span<const float> x, std::span<float> prediction) const {
    std::fill(prediction.begin(), prediction.end(), 0.0F);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i] != 0.0F) add(x[i], weights_.row(i), prediction);
    }
  }

  // The delta rule: W += learning_rate (target - W x) x'.
  void learn(std::span<const float> x, std::span<const float> target, float learning_rate) {
    error_.resize(targets());
    predict(x, error_);
    for (std::size_t j = 0; j < error_.size(); ++j) error_[j] = target[j] - error_[j];
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i] != 0.0F) add(learning_rate * x[i], error_, weights_.row(i));
    }
  }

 private:
  static void add(float factor, std::span<const float> values, std::span<float> to) {
    for (std::size_t j = 0; j < to.size(); ++j) to[j] += factor * values[j];
  }

  Matrix<float> weights_;  // a row for each element of the input, so that zeros cost nothing
  std::vector<float> error_;
};

// A signal as numbers, of length 1 if that is wanted.
class InputReader {
 public:
  explicit InputReader(bool normalize) : normalize_(normalize) {}

  std::span<const float> read(const SignalView& signal) {
    values_.resize(signal.size);
    write_dense(signal, values_);
    if (!normalize_) return values_;
    double squares = 0.0;
    for (const float value : values_) {
      squares += static_cast<double>(value) * static_cast<double>(value);
    }
    if (squares > 0.0) {
      const auto factor = static_cast<float>(1.0 / std::sqrt(squares));
      for (float& value : values_) value *= factor;
    }
    return values_;
  }

 private:
  bool normalize_;
  std::vector<float> values_;
};

class AssociationRunner : public Runner {
 public:
  AssociationRunner(const Association& association, bool normalize)
      : association_(association), input_(normalize) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    association_.predict(input_.read(inputs.front()), out.begin_dense(association_.targets()));
    return {};
  }

 private:
  const Association& association_;
  InputReader input_;
};

class AssociationModule : public Module, public Learner {
 public:
  using Parameters = AssociationParameters;
  explicit AssociationModule(const Parameters& parameters)
      : parameters_(parameters), input_(parameters.normalize_input), target_(false) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_together(inputs));
    const PortType& target = inputs.back().type;
    inputs_ = inputs.front().type.size();
    targets_ = target.size();
    SOMATO_TRY_VOID(check_memory(targets_, inputs_, inputs.front().port));
    PortType output = target;
    output.sparse = false;
    return checked_size(std::move(output), inputs.back().port);
  }

  Learner* learner() override { return this; }
  std::size_t memory() const override { return inputs_ * targets_ * sizeof(float); }

  std::unique_ptr<Runner> start() const override {
    require(association_.has_value(), "an association must be trained before it is used");
    return std::make_unique<AssociationRunner>(*association_, parameters_.normalize_input);
  }

  bool learns_at_once() const override { return false; }
  bool learns_by_draws() const override { return true; }
  bool begins_without_inputs() const override { return true; }

  Result<std::uint64_t> begin(const LearningPlan& plan,
                              const TrainingInputs& /*explorations*/) override {
    association_.emplace(targets_, inputs_);
    return plan.draws.value_or(parameters_.iterations);
  }

  Result<void> step(std::span<const SignalView> inputs, std::uint64_t /*draw*/) override {
    association_->learn(input_.read(inputs.front()), target_.read(inputs.back()),
                        static_cast<float>(parameters_.learning_rate));
    return {};
  }

  void save(Archive& archive, const std::string& prefix) const override {
    require(association_.has_value(), "an association must be trained before it is saved");
    add_matrix(archive, prefix + "weights", association_->weights());
  }

  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override {
    SOMATO_TRY(auto weights, matrix_from(archive, prefix + "weights", where));
    if (weights.rows() != inputs_ || weights.columns() != targets_) {
      return damaged_model("the association does not fit its module", where);
    }
    association_.emplace(targets_, inputs_);
    association_->weights() = std::move(weights);
    return {};
  }

 private:
  Parameters parameters_;
  std::size_t inputs_ = 0;
  std::size_t targets_ = 0;
  std::optional<Association> association_;
  InputReader input_;
  InputReader target_;
};

}  // namespace

std::vector<ModuleType> association_types() {
  return {describe<AssociationModule>(
      "association",
      "A linear network that learns to predict one signal from another by the delta rule, such as "
      "the activity of a map from that of another map: an A-SOM's ancillary weights (Johnsson, "
      "Balkenius and Hesslow, 2009).",
      {{"input", "The signal to predict from, such as the activity of another map.", true, false},
       {"target", "The signal to predict; it affects learning only.", true, false}},
      "The prediction, in the target's shape.", true)};
}

}  // namespace somato::modules
