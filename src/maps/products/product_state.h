#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/kernels/product_kernels.h"
#include "maps/grid/neighbourhood.h"
#include "maps/products/product_problem.h"
#include "somato/core/matrix.h"

namespace somato {

/// A map while it is trained by products; see the source for the mathematics. A `sample` is a
/// number among the known ones, an `item` one among those it is trained on.
class ProductState {
 public:
  ProductState(std::shared_ptr<const ProductProblem> problem, std::size_t threads);

  const ProductProblem& problem() const { return *problem_; }
  std::size_t neurons() const { return grid_.size(); }

  /// The winner of the item, which moves with its neighbours.
  std::size_t learn(std::size_t item, double learning_rate, double radius);

  /// All items at once: every weight becomes their mean, weighted by the neighbourhood around
  /// their winners.
  void learn_all(double radius);

  /// The mean distance of the items from their winners.
  double mean_distance();

  /// The products of the weights with a sample: padded neurons.
  void products_with(std::size_t sample, std::span<double> out);

  std::span<const double> squared_lengths() const { return squared_lengths_; }

  /// The map's weights now.
  LaneMatrix<float> form(std::size_t threads) const;

 private:
  bool dot_product() const;
  void start_at_random(std::size_t threads);
  void start_at_combinations(std::size_t threads);
  void start_at_samples();
  void start_on_plane(std::size_t threads);
  kernels::ProductMap map();
  const double* item_products(std::size_t item) const;
  const double* initial_products(std::size_t sample) const;
  void products_with_item(std::size_t item, std::span<double> out);
  void scale_to_length_one(std::size_t neuron);
  std::size_t winner(const double* products);
  std::vector<std::size_t> winners();
  Matrix<double> neighbourhoods(const std::vector<std::size_t>& winners, double radius);
  void become_means(const Matrix<double>& shares, std::span<const double> totals);
  void measure_means(std::span<const double> totals);

  std::shared_ptr<const ProductProblem> problem_;
  Grid grid_;
  std::size_t padded_;
  // G(0); if initial weights are not random, a row of zeros. Shared by copies, like the following
  // members.
  std::shared_ptr<const ProductStart> start_;
  // K of the items; empty where they are all the samples.
  std::shared_ptr<const Matrix<double>> item_products_;
  AlignedVector<double> of_start_;         // c
  AlignedVector<double> factors_;          // f
  AlignedVector<double> squared_lengths_;  // n
  AlignedVector<double> coefficients_;     // A / f, items x padded
  Neighbourhood neighbourhood_;
  AlignedVector<double> gains_;
  AlignedVector<double> products_;
  AlignedVector<double> scores_;
  AlignedVector<double> zeros_;
  AlignedVector<double> all_products_;  // with each item, while all are learned at once
};

}  // namespace somato
