#include "maps/reading/known_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/core/lanes.h"
#include "maps/reading/similarity_scores.h"
#include "somato/maps/layers.h"

namespace somato {
namespace {

void append_known(std::span<const float> values, const std::vector<KnownRun>& runs,
                  std::vector<float>& known) {
  known.clear();
  for (const KnownRun& run : runs) {
    const auto some = values.subspan(run.first, run.count);
    known.insert(known.end(), some.begin(), some.end());
  }
}

double length_of_known(std::span<const float> input, const std::vector<KnownRun>& runs) {
  double sum = 0.0;
  for (const KnownRun& run : runs) {
    for (const float value : input.subspan(run.first, run.count)) {
      sum = std::fma(double{value}, double{value}, sum);
    }
  }
  return std::sqrt(sum);
}

// Distances of a layer for its scores.
void to_distances(Similarity similarity, double length, std::size_t rows, float* scores) {
  for (std::size_t row = 0; row < rows; ++row) {
    if (similarity == Similarity::kEuclidean) scores[row] = std::sqrt(scores[row]);
    if (similarity != Similarity::kCosine) continue;
    scores[row] =
        length > 0.0 ? static_cast<float>(std::max(0.0, 1.0 + double{scores[row]} / length)) : 1.0F;
  }
}

}  // namespace

std::vector<KnownRun> known_runs(std::span<const float> input) {
  std::vector<KnownRun> runs;
  for (std::size_t d = 0; d < input.size(); ++d) {
    if (std::isnan(input[d])) continue;
    const bool continues = !runs.empty() && runs.back().first + runs.back().count == d;
    if (!continues) runs.push_back({d, 0});
    ++runs.back().count;
  }
  return runs;
}

void KnownScores::write(kernels::Lanes<const float> weights, std::size_t rows, float* out) const {
  std::fill_n(out, weights.blocks * kFloatLanes, 0.0F);
  if (parameters_.layers.empty()) {
    write_similarity(parameters_.similarity, runs_, weights, rows, out);
    return;
  }
  for (const Layer& layer : parameters_.layers) {
    const std::vector<KnownRun> runs = runs_of(layer);
    if (!runs.empty()) add_layer(layer, runs, weights, rows, out);
  }
}

// `out` is 0 before.
void KnownScores::write_similarity(Similarity similarity, const std::vector<KnownRun>& runs,
                                   kernels::Lanes<const float> weights, std::size_t rows,
                                   float* out) const {
  AlignedVector<float> of_run(runs.size() > 1 ? weights.blocks * kFloatLanes : 0);
  for (const KnownRun& run : runs) {
    const kernels::Lanes<const float> columns{weights.values + run.first * kFloatLanes,
                                              weights.blocks, run.count, weights.stride};
    const float* const input = input_.data() + run.first;
    float* const to = runs.size() > 1 ? of_run.data() : out;
    SimilarityScores(similarity, columns, rows).write({&input, 1}, {&to, 1});
    for (std::size_t row = 0; runs.size() > 1 && row < rows; ++row) {
      out[row] =
          similarity == Similarity::kChebyshev ? std::max(out[row], to[row]) : out[row] + to[row];
    }
  }
}

void KnownScores::add_layer(const Layer& layer, const std::vector<KnownRun>& runs,
                            kernels::Lanes<const float> weights, std::size_t rows,
                            float* out) const {
  AlignedVector<float> scores(weights.blocks * kFloatLanes);
  write_similarity(layer.similarity, runs, weights, rows, scores.data());
  to_distances(layer.similarity, length_of_known(input_, runs), rows, scores.data());
  const auto factor = static_cast<float>(factor_of(layer));
  for (std::size_t row = 0; row < rows; ++row) out[row] += factor * scores[row];
}

std::vector<KnownRun> KnownScores::runs_of(const Layer& layer) const {
  std::vector<KnownRun> runs;
  for (const KnownRun& run : runs_) {
    const std::size_t first = std::max(run.first, layer.first);
    const std::size_t end = std::min(run.first + run.count, layer.first + layer.count);
    if (first < end) runs.push_back({first, end - first});
  }
  return runs;
}

// Rounding changes sums of positive terms, and sums of these, as in score_margin().
double KnownScores::margin(double least) const {
  if (!parameters_.layers.empty()) return layered_margin(parameters_, least, true);
  std::size_t known = 0;
  for (const KnownRun& run : runs_) known += run.count;
  const auto roundings = static_cast<double>(known + runs_.size() + 4);
  return 2.5 * roundings * 0x1p-24 * least;
}

std::size_t KnownScores::winner(const Som& som, std::span<const float> scores) const {
  std::vector<float> row(input_.size());
  const auto least = double{*std::min_element(scores.begin(), scores.end())};
  const double limit = least + margin(least);
  std::size_t best = 0;
  double least_exact = std::numeric_limits<double>::infinity();
  for (std::size_t neuron = 0; neuron < scores.size(); ++neuron) {
    if (double{scores[neuron]} > limit) continue;
    som.weights().copy_row(neuron, row);
    const double score = exact(row);
    if (score >= least_exact) continue;
    least_exact = score;
    best = neuron;
  }
  return best;
}

double KnownScores::exact(std::span<const float> weights) const {
  std::vector<float> of_input;
  std::vector<float> of_weights;
  if (parameters_.layers.empty()) {
    append_known(input_, runs_, of_input);
    append_known(weights, runs_, of_weights);
    return exact_score(parameters_.similarity, of_weights.data(), of_input.data(), of_input.size());
  }
  double sum = 0.0;
  for (const Layer& layer : parameters_.layers) {
    const std::vector<KnownRun> runs = runs_of(layer);
    if (runs.empty()) continue;
    append_known(input_, runs, of_input);
    append_known(weights, runs, of_weights);
    sum += factor_of(layer) * distance_between(layer.similarity, of_weights, of_input);
  }
  return sum;
}

// The sum of the layers' errors: relative ones of distances that are sums of positive terms, of the
// root and the factor, of the additions of layers; absolute ones of cosine distances (see
// score_margin()), and of squares that leave the range of single precision.
double layered_margin(const SomParameters& parameters, double least, bool incomplete) {
  constexpr double kLeastRoot = 1e-18;
  double most = 0.0;
  double absolute = 0.0;
  for (const Layer& layer : parameters.layers) {
    const auto columns = static_cast<double>(layer.count);
    constexpr auto kChunk = static_cast<double>(kernels::kChunk);
    const double roundings =
        incomplete ? 2.0 * columns + 4.0 : std::min(columns, kChunk) + columns / kChunk + 4.0;
    most = std::max(most, roundings);
    const double error =
        layer.similarity == Similarity::kCosine ? (2.0 * roundings + 8.0) * 0x1p-24 : kLeastRoot;
    absolute += factor_of(layer) * error;
  }
  const double relative = (most + static_cast<double>(parameters.layers.size()) + 12.0) * 0x1p-24;
  return 2.5 * (relative * least + absolute);
}

double distance_between(const SomParameters& parameters, std::span<const float> a,
                        std::span<const float> b, double left_out) {
  if (parameters.layers.empty()) return distance_between(parameters.similarity, a, b, left_out);
  const std::vector<KnownRun> all{{0, b.size()}};
  return KnownScores(parameters, b, all).exact(a);
}

}  // namespace somato
