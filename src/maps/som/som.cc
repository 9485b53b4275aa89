#include "somato/maps/som.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/core/lanes.h"
#include "base/kernels/batch_kernels.h"
#include "maps/grid/activity.h"
#include "maps/reading/known_elements.h"
#include "maps/reading/similarity_scores.h"
#include "maps/som/product_reading.h"
#include "maps/som/relevances.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// 1 for zeros, which have no direction.
double factor_to_length_one(std::span<const float> values) {
  double sum = 0.0;
  for (const float value : values) sum = std::fma(double{value}, double{value}, sum);
  return sum == 0.0 ? 1.0 : 1.0 / std::sqrt(sum);
}

// The second least of the scores, `least` being one of them.
float second_least(std::span<const float> scores, float least) {
  float second = std::numeric_limits<float>::infinity();
  bool met = false;
  for (const float score : scores) {
    if (score == least && !met) {
      met = true;
    } else {
      second = std::min(second, score);
    }
  }
  return second;
}

}  // namespace

Som::Som(SomParameters parameters, const Matrix<float>& weights)
    : Som(std::move(parameters), LaneMatrix<float>(weights)) {}

Som::Som(SomParameters parameters, LaneMatrix<float> weights)
    : parameters_(std::move(parameters)),
      grid_(parameters_.grid()),
      weights_(std::move(weights)),
      elements_(weights_.columns()),
      input_scales_(scales_of_relevances(parameters_)) {
  require(weights_.rows() == grid_.size(), "a map needs one row of weights per neuron");
}

Som::Som(SomParameters parameters, LaneMatrix<float> weights, StoredElements elements)
    : Som(std::move(parameters), std::move(weights)) {
  elements_ = std::move(elements);
  require(weights_.columns() == elements_.count(), "a map needs a weight for each stored element");
  require(input_scales_.empty() || input_scales_.size() == elements_.count(),
          "a map needs a relevance for each element");
  // The greatest difference may be that of an element that is not stored, and layers count all.
  if (parameters_.similarity == Similarity::kChebyshev || !parameters_.layers.empty()) store_all();
}

Som::Som(SomParameters parameters, const Matrix<float>& weights,
         std::shared_ptr<const NeuronGraph> graph)
    : Som(std::move(parameters), weights) {
  require(grid_.rows() == 1 && grid_.columns() == graph->size(),
          "a map needs a neuron of its graph in each column");
  grid_ = Grid(std::move(graph));
}

float Som::weight(std::size_t neuron, std::size_t element) const {
  const auto place = elements_.place_of(element);
  if (!place) return 0.0F;
  const float weight = weights()(neuron, *place);
  return input_scales_.empty() ? weight : weight / input_scales_[*place];
}

void Som::store_all() {
  if (!elements_.all()) store(StoredElements(elements_.size()));
}

// `elements` contains those that are stored already.
void Som::store(StoredElements elements) {
  const LaneMatrix<float>& stored = weights();
  LaneMatrix<float> more(neurons(), elements.count());
  for (std::size_t place = 0; place < elements_.count(); ++place) {
    const std::size_t element = elements_.all() ? place : elements_.listed()[place];
    const std::size_t column = *elements.place_of(element);
    for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
      more(neuron, column) = stored(neuron, place);
    }
  }
  weights_ = std::move(more);
  products_.reset();
  elements_ = std::move(elements);
}

Som Som::with_neuron_at(std::size_t neuron, const SignalView& input) const {
  require(neuron < neurons(), "the map does not have this neuron");
  Som changed = *this;
  changed.store(elements_.with(input));
  SomWorkspace workspace;
  const std::span<const float> prepared = changed.prepare(input, workspace);
  std::vector<float> weights(prepared.begin(), prepared.end());
  if (parameters_.similarity == Similarity::kDotProduct) normalize_length(weights);
  for (std::size_t place = 0; place < weights.size(); ++place) {
    changed.weights_(neuron, place) = weights[place];
  }
  return changed;
}

double Som::input_factor(const SignalView& input) const {
  return parameters_.normalize_input.value_or(false) ? factor_to_length_one(input.values) : 1.0;
}

