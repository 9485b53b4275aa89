#include "maps/online/sparse_learner.h"

// Neuron k has the weights w_k = c_k v_k, so that learning input x with gain a,
//
//     w_k <- (1-a) w_k + a x,   that is   c_k <- (1-a) c_k,   v_k <- v_k + (a / c_k) x,
//
// accesses only the non-zero elements of x; their weights are contiguous, one row of all neurons
// per element. A normalization only changes c_k. The winner follows from |w|^2 - 2 w . x: products
// are summed in double precision, and |v_k|^2 changes by exactly what its changed elements do, as
// they are after rounding, so that no error adds up; it is computed again at each folding. Folding
// writes c_k into the weights where c_k gets small; then c_k = 1 again.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "base/core/lanes.h"
#include "base/kernels/online_kernels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// A slab is so large that it gets large pages.
constexpr std::size_t kSlabBytes = std::size_t{1} << 22;

constexpr std::size_t kRowsAtOnce = 4;
constexpr std::size_t kRowsAhead = 8;

// Lanes to work on that take longer than telling other threads.
constexpr std::size_t kSparseWorthSharing = std::size_t{1} << 15;

// Scales keep v = w / c within single precision.
constexpr double kSmallestScale = 0x1p-100;
constexpr double kLargestScale = 0x1p60;

// Smaller factors would only slow down.
constexpr double kSmallestSparseFactor = 0x1p-100;

void prefetch(const float* row, std::size_t size) {
  for (std::size_t i = 0; i < size; i += kFloatLanes) __builtin_prefetch(row + i, 1, 2);
}

// A few rows, as kernels take them.
struct RowGroup {
  std::array<float*, kRowsAtOnce> rows;
  std::array<float, kRowsAtOnce> values;
  std::size_t count = 0;

  void add(float* row, float value) {
    rows[count] = row;
    values[count] = value;
    ++count;
  }
};

}  // namespace

ElementRows::ElementRows(std::size_t elements, std::size_t row_size, std::size_t parts)
    : blocks_(row_size / kFloatLanes),
      parts_(std::clamp<std::size_t>(parts, 1, std::max<std::size_t>(1, blocks_))),
      rows_in_slab_(static_cast<std::uint32_t>(
          std::bit_ceil(kSlabBytes / (std::max<std::size_t>(1, row_size) * sizeof(float)) + 1))),
      numbers_(elements) {}

std::uint32_t ElementRows::number_of(std::size_t element) {
  std::uint32_t& number = numbers_[element];
  if (number == 0) {
    if (count_ % rows_in_slab_ == 0) slabs_.emplace_back(rows_in_slab_ * blocks_ * kFloatLanes);
    number = ++count_;
  }
  return number - 1;
}

SparseLearner::SparseLearner(Som& som, ThreadTeam& team)
    : som_(som),
      team_(team),
      rows_padded_(som.weights().padded_rows()),
      neighbourhood_(som.grid(), som.parameters().neighbourhood),
      values_(som.input_size(), rows_padded_, team.size()),
      scales_(rows_padded_, 1.0),
      squared_lengths_(rows_padded_),
      products_(rows_padded_),
      gains_(rows_padded_),
      factors_(rows_padded_) {
  load();
}

// Calls `work` for parts of the lanes of so many rows.
template <typename Work>
void SparseLearner::for_each_part(std::size_t rows, const Work& work) {
  if (rows * rows_padded_ < kSparseWorthSharing) {
    for (std::size_t part = 0; part < values_.parts(); ++part) work(part);
  } else {
    team_.for_each(values_.parts(), work);
  }
}

bool SparseLearner::dot_product() const {
  return som_.parameters().similarity == Similarity::kDotProduct;
}

// Elements whose weights are all 0 need no row.
void SparseLearner::load() {
  const LaneMatrix<float>& weights = som_.weights();
  const StoredElements& elements = som_.elements();
  const auto is_zero = [](float weight) { return weight == 0.0F; };
  for (std::size_t place = 0; place < weights.columns(); ++place) {
    for (std::size_t block = 0; block < weights.blocks(); ++block) {
      const float* lanes = weights.data() + (block * weights.columns() + place) * kFloatLanes;
      if (std::all_of(lanes, lanes + kFloatLanes, is_zero)) continue;
      values_.number_of(elements.all() ? place : elements.listed()[place]);
      break;
    }
  }
  std::fill(factors_.begin(), factors_.end(), 1.0F);
  for_each_part(values_.count(), [&](std::size_t part) { load_part(part); });
  // Lanes without a neuron stay as they are.
  std::fill(factors_.begin(), factors_.end(), 0.0F);
}

