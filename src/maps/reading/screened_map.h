#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/kernels/batch_kernels.h"
#include "somato/core/matrix.h"
#include "somato/maps/som.h"

namespace somato {

/// A map's weights as integers, for screening (base/kernels/batch_kernels.h), and by rows, for
/// deciding.
///
/// Neurons are grouped in blocks of 16 that are close together on the map, so that a whole block
/// can be skipped for a distant sample. With the mean c of all weights, unit u (the greatest |w -
/// c|) and squared distance d of sample x from weights w, a Euclidean map's score is (d - |x -
/// c|^2) / (2 u^2), and a dot-product map's is (x . c - x . w) / u^2.
class ScreenedMap {
 public:
  ScreenedMap(const Som& som, std::size_t threads);

  /// All weights are the same: there is nothing to screen.
  bool all_alike() const { return unit_ == 0.0; }

  std::size_t blocks() const { return radii_.size(); }
  std::size_t columns() const { return centre_.size(); }
  std::size_t pairs() const { return (centre_.size() + 1) / 2; }
  double unit() const { return unit_; }

  /// The neuron at a place of the blocks' order.
  std::size_t neuron_at(std::size_t place) const { return order_[place]; }

  /// Its weights.
  std::span<const float> weights_at(std::size_t place) const { return rows_.row(place); }

  std::span<const float> centre() const { return centre_; }

  kernels::ScreenedNeurons neurons() const { return {values_.data(), offsets_.data(), pairs()}; }

  /// The mean weights of the neurons of each block, as if they were neurons, and how far any of
  /// these lies from them, in units; on Euclidean maps only.
  kernels::ScreenedNeurons means() const {
    return {mean_values_.data(), mean_offsets_.data(), pairs()};
  }
  std::size_t mean_blocks() const {
    return (blocks() + kernels::kBlockNeurons - 1) / kernels::kBlockNeurons;
  }
  std::span<const double> radii() const { return radii_; }

  /// A bound on the error of the score of a sample at `distance` (in units) from the centre;
  /// `rounded_off` is the sum of the squared rounding errors of its integers.
  double score_error(double distance, float rounded_off) const;

  /// The factors that convert x - c of a sample at distance `length` from the centre to integers,
  /// and their products with those of a neuron to scores (ScreenedTile::factors).
  static float integer_factor(double length);
  float score_factor(double length) const;

 private:
  void find_centre(const Som& som);
  void write_rows(const Som& som, std::size_t begin, std::size_t end);
  void find_unit(std::size_t threads);
  void write_block(std::size_t block, std::vector<std::int16_t>& integers);
  void write_mean(std::size_t block, std::vector<std::int16_t>& integers);
  float offset_of(std::span<const float> weights, double squared_length) const;
  double relative_error(float rounded_off) const;

  bool euclidean_;
  std::vector<std::size_t> order_;
  std::vector<float> centre_;
  double squared_centre_ = 0.0;
  Matrix<float> rows_;                   // by place
  std::vector<double> squared_lengths_;  // of w - c, by place
  double unit_ = 0.0;
  AlignedVector<std::int16_t> values_;
  AlignedVector<float> offsets_;
  AlignedVector<std::int16_t> mean_values_;
  AlignedVector<float> mean_offsets_;
  std::vector<double> radii_;
  std::vector<float> rounded_off_;  // by place, then by block for the means
  float greatest_rounded_off_ = 0.0F;
};

}  // namespace somato