std::span<const float> Som::prepare(const SignalView& input, SomWorkspace& workspace) const {
  require(input.size == input_size(), "the input's size differs from the map's input size");
  const bool normalize = parameters_.normalize_input.value_or(false);
  workspace.left_out_ = 0.0;
  const bool as_it_is = !normalize && input_scales_.empty();
  if (!input.sparse && as_it_is && elements_.all()) return input.values;
  workspace.input_.resize(elements_.count());
  const double factor = input_factor(input);
  workspace.left_out_ = elements_.gather(input, workspace.input_, factor);
  if (parameters_.similarity == Similarity::kManhattan) {
    workspace.left_out_ = elements_.magnitude_of_others(input, factor);
  }
  scale_elements(input_scales_, workspace.input_);
  return workspace.input_;
}

// Squared distances, inner products or other scores: what decides the winner.
std::span<const float> Som::scores(const SignalView& input, SomWorkspace& workspace) const {
  return scores_of(prepare(input, workspace), workspace);
}

std::span<const float> Som::scores_of(std::span<const float> x, SomWorkspace& workspace) const {
  workspace.scores_.resize(weights().padded_rows());
  if (!parameters_.layers.empty()) {
    const std::vector<KnownRun> all{{0, x.size()}};
    KnownScores(parameters_, x, all)
        .write(kernels::lanes(weights()), neurons(), workspace.scores_.data());
    return {workspace.scores_.data(), neurons()};
  }
  if (!follows_from_products(parameters_)) {
    const float* const input = x.data();
    float* const out = workspace.scores_.data();
    SimilarityScores(parameters_.similarity, kernels::lanes(weights()), neurons())
        .write({&input, 1}, {&out, 1});
    return {out, neurons()};
  }
  const auto& kernels = kernels::table<float>();
  const auto compute = parameters_.similarity == Similarity::kEuclidean ? kernels.squared_distances
                                                                        : kernels.inner_products;
  compute(kernels::lanes(weights()), x.data(), workspace.scores_.data());
  return {workspace.scores_.data(), neurons()};
}

std::size_t Som::winner(const SignalView& input, SomWorkspace& workspace) const {
  return winner_of(prepare(input, workspace), workspace);
}

std::size_t Som::winner(std::span<const float> input) const {
  static thread_local SomWorkspace workspace;
  return winner(SignalView::dense(input), workspace);
}

std::size_t Som::winner_of(std::span<const float> prepared, SomWorkspace& workspace) const {
  return best_of(prepared, false, workspace).first;
}

Winners Som::winners(const SignalView& input, SomWorkspace& workspace) const {
  return best_of(prepare(input, workspace), true, workspace);
}

// Scores of which the least wins, filled up to whole blocks with infinite ones.
std::span<const float> Som::ascending_scores_of(std::span<const float> prepared,
                                                SomWorkspace& workspace) const {
  scores_of(prepared, workspace);
  if (parameters_.similarity == Similarity::kDotProduct) {
    for (float& score : workspace.scores_) score = -score;
  }
  std::fill(workspace.scores_.begin() + static_cast<std::ptrdiff_t>(neurons()),
            workspace.scores_.end(), std::numeric_limits<float>::infinity());
  return workspace.scores_;
}

// The maximum difference between the lowest score in single precision and that of the lowest one in
// double precision: the error of each is at most `rounding` of the squared distance, which is a sum
// of positive terms, or of |x| |w|, with |w| = 1 in a dot-product map.
float Som::score_margin(float least, std::span<const float> prepared) const {
  if (!parameters_.layers.empty()) return static_cast<float>(layered_margin(parameters_, least));
  if (!follows_from_products(parameters_)) {
    return static_cast<float>(somato::score_margin(parameters_.similarity, least, prepared));
  }
  const auto columns = static_cast<double>(elements_.count());
  constexpr auto kChunk = static_cast<double>(kernels::kChunk);
  const double rounding = (std::min(columns, kChunk) + columns / kChunk + 4.0) * 0x1p-24;
  auto scale = double{least};
  if (parameters_.similarity == Similarity::kDotProduct) {
    scale = 2.0 * std::sqrt(kernels::batch_table().inner_product(prepared.data(), prepared.data(),
                                                                 prepared.size()));
  }
  return static_cast<float>(2.5 * rounding * scale);
}

