#include "maps/online/dense_learner.h"

// The last kPending updates are deferred. Until they are applied, neuron k has the weights
//
//     w_k = c_k v_k + sum_j A_kj x_j,
//
// v_k being those in memory and x_j the inputs whose updates are pending. Learning input x with
// gain a (learning rate times neighbourhood) only changes the coefficients,
//
//     c_k <- (1-a) c_k,   A_kj <- (1-a) A_kj,   A_kx <- a,
//     n_k <- (1-a)^2 n_k + 2 a (1-a) g_k + a^2 |x|^2   for n_k = |w_k|^2, g_k = w_k . x,
//
// and a normalization divides them by sqrt(n_k). So one input costs the products v_k . x, from
// which g_k = c_k (v_k . x) + sum_j A_kj (x_j . x) follows: a pass that only reads. All pending
// updates are applied in one pass, which computes n_k again, so that rounding errors do not
// accumulate, and computes the products of the next inputs if they are known. Coefficients are in
// double precision.
//
// v_k is read as 16-bit integers where it can be, with an error of length e_k at most. That changes
// c_k (v_k . x) by no more than |c_k| e_k |x|, and n_k by no more than 2 |c_k| e_k m_k (m_k as
// below, by induction). Lengths are measured on the weights themselves.
//
// The winner is nonetheless the one that Som::winner() finds on the weights as settle() would leave
// them. With u = 2^-24 and R the number of roundings along a sum, score n_k - 2 g_k + |x|^2 and the
// squared distance d^2 differ by at most
//
//     u (R + 40) ((m_k + |x|)^2 + d^2) + 2 |c_k| e_k (m_k + |x|)
//
// for m_k = |c_k| |v_k| + sum_j |A_kj| |x_j| >= |w_k|:
//
// u R m_k^2 for n_k (by induction, as (1-a)^2 m^2 + 2 a (1-a) m |x| + a^2 |x|^2 is the next m^2), 2
// u R m_k |x| for g_k, and 2 d |rounding of w_k| with |rounding of w_k| <= (kPending + 2) u m_k.
// Where weights below kNegligible become 0, d^2 changes by no more than u d^2 + kNegligible^2
// elements / u. Neurons within these bounds of the best are compared in double precision.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/core/lanes.h"
#include "base/kernels/batch_kernels.h"
#include "maps/som/map_rows.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using kernels::kPending;

constexpr double kUnit = 0x1p-24;

// Below it multiplying gets slow, and no weight moves.
constexpr double kSmallestGain = 0x1p-100;

// Vectors to read that take longer than telling other threads.
constexpr std::size_t kWorthSharing = std::size_t{1} << 12;

// Rounding the weights for fewer inputs would take more time than it saves.
constexpr std::size_t kWorthRounding = 4;

// Weights of elements that are mostly zero decay until they are slow to compute with; their squares
// have left the range of single precision long before.
constexpr std::uint64_t kLearnedBetweenClearings = 64;

// In case of cancellation, the remaining length is measured instead of computed.
constexpr double kMostCancellation = 32.0;

// Shorter than those of the plain formula, so that few scores are too close to call; long enough
// for many columns.
std::size_t chunk_for(std::size_t columns) {
  constexpr std::size_t kShort = 64;
  const bool is_short = columns > kernels::kChunk && columns < kShort * kernels::kChunk;
  return is_short ? kShort : kernels::kChunk;
}

// The error of a sum in chunks, and of other roundings (see above).
double relative_error(std::size_t columns, std::size_t chunk) {
  constexpr std::size_t kElse = 40;
  const std::size_t roundings = chunk + columns / chunk + kElse;
  return kUnit * static_cast<double>(roundings);
}

double negligible_length(std::size_t columns) {
  return static_cast<double>(kernels::kNegligible<float>) * std::sqrt(static_cast<double>(columns));
}

}  // namespace

