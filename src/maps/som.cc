#include "somato/maps/som.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/lanes.h"
#include "maps/activity.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// 1 for zeros, which have no direction.
double factor_to_length_one(std::span<const float> values) {
  double sum = 0.0;
  for (const float value : values) sum = std::fma(double{value}, double{value}, sum);
  return sum == 0.0 ? 1.0 : 1.0 / std::sqrt(sum);
}

}  // namespace

Som::Som(SomParameters parameters, const Matrix<float>& weights)
    : Som(std::move(parameters), LaneMatrix<float>(weights)) {}

Som::Som(SomParameters parameters, LaneMatrix<float> weights)
    : parameters_(std::move(parameters)),
      grid_(parameters_.grid()),
      weights_(std::move(weights)),
      elements_(weights_.columns()) {
  require(weights_.rows() == grid_.size(), "a map needs one row of weights a neuron");
}

Som::Som(SomParameters parameters, LaneMatrix<float> weights, StoredElements elements)
    : Som(std::move(parameters), std::move(weights)) {
  elements_ = std::move(elements);
  require(weights_.columns() == elements_.count(), "a map needs a weight for each stored element");
}

float Som::weight(std::size_t neuron, std::size_t element) const {
  const auto place = elements_.place_of(element);
  return place ? weights_(neuron, *place) : 0.0F;
}

void Som::store_all() {
  if (elements_.all()) return;
  LaneMatrix<float> weights(neurons(), input_size());
  for (std::size_t place = 0; place < elements_.count(); ++place) {
    const std::size_t element = elements_.listed()[place];
    for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
      weights(neuron, element) = weights_(neuron, place);
    }
  }
  weights_ = std::move(weights);
  elements_ = StoredElements(elements_.size());
}

double Som::input_factor(const SignalView& input) const {
  return parameters_.normalize_input.value_or(false) ? factor_to_length_one(input.values) : 1.0;
}

std::span<const float> Som::prepare(const SignalView& input, SomWorkspace& workspace) const {
  require(input.size == input_size(), "the input's size differs from the map's input size");
  const bool normalize = parameters_.normalize_input.value_or(false);
  workspace.left_out_ = 0.0;
  if (!input.sparse && !normalize && elements_.all()) return input.values;
  workspace.input_.resize(elements_.count());
  workspace.left_out_ = elements_.gather(input, workspace.input_, input_factor(input));
  return workspace.input_;
}

// Squared distances or inner products: what decides the winner.
std::span<const float> Som::scores(const SignalView& input, SomWorkspace& workspace) const {
  return scores_of(prepare(input, workspace), workspace);
}

std::span<const float> Som::scores_of(std::span<const float> x, SomWorkspace& workspace) const {
  workspace.scores_.resize(weights_.padded_rows());
  const auto& kernels = kernels::table<float>();
  const auto compute = parameters_.similarity == Similarity::kEuclidean ? kernels.squared_distances
                                                                        : kernels.inner_products;
  compute(kernels::lanes(weights_), x.data(), workspace.scores_.data());
  return {workspace.scores_.data(), neurons()};
}

bool Som::prefers(float score, float other) const {
  return parameters_.similarity == Similarity::kEuclidean ? score < other : score > other;
}

std::size_t Som::winner(const SignalView& input, SomWorkspace& workspace) const {
  return winner_of(prepare(input, workspace), workspace);
}

std::size_t Som::winner_of(std::span<const float> prepared, SomWorkspace& workspace) const {
  const std::span<const float> all = scores_of(prepared, workspace);
  const auto best = parameters_.similarity == Similarity::kEuclidean
                        ? std::min_element(all.begin(), all.end())
                        : std::max_element(all.begin(), all.end());
  return static_cast<std::size_t>(best - all.begin());
}

Winners Som::winners(const SignalView& input, SomWorkspace& workspace) const {
  const std::span<const float> all = scores(input, workspace);
  if (all.size() == 1) return {};
  Winners winners{0, 1};
  if (prefers(all[1], all[0])) std::swap(winners.first, winners.second);
  for (std::size_t neuron = 2; neuron < all.size(); ++neuron) {
    if (prefers(all[neuron], all[winners.first])) {
      winners = {neuron, winners.first};
    } else if (prefers(all[neuron], all[winners.second])) {
      winners.second = neuron;
    }
  }
  return winners;
}

std::size_t Som::winner_among(std::span<const std::size_t> candidates, const SignalView& input,
                              SomWorkspace& workspace) const {
  require(!candidates.empty(), "winner_among needs at least one candidate");
  const std::span<const float> all = scores(input, workspace);
  std::size_t best = candidates.front();
  for (const std::size_t neuron : candidates) {
    require(neuron < all.size(), "winner_among: no such neuron");
    if (prefers(all[neuron], all[best])) best = neuron;
  }
  return best;
}

void Som::similarities(const SignalView& input, SomWorkspace& workspace,
                       std::span<float> out) const {
  require(out.size() == neurons(), "similarities need room for a value a neuron");
  const std::span<const float> all = scores(input, workspace);
  if (parameters_.similarity == Similarity::kDotProduct) {
    std::copy(all.begin(), all.end(), out.begin());
    return;
  }
  for (std::size_t neuron = 0; neuron < all.size(); ++neuron) {
    out[neuron] = similarity_at(double{all[neuron]} + workspace.left_out_);
  }
}

void Som::activity(const SignalView& input, SomWorkspace& workspace, std::span<float> out) const {
  similarities(input, workspace, out);
  activity_of_similarities(parameters_, out);
}

double Som::distance(const SignalView& input, std::size_t neuron, SomWorkspace& workspace) const {
  const std::span<const float> x = prepare(input, workspace);
  double sum = workspace.left_out_;
  for (std::size_t d = 0; d < x.size(); ++d) {
    const double difference = double{x[d]} - double{weights_(neuron, d)};
    sum = std::fma(difference, difference, sum);
  }
  return std::sqrt(sum);
}

void normalize_length(std::span<float> values) {
  const double factor = factor_to_length_one(values);
  for (float& value : values) value = static_cast<float>(value * factor);
}

}  // namespace somato
