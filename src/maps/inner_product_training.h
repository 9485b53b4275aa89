#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_training.h"

namespace somato {

class ProductState;

/// Trains `state` by its parameters. Fails with kInterrupted when the progress says stop.
Result<void> train_by_products(ProductState& state, const Progress& progress);

/// What train_som() does where these parameters and samples are for inner products; nothing where
/// they are for plain arithmetic.
Result<std::optional<Som>> train_by_inner_products(const SomParameters& parameters,
                                                   const Samples& samples,
                                                   const TrainingOptions& options);

/// Learns known samples one at a time by inner products, as SomLearner learns any. Its weights
/// are formed when they are asked for; what they make of a sample is known throughout.
class InnerProductLearner {
 public:
  InnerProductLearner(const InnerProductLearner&) = delete;
  InnerProductLearner(InnerProductLearner&&) = delete;
  InnerProductLearner& operator=(const InnerProductLearner&) = delete;
  InnerProductLearner& operator=(InnerProductLearner&&) = delete;
  ~InnerProductLearner();

  /// A map that has learned nothing yet, or nullptr where these parameters and samples are for
  /// plain arithmetic (see resolve()). Fails as untrained_som() does.
  static Result<std::unique_ptr<InnerProductLearner>> start(const SomParameters& parameters,
                                                            Samples samples);

  /// As the map will have them.
  const SomParameters& parameters() const;

  /// As SomLearner::learn() with sample number `sample`.
  std::size_t learn(std::size_t sample, double learning_rate, double radius);

  /// As Som::activity() for sample number `sample`.
  void activity(std::size_t sample, std::span<float> out) const;

  /// The map as it is now.
  Som form_som() const;

 private:
  explicit InnerProductLearner(std::unique_ptr<ProductState> state);

  std::size_t samples() const;

  std::unique_ptr<ProductState> state_;
};

}  // namespace somato