DenseLearner::DenseLearner(Som& som, ThreadTeam& team)
    : som_(som),
      team_(team),
      chunk_(chunk_for(som.weights().columns())),
      neighbourhood_(som.grid(), som.parameters().neighbourhood),
      slots_(som.weights().columns()),
      other_slots_(som.weights().columns()),
      products_(kPending * (stride() + kPending)),
      kept_(stride(), 1.0),
      gains_(som.neurons(), kPending),
      squared_lengths_(stride()),
      magnitudes_(stride()),
      moved_(blocks()),
      rounded_(dot_product() ? LaneMatrix<float>() : som.weights()),
      float_kept_(stride()),
      float_gains_(kPending * stride()),
      slot_products_(gains_.padded_rows()),
      input_products_(kPending),
      scores_(som.neurons()),
      factors_(gains_.padded_rows(), 1.0),
      new_gains_(som.neurons()),
      neighbours_(som.neurons()),
      scratch_row_(slots_.padded()) {
  weights_to_change(som);  // before threads read them
  AlignedVector<float> squares(stride());
  kernels::table<float>().squared_norms(kernels::lanes(som_.weights()), squares.data());
  std::copy(squares.begin(), squares.end(), squared_lengths_.begin());
  forget_pending();
}

bool DenseLearner::clears() const {
  return learned_since_clearing_ >= kLearnedBetweenClearings;
}

// Weights whose magnitudes are below it become 0.
float DenseLearner::limit() const {
  return clears() ? kernels::kNegligible<float> : 0.0F;
}

bool DenseLearner::dot_product() const {
  return som_.parameters().similarity == Similarity::kDotProduct;
}

void DenseLearner::expect(const std::vector<std::span<const float>>& inputs) {
  SOMATO_ASSERT(expected_ == 0 && !inputs.empty() && inputs.size() <= kPending);
  const bool full = pending_ + inputs.size() > kPending;
  InputSlots& slots = full ? other_slots_ : slots_;
  const std::size_t first = full ? 0 : pending_;
  slots.write(first, inputs);
  if (full) {
    rebase(inputs.size());
  } else {
    pass(slots_, first, inputs.size());
  }
  expected_ = inputs.size();
  ahead_ = std::min(2 * ahead_, kPending);
}

// Never beyond the input at which pending updates are applied, regardless of the number of known
// inputs.
std::size_t DenseLearner::ahead() const {
  return std::min(ahead_, pending_ == kPending ? kPending : kPending - pending_);
}

// Applies the pending updates and continues with the expected inputs.
void DenseLearner::rebase_expected() {
  std::vector<std::span<const float>> left(expected_);
  for (std::size_t i = 0; i < expected_; ++i) left[i] = slots_.input(pending_ + i);
  other_slots_.write(0, left);
  rebase(expected_);
}

// Applies the pending updates and continues with the first `count` of the other slots.
void DenseLearner::rebase(std::size_t count) {
  const bool rounds = !dot_product() && pending_ >= kWorthRounding;
  rounds_all_ = rounds && !reads_rounded_;
  reads_rounded_ = rounds;
  pass(other_slots_, 0, count);
  rounds_all_ = false;
  if (clears()) learned_since_clearing_ = 0;
  forget_pending();
  std::swap(slots_, other_slots_);
}

void DenseLearner::settle() {
  if (std::find(moved_.begin(), moved_.end(), 1) == moved_.end()) return;
  SOMATO_ASSERT(expected_ == 0);
  rebase(0);
}

Som DenseLearner::look() {
  const LaneMatrix<float>& before = som_.weights();
  LaneMatrix<float> weights = before;
  alignas(64) float squares[kFloatLanes] = {};
  for (std::size_t block = 0; block < blocks(); ++block) {
    if (moved_[block] == 0) continue;
    write_coefficients(block);
    for (std::size_t start = 0; start < before.columns(); start += chunk_) {
      float* to = weights.data() + (block * before.columns() + start) * kFloatLanes;
      combine_tile(block, start, std::min(chunk_, before.columns() - start), to, squares);
    }
  }
  return Som(som_.parameters(), std::move(weights), som_.elements());
}

// Single precision for the pass that makes the updates.
void DenseLearner::write_coefficients(std::size_t block) {
  for (std::size_t lane = 0; lane < kFloatLanes; ++lane) {
    const std::size_t neuron = block * kFloatLanes + lane;
    float_kept_[neuron] = static_cast<float>(kept_[neuron]);
    if (neuron >= som_.neurons()) continue;
    for (std::size_t j = 0; j < made(); ++j) {
      float_gains_[(block * kPending + j) * kFloatLanes + lane] = float_gain(neuron, j);
    }
  }
}

