#include "systems/modules/support.h"

#include "somato/maps/t_mpsom.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "maps/som/map_parts.h"
#include "maps/t_mpsom/t_mpsom_archive.h"
#include "maps/t_mpsom/t_mpsom_learner.h"
#include "somato/core/check.h"

namespace somato::modules {
namespace {

// The parameters of a T-MPSOM in a description: all except those derived from its inputs.
struct TMpsomModuleParameters {
  TMpsomParameters map;

  static const Declarations<TMpsomModuleParameters>& declarations() {
    using P = TMpsomModuleParameters;
    static const auto declared = Declarations<P>().add_from(
        &P::map, TMpsomParameters::declarations(),
        {"shape", "input_axes", "combination", "arbor_sigma", "neighbourhood_sigma",
         "learning_rate_schedule", "learning_rate_start", "learning_rate_end",
         "learning_rate_reached_at", "input_norm", "weight_norm", "iterations"});
    return declared;
  }
};

// A T-MPSOM throws if numbers leave their range, which without norms depends on its input.
template <typename Work>
Result<void> in_range(const Work& work) {
  try {
    work();
    return {};
  } catch (const InvalidArgument& error) {
    return fail(ErrorKind::kData, error.what(), {}, "scale its input, or use norms");
  }
}

class TMpsomRunner : public Runner {
 public:
  using Activation = std::function<void(std::span<const SignalView>, std::span<float>)>;

  TMpsomRunner(std::size_t neurons, Activation activation)
      : neurons_(neurons), activation_(std::move(activation)) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    return in_range([&] { activation_(inputs, out.begin_dense(neurons_)); });
  }

 private:
  std::size_t neurons_;
  Activation activation_;
};

class TMpsomModule : public Module, public Learner {
 public:
  using Parameters = TMpsomModuleParameters;
  explicit TMpsomModule(Parameters parameters) : parameters_(std::move(parameters.map)) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    SOMATO_TRY_VOID(expect_together(inputs));
    std::size_t elements = 0;
    for (const Connection& input : inputs) {
      parameters_.input_sizes.push_back(input.type.size());
      elements += input.type.size();
    }
    SOMATO_TRY_VOID(parameters_.validate());
    // Weights, arbors, and as much again while learning.
    SOMATO_TRY_VOID(check_memory(parameters_.neurons(), 4 * elements, inputs.front().port));
    const PortType& first = inputs.front().type;
    return checked_size({first.rate, parameters_.shape, false, first.clock}, inputs.front().port);
  }

  Learner* learner() override { return this; }
  std::unique_ptr<Runner> start() const override {
    require(map_.has_value(), "a T-MPSOM must be trained before it is used");
    return std::make_unique<TMpsomRunner>(parameters_.neurons(), activation());
  }

  std::size_t memory() const override {
    std::size_t elements = 0;
    for (const std::size_t size : parameters_.input_sizes) elements += size;
    return 2 * parameters_.neurons() * elements * sizeof(float);
  }

  bool learns_at_once() const override { return false; }
  bool learns_by_draws() const override { return true; }
  bool begins_without_inputs() const override { return true; }

  Result<std::uint64_t> begin(const LearningPlan& plan,
                              const TrainingInputs& /*explorations*/) override {
    TMpsomParameters parameters = parameters_;
    parameters.seed = plan.seed;
    parameters.iterations = plan.draws.value_or(parameters.iterations);
    SOMATO_TRY_VOID(parameters.validate());
    learner_.reset();
    map_.emplace(parameters);
    learner_ = std::make_unique<TMpsomLearner>(*map_);
    return parameters.iterations;
  }

  Result<void> step(std::span<const SignalView> inputs, std::uint64_t draw) override {
    return in_range([&] { learner_->learn(inputs, map_->parameters().learning_rate().at(draw)); });
  }

  void finish() override { learner_.reset(); }

  void save(Archive& archive, const std::string& prefix) const override {
    require(map_.has_value(), "a T-MPSOM must be trained before it is saved");
    add_t_mpsom(archive, prefix, *map_);
  }

  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override {
    SOMATO_TRY(auto map, t_mpsom_from(archive, prefix, where));
    if (map.parameters().input_sizes != parameters_.input_sizes ||
        map.parameters().shape != parameters_.shape) {
      return damaged_model("the T-MPSOM does not fit its module", where);
    }
    learner_.reset();
    map_ = std::move(map);
    return {};
  }

 private:
  // That of the map, or of its learner while it learns.
  TMpsomRunner::Activation activation() const {
    if (learner_) {
      return
          [learner = learner_.get()](auto inputs, auto out) { learner->activation(inputs, out); };
    }
    return [&map = *map_, workspace = TMpsom::Workspace(*map_)](auto inputs, auto out) mutable {
      map.activation(inputs, workspace, out);
    };
  }

  TMpsomParameters parameters_;
  std::optional<TMpsom> map_;
  std::unique_ptr<TMpsomLearner> learner_;  // while it learns
};

}  // namespace

std::vector<ModuleType> t_mpsom_types() {
  return {
      describe<TMpsomModule>("t_mpsom", "A T-MPSOM (P06 section 4.1, P07, P11 section II).",
                             {input_ports("One or more signals, each along an axis of the map.")},
                             "The activity of the neurons, in the map's shape.", true)};
}

}  // namespace somato::modules
