#include "maps/online/growing_grid.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/core/elementary.h"

namespace somato {
namespace {

std::size_t steps_between(std::size_t a, std::size_t b) {
  return a < b ? b - a : a - b;
}

}  // namespace

const Declarations<GrowingGridParameters>& GrowingGridParameters::declarations() {
  using P = GrowingGridParameters;
  static const auto declared =
      Declarations<P>()
          .add_from(&P::growth, GrowthParameters::declarations(), {"draws", "most_neurons"})
          .add("growth_inputs", &P::growth_inputs, "inputs", Range::between(1, 1e9),
               "Number of inputs for each neuron before a row or column is inserted. Not given in "
               "the paper.")
          .add("tuning_inputs", &P::tuning_inputs, "inputs", Range::between(1, 1e9),
               "Number of inputs for each neuron after growth. Not given in the paper.")
          .add("radius", &P::radius, "neurons", Range::above(0),
               "Width of the neighbourhood function, which is constant. Not given in the paper.")
          .add("learning_rate_start", &P::learning_rate_start, "", Range::between(1e-9, 1),
               "Learning rate while the map grows. Not given in the paper.")
          .add("learning_rate_end", &P::learning_rate_end, "", Range::between(1e-9, 1),
               "Learning rate at the end. Not given in the paper.")
          .add_from(&P::growth, GrowthParameters::declarations(),
                    {"softmax", "softmax_exponent", "activity_norm", "seed"});
  return declared;
}

GrowingGrid::GrowingGrid(const GrowingGridParameters& parameters, const Samples& samples)
    : parameters_(parameters),
      weights_(drawn_weights(samples, 4, parameters.growth.seed)),
      counters_(4, 0) {}

GrowingGrid::GrowingGrid(const GrowingGridParameters& parameters, const Som& som)
    : parameters_(parameters),
      rows_(som.grid().rows()),
      columns_(som.grid().columns()),
      weights_(som),
      counters_(som.neurons(), 0) {}

void GrowingGrid::resume() {
  weights_.number_anew();
  tuned_ = 0;
}

void GrowingGrid::save(Archive& archive, const std::string& prefix) const {
  add_counts(archive, prefix + "counters", counters_);
  add_counts(archive, prefix + "inputs", {inputs_, tuned_});
}

Result<void> GrowingGrid::load(const Archive& archive, const std::string& prefix,
                               const std::string& where) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max();
  SOMATO_TRY(auto counters, counts_from(archive, prefix + "counters", neurons(), kMost, where));
  SOMATO_TRY(const auto inputs, counts_from(archive, prefix + "inputs", 2, kMost, where));
  counters_ = std::move(counters);
  inputs_ = inputs[0];
  tuned_ = inputs[1];
  return {};
}

double GrowingGrid::learning_rate() const {
  const double start = parameters_.learning_rate_start;
  if (grows()) return start;
  const double time = static_cast<double>(tuned_) / static_cast<double>(tuning_inputs());
  return start * power(parameters_.learning_rate_end / start, time);
}

void GrowingGrid::learn(std::span<const float> input) {
  if (is_complete()) return;
  const std::size_t winner = weights_.nearest_two(input).first;
  adapt(winner, input, learning_rate());
  ++counters_[winner];
  ++inputs_;
  if (!grows()) {
    ++tuned_;
  } else if (inputs_ == parameters_.growth_inputs * neurons()) {
    insert();
  }
}

void GrowingGrid::adapt(std::size_t winner, std::span<const float> input, double rate) {
  const double width = 2.0 * parameters_.radius * parameters_.radius;
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    const auto steps = static_cast<double>(steps_between(neuron / columns_, winner / columns_) +
                                           steps_between(neuron % columns_, winner % columns_));
    weights_.move(neuron, input, rate * exponential(-steps * steps / width));
  }
}

void GrowingGrid::insert() {
  const auto most = std::max_element(counters_.begin(), counters_.end());
  const auto from = static_cast<std::size_t>(most - counters_.begin());
  const std::vector<std::size_t> around = grid().neighbours(from);
  const auto distance = [&](std::size_t other) {
    return GrowingWeights::squared_distance(weights_[from], weights_[other]);
  };
  const std::size_t to =
      *std::max_element(around.begin(), around.end(),
                        [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  insert_between(std::min(from, to), std::max(from, to));
  counters_.assign(neurons(), 0);
  inputs_ = 0;
}

// Neurons one below the other are separated by a row, neurons beside each other by a column.
void GrowingGrid::insert_between(std::size_t a, std::size_t b) {
  const bool is_row = b - a == columns_ && columns_ > 1;
  const std::size_t before = is_row ? a / columns_ : a % columns_;
  const std::size_t rows = rows_ + (is_row ? 1 : 0);
  const std::size_t columns = columns_ + (is_row ? 0 : 1);
  GrowingWeights grown(weights_.rows().columns());
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t place = is_row ? row : column;
      const std::size_t old_row = is_row && row > before ? row - 1 : row;
      const std::size_t old_column = !is_row && column > before ? column - 1 : column;
      const std::size_t old = old_row * columns_ + old_column;
      if (place == before + 1) {
        grown.add_between(weights_[old], weights_[old + (is_row ? columns_ : 1)]);
      } else {
        grown.add_from(weights_, old);
      }
    }
  }
  weights_ = std::move(grown);
  rows_ = rows;
  columns_ = columns;
}

Som GrowingGrid::map() const {
  GrowthParameters growth = parameters_.growth;
  growth.iterations = 1;
  return {parameters_of_grown(growth, rows_, columns_), weights_.rows()};
}

}  // namespace somato