float DenseLearner::float_gain(std::size_t neuron, std::size_t slot) const {
  const double gain = gains_(neuron, slot);
  return std::fabs(gain) < kSmallestGain ? 0.0F : static_cast<float>(gain);
}

void DenseLearner::forget_pending() {
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    magnitudes_[neuron] = std::sqrt(squared_lengths_[neuron]);
  }
  std::fill(kept_.begin(), kept_.end(), 1.0);
  std::fill_n(gains_.data(), gains_.padded_rows() * kPending, 0.0);
  std::fill(moved_.begin(), moved_.end(), 0);
  pending_ = 0;
}

// By several threads if there are enough vectors to read.
void DenseLearner::for_each_task(std::size_t count, std::size_t vectors,
                                 const std::function<void(std::size_t)>& work) {
  if (vectors < kWorthSharing) {
    for (std::size_t task = 0; task < count; ++task) work(task);
  } else {
    team_.for_each(count, work, order_);
  }
}

// Makes what is pending if `next` are other slots than those in use; takes the products of `count`
// inputs from slot `first` on, at last those with inputs.
void DenseLearner::pass(InputSlots& next, std::size_t first, std::size_t count) {
  const auto work = [&](std::size_t block) { pass_over_block(block, next, first, count); };
  for_each_task(blocks() + 1, blocks() * som_.weights().columns(), work);
  order_ = order_ == ThreadTeam::Order::kUp ? ThreadTeam::Order::kDown : ThreadTeam::Order::kUp;
}

void DenseLearner::pass_over_block(std::size_t block, InputSlots& next, std::size_t first,
                                   std::size_t count) {
  if (block == blocks()) return multiply_inputs(next, first, count);
  const bool moves = &next != &slots_ && moved_[block] != 0;
  if (moves) write_coefficients(block);
  if (moves || rounds_all_ || count > 1) {
    pass_in_tiles(block, next, first, count > 1 ? count : 0, moves);
  }
  if (count == 1) multiply_block(block, next.input(first).data(), first);
}

void DenseLearner::multiply_inputs(InputSlots& next, std::size_t first, std::size_t count) {
  for (std::size_t slot = first; slot < first + count; ++slot) {
    next.measure(slot);
    next.multiply(slot, slot + 1, chunk_, products_of(slot) + stride());
  }
}

// Few columns at a time, which stay in the first cache.
void DenseLearner::pass_in_tiles(std::size_t block, const InputSlots& next, std::size_t first,
                                 std::size_t count, bool moves) {
  const std::size_t columns = som_.weights().columns();
  const bool rounds = reads_rounded_ && (moves || rounds_all_);
  alignas(64) float squares[kFloatLanes] = {};
  for (std::size_t j = 0; j < count; ++j) {
    std::fill_n(products_of(first + j) + block * kFloatLanes, kFloatLanes, 0.0F);
  }
  if (moves && !dot_product()) bound_magnitudes(block);
  if (rounds) rounded_.begin(block);
  for (std::size_t start = 0; start < columns; start += chunk_) {
    const std::size_t width = std::min(chunk_, columns - start);
    float* weights = weights_to_change(som_).data() + (block * columns + start) * kFloatLanes;
    if (moves) combine_tile(block, start, width, weights, squares);
    if (rounds) rounded_.write(block, start, width, weights);
    if (count > 0) multiply_tile(block, start, width, next, first, count);
  }
  if (rounds) rounded_.end(block);
  if (moves) std::copy_n(squares, kFloatLanes, squared_lengths_.data() + block * kFloatLanes);
}

void DenseLearner::multiply_tile(std::size_t block, std::size_t start, std::size_t columns,
                                 const InputSlots& next, std::size_t first, std::size_t count) {
  const auto& kernels = kernels::online_table();
  const std::size_t at = block * som_.weights().columns() + start;
  const kernels::InputRows inputs = next.rows(first, start);
  float* products = products_of(first) + block * kFloatLanes;
  const std::size_t product_stride = stride() + kPending;
  if (reads_rounded_) {
    kernels.multiply_integers(rounded_.block(block) + start * kFloatLanes, columns, inputs, count,
                              products, product_stride);
  } else {
    kernels.multiply(som_.weights().data() + at * kFloatLanes, columns, inputs, count, products,
                     product_stride);
  }
}

