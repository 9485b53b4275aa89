#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "maps/products/sample_products.h"
#include "maps/products/weight_strips.h"
#include "maps/som/product_reading.h"
#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The initial state of training by products: initial weights as their products with all known
/// samples.
struct ProductStart {
  AlignedVector<double> products;  ///< Known samples x padded neurons.
  AlignedVector<double>
      squared_lengths;  ///< The squared lengths of the initial weights, before scaling to length 1.
};

/// A map to be trained by products: parameters all decided, known samples as it sees them, those
/// that it is trained on, and the elements for which it has weights.
class ProductProblem {
 public:
  /// Nothing where the parameters and samples are for plain arithmetic. Fails as train_som() does
  /// before it trains. Throws InvalidArgument when a sample to train on is not there.
  static Result<std::shared_ptr<const ProductProblem>> prepare(const SomParameters& parameters,
                                                               const Samples& known,
                                                               std::vector<std::size_t> training,
                                                               std::size_t threads);

  const SomParameters& parameters() const { return parameters_; }
  const SampleProducts& known() const { return *known_; }
  const std::vector<std::size_t>& training() const { return training_; }

  /// The number of a sample among those that the map is trained on; nothing for one held out.
  std::optional<std::size_t> item_of(std::size_t sample) const {
    return trained_[sample] ? std::optional(items_[sample]) : std::nullopt;
  }
  const StoredElements& elements() const { return elements_; }

  /// The evaluation of a map for a known sample, from its products and the squared lengths of the
  /// weights.
  ProductReading reading(std::size_t sample, std::span<const double> products,
                         std::span<const double> squared_lengths) const;

  /// Whether weights start at random, not at samples or combinations of them.
  bool starts_at_random() const;

  /// With InitialWeights::kLinear: the factors of the samples to train on whose sums are the
  /// weights of each neuron; items x padded neurons. `threads` do not affect them.
  Matrix<double> factors_on_plane(std::size_t threads) const;

  /// Neurons, filled up to whole lines of kernels::kRowLanes.
  std::size_t padded() const;

  /// Only where weights start at random.
  ProductStart start(std::size_t threads) const;

  /// The weights that are of_start times the initial ones (where they start at random) and the
  /// coefficients, known samples x padded neurons, times the samples.
  LaneMatrix<float> form(std::span<const double> of_start, std::span<const double> coefficients,
                         std::size_t threads) const;

 private:
  ProductProblem() = default;
  WeightStrips strips() const;
  std::vector<std::uint32_t> used_elements() const;
  InitialRanges ranges(const std::vector<std::uint32_t>& elements) const;
  InitialRanges dense_ranges() const;
  InitialRanges sparse_ranges(const std::vector<std::uint32_t>& elements) const;

  SomParameters parameters_;
  std::shared_ptr<const SampleProducts> known_;
  std::vector<std::size_t> training_;
  std::vector<bool> trained_;        // of each known sample, whether it is among them
  std::vector<std::size_t> items_;   // and if so, its number there
  std::vector<std::uint32_t> used_;  // elements where sparse samples to train on have values
  StoredElements elements_;
};

}  // namespace somato
