#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/maps/refinement.h"
#include "somato/maps/som.h"
#include "somato/maps/som_learner.h"
#include "systems/modules/map_module.h"
#include "systems/modules/support.h"

namespace somato::modules {

/// A SOM in a system. Studies access the map directly.
class SomModule : public MapModule {
 public:
  using Parameters = SomParameters;
  explicit SomModule(Parameters parameters, const RefinementParameters& refinement = {})
      : parameters_(std::move(parameters)), refinement_(refinement) {}

  const Som& som() const override { return som_; }
  Grid grid() const override { return parameters_.grid(); }
  const RefinedOrder* refined_order() const override { return order_ ? &*order_ : nullptr; }

  /// The training options for a plan.
  SomParameters parameters_for(const LearningPlan& plan) const;

  Table decide(const std::vector<Connection>& inputs, const RecordingLayout& layout) override;
  Result<PortType> connect(const std::vector<Connection>& inputs) override;
  std::unique_ptr<Runner> start() const override;
  std::size_t memory() const override;

  bool learns_at_once() const override { return rate_ == Rate::kExploration; }
  bool learns_by_draws() const override { return parameters_.training == Training::kOnline; }
  Result<void> learn(const LearningPlan& plan, const TrainingInputs& explorations) override;
  Result<NeuronOrigins> learn_further(const LearningPlan& plan, const Samples& inputs) override;
  void place_neuron(std::size_t neuron, const SignalView& input,
                    std::size_t /*the_class*/) override {
    som_ = som_.with_neuron_at(neuron, input);
  }
  Result<std::uint64_t> begin(const LearningPlan& plan,
                              const TrainingInputs& explorations) override;
  Result<void> step(std::span<const SignalView> inputs, std::uint64_t draw) override;
  void turn_to(std::size_t exploration) override { exploration_ = exploration; }
  void finish() override;
  void save(Archive& archive, const std::string& prefix) const override;
  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override;

 private:
  bool fits(const Som& som) const;
  bool is_refined() const { return refinement_.refine != Refinement::kNone; }
  Result<RefinedSom> refine(const Som& trained, const LearningPlan& plan,
                            const Samples& samples) const;

  SomParameters parameters_;
  RefinementParameters refinement_;
  std::optional<RefinedOrder> order_;
  std::size_t input_size_ = 0;
  Rate rate_ = Rate::kExploration;
  Som som_;
  std::unique_ptr<SomLearner> learner_;  // while it learns
  std::optional<Samples> fixed_;  // what explorations bring, where that stays the same meanwhile
  std::size_t exploration_ = 0;
};

}  // namespace somato::modules