// The same for a single input, limited by reading memory.
void DenseLearner::multiply_block(std::size_t block, const float* input, std::size_t slot) {
  const auto& kernels = kernels::online_table();
  const std::size_t columns = som_.weights().columns();
  float* products = products_of(slot) + block * kFloatLanes;
  if (reads_rounded_) {
    kernels.multiply_block_of_integers(rounded_.block(block), columns, chunk_, input, products);
  } else {
    kernels.multiply_block(som_.weights().data() + block * columns * kFloatLanes, columns, chunk_,
                           input, products);
  }
}

// Bounds the weights after the updates.
void DenseLearner::bound_magnitudes(std::size_t block) {
  for (std::size_t neuron = block * kFloatLanes; neuron < (block + 1) * kFloatLanes; ++neuron) {
    double bound = std::fabs(kept_[neuron]) * rounded_.greatest(neuron);
    for (std::size_t j = 0; j < pending_ && neuron < som_.neurons(); ++j) {
      bound += std::fabs(gains_(neuron, j)) * slots_.greatest(j);
    }
    rounded_.set_greatest(neuron, bound);
  }
}

void DenseLearner::combine_tile(std::size_t block, std::size_t start, std::size_t columns,
                                float* to, float* squares) const {
  const LaneMatrix<float>& weights = som_.weights();
  kernels::online_table().combine(
      weights.data() + (block * weights.columns() + start) * kFloatLanes, columns,
      float_kept_.data() + block * kFloatLanes,
      float_gains_.data() + block * kPending * kFloatLanes, slots_.rows(0, start), made(), limit(),
      to, squares);
}

std::size_t DenseLearner::learn(double learning_rate, double radius) {
  SOMATO_ASSERT(expected_ > 0);
  const std::size_t nearest = winner();
  neighbourhood_.around(nearest, radius, neighbours_);
  to_measure_.clear();
  move(learning_rate);
  if (dot_product()) normalize();
  kernels::table<double>().scale_rows(kernels::lanes(gains_), factors_.data());
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    gains_(neuron, pending_) = new_gains_[neuron];
    if (factors_[neuron] != 1.0 || new_gains_[neuron] != 0.0) moved_[neuron / kFloatLanes] = 1;
  }
  ++pending_;
  ++learned_since_clearing_;
  --expected_;
  if (!to_measure_.empty()) normalize_measured();
  return nearest;
}

// Nothing changes where the gain is 0.
void DenseLearner::move(double learning_rate) {
  const double squared_input = input_products_[pending_];
  const double input = std::sqrt(squared_input);
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    const double gain = learning_rate * double{neighbours_[neuron]};
    const double keep = 1.0 - gain;
    squared_lengths_[neuron] =
        std::max(0.0, keep * keep * squared_lengths_[neuron] +
                          2.0 * gain * keep * slot_products_[neuron] + gain * gain * squared_input);
    magnitudes_[neuron] = std::fabs(keep) * magnitudes_[neuron] + std::fabs(gain) * input;
    kept_[neuron] *= keep;
    factors_[neuron] = keep;
    new_gains_[neuron] = gain;
  }
}

// Neurons that have not moved since they had length 1 stay as they are.
void DenseLearner::normalize() {
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    const double squared_length = squared_lengths_[neuron];
    const double magnitude = magnitudes_[neuron];
    if ((all_normalized_ && new_gains_[neuron] == 0.0) || magnitude == 0.0) continue;
    if (magnitude * magnitude > kMostCancellation * squared_length) {
      to_measure_.push_back(neuron);
      continue;
    }
    const double factor = 1.0 / std::sqrt(squared_length);
    squared_lengths_[neuron] = 1.0;
    magnitudes_[neuron] *= factor;
    kept_[neuron] *= factor;
    factors_[neuron] *= factor;
    new_gains_[neuron] *= factor;
  }
  all_normalized_ = true;
}

