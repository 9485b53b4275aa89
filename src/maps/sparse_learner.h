#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "somato/core/lane_matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/neighbourhood.h"
#include "somato/maps/som.h"

namespace somato {

/// Values for some of very many elements, one row an element that has been asked for, zeros at
/// first. Rows stay where they are.
class ElementRows {
 public:
  ElementRows(std::size_t elements, std::size_t row_size);

  std::size_t count() const { return count_; }
  std::size_t row_size() const { return row_size_; }

  bool has(std::size_t element) const { return numbers_[element] != 0; }

  /// The row of `element`, which gets one if it has none.
  float* row_of(std::size_t element);

  /// Row number `number`, in the order in which they were asked for.
  float* row(std::size_t number);

 private:
  std::size_t row_size_;
  std::size_t count_ = 0;
  std::vector<std::uint32_t> numbers_;  // 0 for none, else one more than the row's number
  std::vector<AlignedVector<float>> slabs_;
};

/// Learns sparse inputs one after the other, touching only the weights of elements that are not 0
/// in the input; see the source for the mathematics. The map is up to date after settle(), and then
/// has weights for all elements that inputs have brought.
class SparseLearner {
 public:
  /// Nobody else may change the map's weights as long as it is trained here.
  explicit SparseLearner(Som& som);

  /// Learns `input` times `factor`; returns the winner, by sums in double precision.
  std::size_t learn(const SignalView& input, double factor, double learning_rate, double radius);

  /// Writes the weights into the map.
  void settle();

 private:
  bool dot_product() const;
  void load();
  void take_input(const SignalView& input, double factor);
  void compute_products();
  std::size_t winner() const;
  void move(double learning_rate);
  void fold();
  void move_rows();
  void normalize();
  bool out_of_range(double scale) const;
  StoredElements elements_to_store() const;

  Som& som_;
  std::size_t rows_padded_;
  Neighbourhood neighbourhood_;
  ElementRows values_;  // v
  AlignedVector<double> scales_;
  AlignedVector<double> squared_lengths_;  // of v
  AlignedVector<double> products_;
  AlignedVector<float> gains_;
  AlignedVector<float> factors_;
  std::vector<float*> input_rows_;
  std::vector<float> input_values_;
  double squared_input_ = 0.0;
  double largest_ = 1.0;
  bool learned_ = false;
};

}  // namespace somato
