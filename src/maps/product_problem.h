#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "maps/sample_products.h"
#include "maps/weight_strips.h"
#include "somato/core/lane_matrix.h"
#include "somato/core/result.h"
#include "somato/maps/known_samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"
#include "somato/maps/stored_elements.h"

namespace somato {

/// What training by products starts from: initial weights as their products with all known samples.
struct ProductStart {
  AlignedVector<double> products;         ///< Known samples x padded neurons.
  AlignedVector<double> squared_lengths;  ///< Of the initial weights, before they get length 1.
};

/// A map to be trained by products: parameters all decided, known samples as it sees them, those
/// that it is trained on, and the elements for which it has weights.
class ProductProblem {
 public:
  /// Nothing where the parameters and samples are for plain arithmetic. Fails as train_som() does
  /// before it trains, but for want of memory.
  static Result<std::shared_ptr<const ProductProblem>> prepare(const SomParameters& parameters,
                                                               const KnownSamples& known,
                                                               std::vector<std::size_t> training,
                                                               std::size_t threads);

  const SomParameters& parameters() const { return parameters_; }
  const SampleProducts& known() const { return *known_; }
  const std::vector<std::size_t>& training() const { return training_; }
  const StoredElements& elements() const { return elements_; }

  /// Whether weights start at random, not at samples.
  bool starts_at_random() const;

  /// Neurons, filled up to whole lines of kernels::kRowLanes.
  std::size_t padded() const;

  /// Only where weights start at random.
  ProductStart start(std::size_t threads) const;

  /// The weights that are of_start times the initial ones (where they start at random) and the
  /// coefficients, known samples x padded neurons, times the samples.
  Som form(std::span<const double> of_start, std::span<const double> coefficients,
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
  std::vector<bool> trained_;  // of each known sample, whether it is among them
  StoredElements elements_;
};

}  // namespace somato
