#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/core/thread_team.h"
#include "base/kernels/online_kernels.h"
#include "maps/grid/neighbourhood.h"
#include "maps/online/input_slots.h"
#include "maps/online/rounded_weights.h"
#include "somato/core/matrix.h"
#include "somato/maps/som.h"

namespace somato {

/// Learns dense inputs one after the other with less than one pass over the weights each; see the
/// source for the mathematics. The map's weights are up to date after settle(). The same inputs
/// give the same bits for every number of threads and however many of them are known ahead.
class DenseLearner {
 public:
  /// The map's weights must not be changed elsewhere during training.
  DenseLearner(Som& som, ThreadTeam& team);

  /// Makes the next inputs known, as the map sees them: at least one, at most kPending. They are
  /// then learned in this order.
  void expect(const std::vector<std::span<const float>>& inputs);

  /// The best number of inputs to announce at once.
  std::size_t ahead() const;

  /// Learns the next expected input; returns the winner, which is the one that Som::winner() finds
  /// after settle().
  std::size_t learn(double learning_rate, double radius);

  /// Makes all pending updates.
  void settle();

  /// The map as settle() would leave it; nothing changes here.
  Som look();

 private:
  bool dot_product() const;
  bool clears() const;
  float limit() const;
  std::size_t made() const { return std::max<std::size_t>(1, pending_); }
  std::size_t stride() const { return som_.weights().padded_rows(); }
  std::size_t blocks() const { return som_.weights().blocks(); }
  float* products_of(std::size_t slot) {
    return products_.data() + slot * (stride() + kernels::kPending);
  }

  void for_each_task(std::size_t count, std::size_t vectors,
                     const std::function<void(std::size_t)>& work);
  void pass(InputSlots& next, std::size_t first, std::size_t count);
  void pass_over_block(std::size_t block, InputSlots& next, std::size_t first, std::size_t count);
  void pass_in_tiles(std::size_t block, const InputSlots& next, std::size_t first,
                     std::size_t count, bool moves);
  void combine_tile(std::size_t block, std::size_t start, std::size_t columns, float* to,
                    float* squares) const;
  void multiply_tile(std::size_t block, std::size_t start, std::size_t columns,
                     const InputSlots& next, std::size_t first, std::size_t count);
  void multiply_block(std::size_t block, const float* input, std::size_t slot);
  void multiply_inputs(InputSlots& next, std::size_t first, std::size_t count);
  void write_coefficients(std::size_t block);
  float float_gain(std::size_t neuron, std::size_t slot) const;
  void bound_magnitudes(std::size_t block);
  void forget_pending();
  void rebase(std::size_t count);
  void rebase_expected();

  void compute_scores();
  double rounded_off() const;
  double score_limit() const;
  std::size_t winner();
  std::size_t exact_winner(double limit);
  std::span<const float> settled_row(std::size_t neuron);
  double exact_score(std::span<const float> weights) const;
  void move(double learning_rate);
  void normalize();
  void normalize_measured();

  Som& som_;
  ThreadTeam& team_;
  ThreadTeam::Order order_ = ThreadTeam::Order::kUp;
  std::size_t chunk_;  // columns that are summed on their own
  Neighbourhood neighbourhood_;
  InputSlots slots_;  // the pending ones, then those expected
  InputSlots other_slots_;
  std::size_t pending_ = 0;
  std::size_t expected_ = 0;
  std::size_t ahead_ = kernels::kPending;
  // Products of a slot with the weights in memory, then with the slots; one row per slot.
  AlignedVector<float> products_;
  AlignedVector<double> kept_;
  LaneMatrix<double> gains_;  // neurons x slots
  AlignedVector<double> squared_lengths_;
  AlignedVector<double> magnitudes_;
  std::vector<unsigned char> moved_;  // a block
  RoundedWeights rounded_;
  bool reads_rounded_ = false;
  bool rounds_all_ = false;  // in this pass
  AlignedVector<float> float_kept_;
  AlignedVector<float> float_gains_;
  AlignedVector<double> slot_products_;
  AlignedVector<double> input_products_;
  AlignedVector<double> scores_;
  AlignedVector<double> factors_;
  AlignedVector<double> new_gains_;
  std::vector<std::size_t> to_measure_;
  AlignedVector<float> neighbours_;
  AlignedVector<float> scratch_row_;
  std::uint64_t learned_since_clearing_ = 0;
  bool all_normalized_ = false;
};

}  // namespace somato
