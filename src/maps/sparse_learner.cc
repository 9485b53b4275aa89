#include "maps/sparse_learner.h"

// Neuron k has the weights w_k = c_k v_k, so that learning input x with gain a,
//
//     w_k <- (1-a) w_k + a x,   that is   c_k <- (1-a) c_k,   v_k <- v_k + (a / c_k) x,
//
// touches only the elements of x that are not 0; their weights stand side by side, one row of all
// neurons an element. A normalization changes c_k alone. The winner follows from |w|^2 - 2 w . x:
// products are summed in double precision, and |v_k|^2 changes by exactly what its changed elements
// do, as they are after rounding, so that no error adds up; it is measured anew at each folding.
// Folding writes c_k into the weights where c_k gets small; then c_k = 1 again.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/kernels.h"
#include "core/online_kernels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kLanes = LaneMatrix<float>::kLanes;
constexpr std::size_t kRowsInSlab = 1024;
constexpr std::size_t kRowsAhead = 8;

// Scales keep v = w / c within single precision.
constexpr double kSmallestScale = 0x1p-100;
constexpr double kLargestScale = 0x1p60;

// Smaller factors would only slow down.
constexpr double kSmallestGain = 0x1p-100;

void prefetch(const float* row, std::size_t size) {
  for (std::size_t i = 0; i < size; i += kLanes) __builtin_prefetch(row + i, 1, 2);
}

}  // namespace

ElementRows::ElementRows(std::size_t elements, std::size_t row_size)
    : row_size_(row_size), numbers_(elements) {}

float* ElementRows::row(std::size_t number) {
  return slabs_[number / kRowsInSlab].data() + number % kRowsInSlab * row_size_;
}

float* ElementRows::row_of(std::size_t element) {
  std::uint32_t& number = numbers_[element];
  if (number == 0) {
    if (count_ % kRowsInSlab == 0) slabs_.emplace_back(kRowsInSlab * row_size_);
    number = static_cast<std::uint32_t>(++count_);
  }
  return row(number - 1);
}

SparseLearner::SparseLearner(Som& som)
    : som_(som),
      rows_padded_(som.weights().padded_rows()),
      neighbourhood_(som.grid(), som.parameters().neighbourhood),
      values_(som.input_size(), rows_padded_),
      scales_(rows_padded_, 1.0),
      squared_lengths_(rows_padded_),
      products_(rows_padded_),
      gains_(rows_padded_),
      factors_(rows_padded_) {
  load();
}

bool SparseLearner::dot_product() const {
  return som_.parameters().similarity == Similarity::kDotProduct;
}

// Elements whose weights are all 0 need no row.
void SparseLearner::load() {
  const LaneMatrix<float>& weights = som_.weights();
  const StoredElements& elements = som_.elements();
  for (std::size_t block = 0; block < weights.blocks(); ++block) {
    const float* lanes = weights.data() + block * weights.columns() * kLanes;
    for (std::size_t place = 0; place < weights.columns(); ++place, lanes += kLanes) {
      const auto is_zero = [](float weight) { return weight == 0.0F; };
      if (std::all_of(lanes, lanes + kLanes, is_zero)) continue;
      const std::size_t element = elements.all() ? place : elements.listed()[place];
      std::copy_n(lanes, kLanes, values_.row_of(element) + block * kLanes);
    }
  }
  std::fill(factors_.begin(), factors_.end(), 1.0F);
  fold();
}

std::size_t SparseLearner::learn(const SignalView& input, double factor, double learning_rate,
                                 double radius) {
  learned_ = true;
  take_input(input, factor);
  compute_products();
  const std::size_t nearest = winner();
  neighbourhood_.around(nearest, radius, gains_);
  move(learning_rate);
  if (dot_product()) normalize();
  return nearest;
}

void SparseLearner::take_input(const SignalView& input, double factor) {
  input_rows_.clear();
  input_values_.clear();
  squared_input_ = 0.0;
  for (std::size_t i = 0; i < input.values.size(); ++i) {
    const auto value = static_cast<float>(input.values[i] * factor);
    if (value == 0.0F) continue;
    input_rows_.push_back(values_.row_of(input.indices[i]));
    input_values_.push_back(value);
    squared_input_ = std::fma(double{value}, double{value}, squared_input_);
    largest_ = std::max(largest_, std::fabs(double{value}));
  }
}

void SparseLearner::compute_products() {
  const auto& kernels = kernels::table<float>();
  std::fill(products_.begin(), products_.end(), 0.0);
  for (std::size_t i = 0; i < input_rows_.size(); ++i) {
    if (i + kRowsAhead < input_rows_.size()) prefetch(input_rows_[i + kRowsAhead], rows_padded_);
    kernels.add_scaled(input_rows_[i], double{input_values_[i]}, rows_padded_, products_.data());
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
    factors_[neuron] = std::fabs(factor) < kSmallestGain ? 0.0F : static_cast<float>(factor);
  }
  move_rows();
}

// Runs of blocks in which something moves.
void SparseLearner::move_rows() {
  const auto moves = [&](std::size_t block) {
    const auto begin = factors_.begin() + static_cast<std::ptrdiff_t>(block * kLanes);
    return std::any_of(begin, begin + kLanes, [](float factor) { return factor != 0.0F; });
  };
  const auto& kernels = kernels::online_table();
  const std::size_t blocks = rows_padded_ / kLanes;
  for (std::size_t block = 0; block < blocks; ++block) {
    if (!moves(block)) continue;
    const std::size_t first = block * kLanes;
    while (block < blocks && moves(block)) ++block;
    const std::size_t count = block * kLanes - first;
    for (std::size_t i = 0; i < input_rows_.size(); ++i) {
      kernels.move_row(input_rows_[i] + first, input_values_[i], factors_.data() + first, count,
                       squared_lengths_.data() + first);
    }
  }
}

// Every weight times its neuron's factor; scales are 1 then.
void SparseLearner::fold() {
  std::fill(squared_lengths_.begin(), squared_lengths_.end(), 0.0);
  for (std::size_t number = 0; number < values_.count(); ++number) {
    kernels::online_table().fold_row(values_.row(number), factors_.data(), rows_padded_,
                                     squared_lengths_.data());
  }
  std::fill(scales_.begin(), scales_.end(), 1.0);
}

void SparseLearner::normalize() {
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    if (squared_lengths_[neuron] <= 0.0) continue;
    const double length = std::fabs(scales_[neuron]) * std::sqrt(squared_lengths_[neuron]);
    scales_[neuron] /= length;
  }
}

// Of a map of some elements, those of inputs as well.
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
  const StoredElements elements = elements_to_store();
  if (elements != som_.elements()) {
    som_ = Som(som_.parameters(), LaneMatrix<float>(som_.neurons(), elements.count()), elements);
  }
  LaneMatrix<float>& weights = som_.weights();
  for (std::size_t place = 0; place < weights.columns(); ++place) {
    const std::size_t element = elements.all() ? place : elements.listed()[place];
    if (!values_.has(element)) continue;
    const float* row = values_.row_of(element);
    for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
      const auto weight = static_cast<float>(scales_[neuron] * double{row[neuron]});
      weights(neuron, place) = std::fabs(weight) < kernels::kNegligible<float> ? 0.0F : weight;
    }
  }
}

}  // namespace somato
