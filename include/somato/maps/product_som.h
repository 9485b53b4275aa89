#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "somato/core/result.h"
#include "somato/maps/known_samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_training.h"

namespace somato {

/// A trained map that is known by its inner products with known samples. It answers for these at
/// once, whether it was trained on them or not, and has no weights until they are asked for: with
/// few samples of many elements they cost more than the training. See
/// docs/mathematics/inner-products.md. It does not change, so threads can share it.
///
/// It answers as the Som it forms would, in double precision where that computes in single: the
/// same up to rounding. A `sample` is a number among the known ones; one that is not there throws
/// InvalidArgument, and so does a span of another size.
class ProductSom {
 public:
  ProductSom() = default;

  /// Resolved for the samples it was trained on.
  const SomParameters& parameters() const;
  std::size_t neurons() const;
  const KnownSamples& known() const;

  /// As Som::winner().
  std::size_t winner(std::size_t sample) const;

  /// As Som::winners().
  Winners winners(std::size_t sample) const;

  /// As Som::winner_among().
  std::size_t winner_among(std::span<const std::size_t> candidates, std::size_t sample) const;

  /// The squared Euclidean distance of the sample, as the map sees it, from the weights of
  /// `neuron`; at least 0.
  double squared_distance(std::size_t sample, std::size_t neuron) const;

  /// As Som::similarities() and Som::activity(); `out` holds neurons() values.
  void similarities(std::size_t sample, std::span<float> out) const;
  void activity(std::size_t sample, std::span<float> out) const;

  /// The map with its weights: what train_som() gives for the same parameters and the samples it
  /// was trained on, bit by bit.
  Som form_som(std::size_t threads = 1) const;

 private:
  struct State;
  friend Result<std::optional<ProductSom>> train_product_som(
      const SomParameters& parameters, const KnownSamples& known,
      const std::vector<std::size_t>& training, const TrainingOptions& options);

  std::shared_ptr<const State> state_;
};

/// Trains a map on those of the known samples whose numbers `training` lists, in that order, as
/// train_som() would; the others decide nothing of it. Nothing where these parameters and samples
/// are for plain arithmetic (see resolve()): then train_som() has to do it. Fails as train_som()
/// does, but for want of memory for the weights. Throws InvalidArgument when a sample is not there.
Result<std::optional<ProductSom>> train_product_som(const SomParameters& parameters,
                                                    const KnownSamples& known,
                                                    const std::vector<std::size_t>& training,
                                                    const TrainingOptions& options = {});

}  // namespace somato
