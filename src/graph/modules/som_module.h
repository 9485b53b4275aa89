#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "graph/modules/support.h"
#include "maps/inner_product_training.h"
#include "somato/maps/som.h"
#include "somato/maps/som_learner.h"

namespace somato::modules {

/// A SOM in a system. Studies look at the map itself.
class SomModule : public SteppedModule, public Learner {
 public:
  using Parameters = SomParameters;
  explicit SomModule(Parameters parameters) : parameters_(std::move(parameters)) {}

  const Som& som() const { return som_; }
  Grid grid() const { return parameters_.grid(); }

  /// What the map is trained with for a lesson.
  SomParameters parameters_for(const Lesson& lesson) const;

  /// A map that was trained elsewhere. Throws InvalidArgument when it is of another size.
  void set_som(Som som);

  Table decide(const std::vector<Connection>& inputs, const RecordingLayout& layout) override;
  Result<PortType> connect(const std::vector<Connection>& inputs) override;
  Learner* learner() override { return this; }
  std::unique_ptr<Stepper> start() const override;
  std::size_t memory() const override;

  bool learns_at_once() const override { return rate_ == Rate::kExploration; }
  bool learns_by_draws() const override { return parameters_.training == Training::kOnline; }
  Result<void> learn(const Lesson& lesson, const TrainingInputs& explorations) override;
  Result<std::uint64_t> begin(const Lesson& lesson, const TrainingInputs& explorations) override;
  Result<void> step(std::span<const SignalView> inputs, std::uint64_t draw) override;
  void turn_to(std::size_t exploration) override { exploration_ = exploration; }
  void finish() override;
  void save(Archive& archive, const std::string& prefix) const override;
  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override;

 private:
  bool fits(const Som& som) const;
  Result<void> begin_plain(SomParameters parameters, const Samples& samples);

  SomParameters parameters_;
  std::size_t input_size_ = 0;
  Rate rate_ = Rate::kExploration;
  Som som_;
  std::unique_ptr<SomLearner> learner_;  // while it learns
  // In a phase whose explorations bring the same throughout; there is no map until its end.
  std::unique_ptr<InnerProductLearner> known_;
  std::size_t exploration_ = 0;
};

}  // namespace somato::modules