void SparseLearner::load_part(std::size_t part) {
  const LaneMatrix<float>& weights = som_.weights();
  const StoredElements& elements = som_.elements();
  const std::size_t first = values_.begin(part);
  const std::size_t count = values_.begin(part + 1) - first;
  for (std::size_t place = 0; place < weights.columns(); ++place) {
    const std::size_t element = elements.all() ? place : elements.listed()[place];
    if (!values_.has(element)) continue;
    float* row = values_.row(values_.number_of(element), part);
    const float* lanes = weights.data() + first * weights.columns() + place * kFloatLanes;
    for (std::size_t i = 0; i < count; i += kFloatLanes, lanes += weights.columns() * kFloatLanes) {
      std::copy_n(lanes, kFloatLanes, row + i);
    }
    kernels::online_table().fold_row(row, factors_.data() + first, count,
                                     squared_lengths_.data() + first);
  }
}

Learned SparseLearner::learn(std::span<const OnlineInput> inputs,
                             std::span<const LearningStep> steps) {
  learned_ = true;
  const SignalView& input = inputs.front().values;
  take_input(input, som_.input_factor(input));
  for_each_part(input_rows_.size(), [&](std::size_t part) { add_products(part); });
  const std::size_t nearest = winner();
  neighbourhood_.around(nearest, steps.front().radius, gains_);
  move(steps.front().learning_rate);
  if (dot_product()) normalize();
  return {1, nearest};
}

void SparseLearner::take_input(const SignalView& input, double factor) {
  input_rows_.clear();
  input_values_.clear();
  squared_input_ = 0.0;
  for (std::size_t i = 0; i < input.values.size(); ++i) {
    const auto value = static_cast<float>(input.values[i] * factor);
    if (value == 0.0F) continue;
    input_rows_.push_back(values_.number_of(input.indices[i]));
    input_values_.push_back(value);
    squared_input_ = std::fma(double{value}, double{value}, squared_input_);
    largest_ = std::max(largest_, std::fabs(double{value}));
  }
}

void SparseLearner::add_products(std::size_t part) {
  const std::size_t first = values_.begin(part);
  const std::size_t count = values_.begin(part + 1) - first;
  double* products = products_.data() + first;
  std::fill_n(products, count, 0.0);
  const std::size_t size = input_rows_.size();
  for (std::size_t i = 0; i < size;) {
    RowGroup group;
    for (; group.count < kRowsAtOnce && i < size; ++i) {
      if (i + kRowsAhead < size) prefetch(values_.row(input_rows_[i + kRowsAhead], part), count);
      group.add(values_.row(input_rows_[i], part), input_values_[i]);
    }
    kernels::online_table().add_rows(group.rows.data(), group.values.data(), group.count, count,
                                     products);
  }
}

std::size_t SparseLearner::winner() const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    const double product = scales_[neuron] * products_[neuron];
    const double squared_length = scales_[neuron] * scales_[neuron] * squared_lengths_[neuron];
    const double score = dot_product() ? -product : squared_length - 2.0 * product;
    if (score >= least) continue;
    least = score;
    best = neuron;
  }
  return best;
}

bool SparseLearner::out_of_range(double scale) const {
  return std::fabs(scale) < kSmallestScale * largest_ || std::fabs(scale) > kLargestScale;
}

void SparseLearner::move(double learning_rate) {
  bool folds = false;
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    const double gain = learning_rate * double{gains_[neuron]};
    scales_[neuron] *= 1.0 - gain;
    folds = folds || out_of_range(scales_[neuron]);
  }
  if (folds) {
    for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
      factors_[neuron] = static_cast<float>(scales_[neuron]);
    }
    fold();
  }
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    const double factor = learning_rate * double{gains_[neuron]} / scales_[neuron];
    factors_[neuron] =
        std::fabs(factor) < kSmallestSparseFactor ? 0.0F : static_cast<float>(factor);
  }
  for_each_part(input_rows_.size(), [&](std::size_t part) { move_part(part); });
}