// Their lengths are those in memory once the updates are made.
void DenseLearner::normalize_measured() {
  ahead_ = 1;
  rebase_expected();
  for (const std::size_t neuron : to_measure_) {
    if (squared_lengths_[neuron] == 0.0) continue;
    kept_[neuron] = 1.0 / std::sqrt(squared_lengths_[neuron]);
    squared_lengths_[neuron] = 1.0;
    magnitudes_[neuron] = 1.0;
    moved_[neuron / kFloatLanes] = 1;
  }
}

void DenseLearner::compute_scores() {
  const std::size_t slot = pending_;
  std::fill(input_products_.begin(), input_products_.end(), 0.0);
  const float* products = products_of(slot);
  for (std::size_t j = 0; j <= slot; ++j) input_products_[j] = double{products[stride() + j]};
  kernels::table<double>().inner_products(kernels::lanes(std::as_const(gains_)),
                                          input_products_.data(), slot_products_.data());
  const bool dot = dot_product();
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    const double scale = reads_rounded_ ? kept_[neuron] * rounded_.step(neuron) : kept_[neuron];
    slot_products_[neuron] += scale * double{products[neuron]};
    const double product = slot_products_[neuron];
    scores_[neuron] =
        dot ? -product : squared_lengths_[neuron] - 2.0 * product + input_products_[slot];
  }
}

// An upper bound for the exact best score in terms of the computed ones: any neuron with a higher
// score is not the winner, whatever its rounding errors are.
double DenseLearner::score_limit() const {
  const std::size_t columns = som_.weights().columns();
  const double best = *std::min_element(scores_.begin(), scores_.end());
  const double magnitude = *std::max_element(
      magnitudes_.begin(), magnitudes_.begin() + static_cast<std::ptrdiff_t>(som_.neurons()));
  const double input = std::sqrt(input_products_[pending_]);
  const double error = relative_error(columns, chunk_);
  const double negligible = negligible_length(columns);
  if (dot_product()) {
    return best + 2.0 * (error * magnitude + negligible) * input;
  }
  const double bound = error * (magnitude + input) * (magnitude + input) +
                       2.0 * rounded_off() * (magnitude + input) + negligible * negligible / kUnit;
  return best + 2.0 * bound;
}

// The greatest length by which weights in memory and those read differ, as far as they still count.
double DenseLearner::rounded_off() const {
  if (!reads_rounded_) return 0.0;
  double greatest = 0.0;
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    greatest = std::max(greatest, std::fabs(kept_[neuron]) * rounded_.error(neuron));
  }
  return greatest;
}

std::size_t DenseLearner::winner() {
  compute_scores();
  const double limit = score_limit();
  std::size_t best = som_.neurons();
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    if (scores_[neuron] > limit) continue;
    if (best < som_.neurons()) return exact_winner(limit);
    best = neuron;
  }
  return best;
}

// Among the neurons within the limit.
std::size_t DenseLearner::exact_winner(double limit) {
  std::vector<std::size_t> candidates;
  candidates.reserve(som_.neurons());
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    if (scores_[neuron] > limit) continue;
    candidates.push_back(neuron);
  }
  std::size_t best = candidates.front();
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t neuron : candidates) {
    const double score = exact_score(settled_row(neuron));
    if (score >= least) continue;
    least = score;
    best = neuron;
  }
  return best;
}

// The weights of a neuron as settle() would leave them: what combine() does, in a row.
std::span<const float> DenseLearner::settled_row(std::size_t neuron) {
  const std::size_t columns = som_.weights().columns();
  som_.weights().copy_row(neuron, {scratch_row_.data(), columns});
  if (moved_[neuron / kFloatLanes] != 0) {
    float gains[kPending];
    for (std::size_t j = 0; j < made(); ++j) gains[j] = float_gain(neuron, j);
    kernels::online_table().combine_row(scratch_row_.data(), slots_.padded(),
                                        static_cast<float>(kept_[neuron]), gains, slots_.rows(0, 0),
                                        made(), limit());
  }
  return {scratch_row_.data(), columns};
}

double DenseLearner::exact_score(std::span<const float> weights) const {
  const auto& kernels = kernels::batch_table();
  const float* x = slots_.input(pending_).data();
  return dot_product() ? -kernels.inner_product(weights.data(), x, weights.size())
                       : kernels.squared_distance(weights.data(), x, weights.size());
}

}  // namespace somato