Winners Som::best_of(std::span<const float> prepared, bool two, SomWorkspace& workspace) const {
  return decide(ascending_scores_of(prepared, workspace), prepared, two, workspace);
}

// Scores in single precision select candidates, scores in double precision decide among them.
Winners Som::decide(std::span<const float> scores, std::span<const float> prepared, bool two,
                    SomWorkspace& workspace) const {
  const std::size_t blocks = weights().blocks();
  const auto& kernels = kernels::batch_table();
  float last = kernels.least(scores.data(), blocks);
  if (two) last = second_least(scores, last);
  workspace.candidates_.resize(scores.size());
  const std::size_t count = kernels.places_up_to(
      scores.data(), blocks, last + score_margin(last, prepared), workspace.candidates_.data());
  const auto candidates = std::span(workspace.candidates_).first(count);
  if (count == 1) return {candidates[0], candidates[0]};
  BestTwo best;
  for (const std::uint32_t neuron : candidates) {
    if (neuron < neurons()) best.meet(exact_score(prepared, neuron, workspace), neuron);
  }
  return best.winners();
}

double Som::exact_score(std::span<const float> prepared, std::size_t neuron,
                        SomWorkspace& workspace) const {
  workspace.row_.resize(elements_.count());
  weights().copy_row(neuron, workspace.row_);
  if (!parameters_.layers.empty()) return distance_between(parameters_, workspace.row_, prepared);
  return somato::exact_score(parameters_.similarity, workspace.row_.data(), prepared.data(),
                             prepared.size());
}

std::size_t Som::winner_among(std::span<const std::size_t> candidates, const SignalView& input,
                              SomWorkspace& workspace) const {
  const std::span<const float> prepared = prepare(input, workspace);
  return best_among(candidates, neurons(),
                    [&](std::size_t neuron) { return exact_score(prepared, neuron, workspace); });
}

// In the place of the scores.
void Som::find_similarities(const SignalView& input, SomWorkspace& workspace) const {
  const std::span<const float> prepared = prepare(input, workspace);
  const std::span<const float> all = scores_of(prepared, workspace);
  if (parameters_.layers.empty() && parameters_.similarity == Similarity::kDotProduct) return;
  if (follows_from_products(parameters_)) {
    similarities_of_squares(workspace.scores_, workspace.left_out_);
    return;
  }
  const Similarity similarity =
      parameters_.layers.empty() ? parameters_.similarity : Similarity::kManhattan;  // a distance
  const DistanceOfScore distance(similarity, prepared, workspace.left_out_);
  std::transform(all.begin(), all.end(), workspace.scores_.begin(), [&](float score) {
    return static_cast<float>(1.0 / (1.0 + distance(double{score})));
  });
}

void Som::similarities(const SignalView& input, SomWorkspace& workspace,
                       std::span<float> out) const {
  require(out.size() == neurons(), "similarities need space for one value per neuron");
  find_similarities(input, workspace);
  std::copy_n(workspace.scores_.begin(), out.size(), out.begin());
}

void Som::activity(const SignalView& input, SomWorkspace& workspace, std::span<float> out) const {
  require(out.size() == neurons(), "an activity needs space for one value per neuron");
  find_similarities(input, workspace);
  activity_of_similarities(parameters_, workspace.scores_, out.size());
  std::copy_n(workspace.scores_.begin(), out.size(), out.begin());
}

double Som::distance(const SignalView& input, std::size_t neuron, SomWorkspace& workspace) const {
  const std::span<const float> x = prepare(input, workspace);
  const LaneMatrix<float>& weights = this->weights();
  if (!follows_from_products(parameters_)) {
    workspace.row_.resize(x.size());
    weights.copy_row(neuron, workspace.row_);
    return distance_between(parameters_, workspace.row_, x, workspace.left_out_);
  }
  double sum = workspace.left_out_;
  for (std::size_t d = 0; d < x.size(); ++d) {
    const double difference = double{x[d]} - double{weights(neuron, d)};
    sum = std::fma(difference, difference, sum);
  }
  return std::sqrt(sum);
}

void normalize_length(std::span<float> values) {
  const double factor = factor_to_length_one(values);
  for (float& value : values) value = static_cast<float>(value * factor);
}

}  // namespace somato
