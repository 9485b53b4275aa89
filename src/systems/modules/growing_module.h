#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "maps/online/growing_map.h"
#include "somato/maps/refinement.h"
#include "systems/modules/map_module.h"
#include "systems/modules/support.h"

namespace somato::modules {

/// A map that grows, of one kind.
class GrowingKind {
 public:
  GrowingKind() = default;
  GrowingKind(const GrowingKind&) = delete;
  GrowingKind(GrowingKind&&) = delete;
  GrowingKind& operator=(const GrowingKind&) = delete;
  GrowingKind& operator=(GrowingKind&&) = delete;
  virtual ~GrowingKind() = default;

  virtual const GrowthParameters& growth() const = 0;

  /// A map that has not learned; `growth` has the seed and the number of iterations.
  virtual std::unique_ptr<GrowingMap> start(const GrowthParameters& growth,
                                            const NamedSamples& samples) const = 0;

  /// Whether it learns the names of samples, and cannot learn without them.
  virtual bool learns_names() const = 0;

  /// The refinement of a map that has grown, by labels.
  virtual RefinementParameters refinement() const { return {}; }

  /// Refuses settings that do not fit each other.
  virtual Result<void> check_settings() const { return {}; }

  /// A map that learns further from `som`, before GrowingMap::load(); nullptr if `som` is not of
  /// this kind.
  virtual std::unique_ptr<GrowingMap> start(const Som& som) const = 0;

  /// The number of iterations where it is automatic.
  virtual std::uint64_t automatic_iterations(std::size_t samples) const = 0;
};

/// A growing map in a system. Its output has a value for each neuron that the map may have; those
/// of neurons that it does not have are 0.
class GrowingModule : public MapModule {
 public:
  explicit GrowingModule(std::unique_ptr<GrowingKind> kind) : kind_(std::move(kind)) {}

  const Som& som() const override { return som_; }
  Grid grid() const override;
  const RefinedOrder* refined_order() const override { return order_ ? &*order_ : nullptr; }

  Result<PortType> connect(const std::vector<Connection>& inputs) override;
  std::unique_ptr<Runner> start() const override;
  std::size_t memory() const override;

  bool learns_at_once() const override { return true; }
  bool learns_by_draws() const override { return false; }
  Result<void> learn(const LearningPlan& plan, const TrainingInputs& explorations) override;
  Result<NeuronOrigins> learn_further(const LearningPlan& plan, const Samples& inputs) override;
  bool add_neuron(const SignalView& input, std::size_t the_class) override;
  void place_neuron(std::size_t neuron, const SignalView& input, std::size_t the_class) override;
  void save(Archive& archive, const std::string& prefix) const override;
  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override;

 private:
  GrowthParameters growth_for(const LearningPlan& plan, std::size_t samples) const;
  Result<void> grow_from(std::unique_ptr<GrowingMap> map, const LearningPlan& plan,
                         const GrowthParameters& growth, const NamedSamples& samples);
  Result<void> refine(const LearningPlan& plan, const NamedSamples& samples);
  Result<NamedSamples> named(const LearningPlan& plan, const Samples& samples) const;

  std::unique_ptr<GrowingKind> kind_;
  std::size_t input_size_ = 0;
  std::unique_ptr<GrowingMap> map_;  // learns; som_ is its present map
  Som som_;
  std::optional<RefinedOrder> order_;  // of the last training
};

}  // namespace somato::modules