bool SparseLearner::moves(std::size_t block) const {
  const auto begin = factors_.begin() + static_cast<std::ptrdiff_t>(block * kFloatLanes);
  return std::any_of(begin, begin + kFloatLanes, [](float factor) { return factor != 0.0F; });
}

// Runs of blocks in which something moves.
void SparseLearner::move_part(std::size_t part) {
  const std::size_t end = values_.begin(part + 1) / kFloatLanes;
  for (std::size_t block = values_.begin(part) / kFloatLanes; block < end; ++block) {
    if (!moves(block)) continue;
    const std::size_t first = block;
    while (block < end && moves(block)) ++block;
    move_lanes(part, first * kFloatLanes, (block - first) * kFloatLanes);
  }
}

// From the last row on, which was used last and is in a cache.
void SparseLearner::move_lanes(std::size_t part, std::size_t first, std::size_t count) {
  const std::size_t within = first - values_.begin(part);
  for (std::size_t left = input_rows_.size(); left > 0;) {
    RowGroup group;
    for (; group.count < kRowsAtOnce && left > 0; --left) {
      group.add(values_.row(input_rows_[left - 1], part) + within, input_values_[left - 1]);
    }
    kernels::online_table().move_rows(group.rows.data(), group.values.data(), group.count,
                                      factors_.data() + first, count,
                                      squared_lengths_.data() + first);
  }
}

// Every weight times its neuron's factor; scales are 1 then.
void SparseLearner::fold() {
  std::fill(squared_lengths_.begin(), squared_lengths_.end(), 0.0);
  for_each_part(values_.count(), [&](std::size_t part) { fold_part(part); });
  std::fill(scales_.begin(), scales_.end(), 1.0);
}

void SparseLearner::fold_part(std::size_t part) {
  const std::size_t first = values_.begin(part);
  const std::size_t count = values_.begin(part + 1) - first;
  for (std::uint32_t number = 0; number < values_.count(); ++number) {
    kernels::online_table().fold_row(values_.row(number, part), factors_.data() + first, count,
                                     squared_lengths_.data() + first);
  }
}

void SparseLearner::normalize() {
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    if (squared_lengths_[neuron] <= 0.0) continue;
    const double length = std::fabs(scales_[neuron]) * std::sqrt(squared_lengths_[neuron]);
    scales_[neuron] /= length;
  }
}

// For a map of some elements, those of inputs as well.
StoredElements SparseLearner::elements_to_store() const {
  const StoredElements& before = som_.elements();
  if (before.all()) return before;
  std::vector<std::uint32_t> listed;
  listed.reserve(before.count() + values_.count());
  std::size_t place = 0;
  for (std::uint32_t element = 0; element < before.size(); ++element) {
    const bool was = place < before.count() && before.listed()[place] == element;
    if (was) ++place;
    if (was || values_.has(element)) listed.push_back(element);
  }
  if (2 * listed.size() >= before.size()) return StoredElements(before.size());
  return {before.size(), std::move(listed)};
}

void SparseLearner::settle() {
  if (!learned_) return;
  learned_ = false;
  write(som_);
}

Som SparseLearner::look() {
  Som som = som_;
  if (learned_) write(som);
  return som;
}

void SparseLearner::write(Som& som) {
  const StoredElements elements = elements_to_store();
  if (elements != som.elements()) {
    som = Som(som.parameters(), LaneMatrix<float>(som.neurons(), elements.count()), elements);
  }
  weights_to_change(som);  // before threads write them
  for_each_part(elements.count(), [&](std::size_t part) { write_part(part, som); });
}

void SparseLearner::write_part(std::size_t part, Som& som) {
  LaneMatrix<float>& weights = weights_to_change(som);
  const StoredElements& elements = som.elements();
  const std::size_t first = values_.begin(part);
  const std::size_t count = values_.begin(part + 1) - first;
  for (std::size_t place = 0; place < weights.columns(); ++place) {
    const std::size_t element = elements.all() ? place : elements.listed()[place];
    if (!values_.has(element)) continue;
    kernels::online_table().scale_row(
        values_.row(values_.number_of(element), part), scales_.data() + first, count,
        weights.data() + first * weights.columns() + place * kFloatLanes,
        weights.columns() * kFloatLanes);
  }
}

}  // namespace somato
