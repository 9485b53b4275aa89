#include "maps/reading/similarity_scores.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/core/lanes.h"
#include "base/kernels/batch_kernels.h"
#include "base/kernels/distance_kernels.h"

namespace somato {
namespace {

// Squared lengths outside these ranges, and products of vectors of such lengths, may leave the
// range of single precision.
constexpr float kLeastSquaredWeights = 1e-30F;
constexpr float kMostSquaredWeights = 1e36F;
constexpr double kLeastSquaredInput = 1e-20;
constexpr double kMostSquaredInput = 1e20;

using Compare = void (*)(kernels::Lanes<const float>, const float* const*, std::size_t,
                         float* const*);

Compare kernel_of(Similarity similarity) {
  const kernels::DistanceTable& kernels = kernels::distance_table();
  switch (similarity) {
    case Similarity::kEuclidean:
      return kernels.squares;
    case Similarity::kManhattan:
      return kernels.absolute;
    case Similarity::kChebyshev:
      return kernels.greatest;
    case Similarity::kDotProduct:
    case Similarity::kCosine:
      break;
  }
  return kernels.products;
}

double squared_length(const float* values, std::size_t count) {
  return kernels::batch_table().inner_product(values, values, count);
}

double cosine_score(const float* weights, const float* input, std::size_t count) {
  const double squared = squared_length(weights, count);
  if (squared == 0.0) return 0.0;
  return -kernels::batch_table().inner_product(weights, input, count) / std::sqrt(squared);
}

}  // namespace

SimilarityScores::SimilarityScores(Similarity similarity, kernels::Lanes<const float> weights,
                                   std::size_t rows)
    : similarity_(similarity), weights_(weights), rows_(rows) {
  if (similarity == Similarity::kCosine) find_lengths();
}

void SimilarityScores::find_lengths() {
  inverse_lengths_.resize(weights_.blocks * kFloatLanes);
  kernels::table<float>().squared_norms(weights_, inverse_lengths_.data());
  for (float& value : inverse_lengths_) {
    const bool in_range = value >= kLeastSquaredWeights && value <= kMostSquaredWeights;
    value = in_range ? 1.0F / std::sqrt(value) : 0.0F;
  }
}

void SimilarityScores::write(std::span<const float* const> inputs,
                             std::span<float* const> out) const {
  write(inputs, out, 0, weights_.blocks);
}

void SimilarityScores::write(std::span<const float* const> inputs, std::span<float* const> out,
                             std::size_t first_block, std::size_t blocks) const {
  const Compare compare = kernel_of(similarity_);
  const kernels::Lanes<const float> some{
      weights_.values + first_block * weights_.stride * kFloatLanes, blocks, weights_.columns,
      weights_.stride};
  const std::size_t begin = first_block * kFloatLanes;
  const std::size_t end = std::min(rows_, begin + blocks * kFloatLanes);
  for (std::size_t i = 0; i < inputs.size(); i += kernels::kInputsTogether) {
    const std::size_t count = std::min(kernels::kInputsTogether, inputs.size() - i);
    float* places[kernels::kInputsTogether] = {};
    for (std::size_t j = 0; j < count; ++j) places[j] = out[i + j] + begin;
    compare(some, inputs.data() + i, count, places);
  }
  if (similarity_ != Similarity::kCosine) return;
  for (std::size_t i = 0; i < inputs.size(); ++i) divide_by_lengths(inputs[i], begin, end, out[i]);
}

void SimilarityScores::divide_by_lengths(const float* input, std::size_t begin, std::size_t end,
                                         float* scores) const {
  const double squared = squared_length(input, weights_.columns);
  const bool in_range = squared >= kLeastSquaredInput && squared <= kMostSquaredInput;
  for (std::size_t row = begin; row < end; ++row) {
    const float factor = inverse_lengths_[row];
    scores[row] = in_range && factor > 0.0F ? -(scores[row] * factor) : exact_cosine(input, row);
  }
}

float SimilarityScores::exact_cosine(const float* input, std::size_t row) const {
  std::vector<float> weights(weights_.columns);
  const float* from =
      weights_.values + row / kFloatLanes * weights_.stride * kFloatLanes + row % kFloatLanes;
  for (std::size_t d = 0; d < weights.size(); ++d) weights[d] = from[d * kFloatLanes];
  return static_cast<float>(cosine_score(weights.data(), input, weights.size()));
}

double exact_score(Similarity similarity, const float* weights, const float* input,
                   std::size_t count) {
  const kernels::BatchTable& kernels = kernels::batch_table();
  switch (similarity) {
    case Similarity::kEuclidean:
      return kernels.squared_distance(weights, input, count);
    case Similarity::kDotProduct:
      return -kernels.inner_product(weights, input, count);
    case Similarity::kManhattan:
      return kernels.absolute_distance(weights, input, count);
    case Similarity::kChebyshev:
      return kernels.greatest_difference(weights, input, count);
    case Similarity::kCosine:
      break;
  }
  return cosine_score(weights, input, count);
}

// With r roundings along a sum, that of positive terms is off by r 2^-24 of itself at most. A
// cosine score is off by 1.5 r + 4 times 2^-24 |x|: r for x . w, half of r for |w|, and the last
// operations. Twice that, and room for products of small errors.
double score_margin(Similarity similarity, double least, std::span<const float> input) {
  const auto columns = static_cast<double>(input.size());
  constexpr auto kChunk = static_cast<double>(kernels::kChunk);
  const double roundings = std::min(columns, kChunk) + columns / kChunk + 4.0;
  if (similarity != Similarity::kCosine) return 2.5 * roundings * 0x1p-24 * least;
  return 4.0 * roundings * 0x1p-24 * std::sqrt(squared_length(input.data(), input.size()));
}

DistanceOfScore::DistanceOfScore(Similarity similarity, std::span<const float> input,
                                 double left_out)
    : similarity_(similarity), left_out_(left_out) {
  if (similarity != Similarity::kCosine) return;
  length_ = std::sqrt(squared_length(input.data(), input.size()) + left_out);
}

double DistanceOfScore::operator()(double score) const {
  if (similarity_ == Similarity::kManhattan) return score + left_out_;
  if (similarity_ != Similarity::kCosine) return score;
  return length_ == 0.0 ? 1.0 : std::clamp(1.0 + score / length_, 0.0, 2.0);
}

namespace {

double product_in_order(std::span<const float> a, std::span<const float> b) {
  double sum = 0.0;
  for (std::size_t d = 0; d < a.size(); ++d) sum = std::fma(double{a[d]}, double{b[d]}, sum);
  return sum;
}

double cosine_distance(std::span<const float> a, std::span<const float> b, double left_out) {
  const double squares = product_in_order(a, a) * (product_in_order(b, b) + left_out);
  if (squares == 0.0) return 1.0;
  return std::clamp(1.0 - product_in_order(a, b) / std::sqrt(squares), 0.0, 2.0);
}

}  // namespace

// Element after element, so that zeros among them change nothing.
double distance_between(Similarity similarity, std::span<const float> a, std::span<const float> b,
                        double left_out) {
  if (similarity == Similarity::kCosine) return cosine_distance(a, b, left_out);
  double sum = left_out;
  double most = 0.0;
  for (std::size_t d = 0; d < a.size(); ++d) {
    const double apart = std::fabs(double{a[d]} - double{b[d]});
    most = std::max(most, apart);
    sum = similarity == Similarity::kManhattan ? sum + apart : std::fma(apart, apart, sum);
  }
  if (similarity == Similarity::kChebyshev) return most;
  return similarity == Similarity::kManhattan ? sum : std::sqrt(sum);
}

}  // namespace somato
