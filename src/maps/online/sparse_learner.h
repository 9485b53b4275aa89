#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/core/thread_team.h"
#include "maps/grid/neighbourhood.h"
#include "maps/online/online_map.h"
#include "somato/core/matrix.h"
#include "somato/core/signal.h"
#include "somato/maps/som.h"

namespace somato {

/// Lanes for a subset of very many elements, one row per requested element, initially zeros. A row
/// consists of parts, which threads use separately. Rows are not moved.
class ElementRows {
 public:
  /// Rows of whole blocks of lanes, in at most `parts` parts of nearly equal length.
  ElementRows(std::size_t elements, std::size_t row_size, std::size_t parts);

  std::size_t count() const { return count_; }

  std::size_t parts() const { return parts_; }

  /// The first lane of a part, or the end.
  std::size_t begin(std::size_t part) const { return blocks_ * part / parts_ * kLanes; }

  bool has(std::size_t element) const { return numbers_[element] != 0; }

  /// The number of the row of `element`, which is created if necessary: rows are numbered in the
  /// order of requests.
  std::uint32_t number_of(std::size_t element);

  /// A part of row number `number`.
  float* row(std::uint32_t number, std::size_t part) {
    const std::size_t from = begin(part);
    return slabs_[number / rows_in_slab_].data() + rows_in_slab_ * from +
           number % rows_in_slab_ * (begin(part + 1) - from);
  }

 private:
  static constexpr std::size_t kLanes = LaneMatrix<float>::kLanes;

  std::size_t blocks_;
  std::size_t parts_;
  std::uint32_t rows_in_slab_;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> numbers_;  // 0 for none, else one more than the row's number
  std::vector<AlignedVector<float>> slabs_;
};

/// Learns sparse inputs one after the other, touching only the weights of elements that are not 0
/// in the input; see the source for the mathematics. Takes one input at a time. The map is up to
/// date after settle(), and then has weights for all elements that inputs have brought.
class SparseLearner : public OnlineMap {
 public:
  /// The map's weights must not be changed elsewhere during training.
  SparseLearner(Som& som, ThreadTeam& team);

  /// The winner is found by sums in double precision.
  Learned learn(std::span<const OnlineInput> inputs, std::span<const LearningStep> steps) override;
  void settle() override;
  Som look() override;

 private:
  bool dot_product() const;
  template <typename Work>
  void for_each_part(std::size_t rows, const Work& work);
  void load();
  void load_part(std::size_t part);
  void take_input(const SignalView& input, double factor);
  void add_products(std::size_t part);
  std::size_t winner() const;
  void move(double learning_rate);
  void fold();
  void fold_part(std::size_t part);
  bool moves(std::size_t block) const;
  void move_part(std::size_t part);
  void move_lanes(std::size_t part, std::size_t first, std::size_t count);
  void write(Som& som);
  void write_part(std::size_t part, Som& som);
  void normalize();
  bool out_of_range(double scale) const;
  StoredElements elements_to_store() const;

  Som& som_;
  ThreadTeam& team_;
  std::size_t rows_padded_;
  Neighbourhood neighbourhood_;
  ElementRows values_;  // v
  AlignedVector<double> scales_;
  AlignedVector<double> squared_lengths_;  // of v
  AlignedVector<double> products_;
  AlignedVector<float> gains_;
  AlignedVector<float> factors_;
  std::vector<std::uint32_t> input_rows_;
  std::vector<float> input_values_;
  double squared_input_ = 0.0;
  double largest_ = 1.0;
  bool learned_ = false;
};

}  // namespace somato
