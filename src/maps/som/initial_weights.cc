#include "maps/som/initial_weights.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "maps/grid/feature_ranges.h"
#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/maps/som.h"

namespace somato {
namespace {

// The first `count` of the samples in random order, in a new order whenever they run out.
std::vector<std::size_t> drawn_samples(std::size_t count, std::size_t samples, std::uint64_t seed) {
  Random random(seed, Stream::kInitialWeights);
  std::vector<std::size_t> drawn;
  std::vector<std::size_t> left;
  while (drawn.size() < count) {
    if (left.empty()) {
      left.resize(samples);
      std::iota(left.begin(), left.end(), std::size_t{0});
    }
    const std::size_t pick = random.below(left.size());
    drawn.push_back(left[pick]);
    left[pick] = left.back();
    left.pop_back();
  }
  return drawn;
}

}  // namespace

std::vector<std::size_t> initial_samples(const SomParameters& parameters, std::size_t samples) {
  require(samples > 0, "initial weights need at least one sample");
  return drawn_samples(parameters.grid().size(), samples, parameters.seed);
}

Result<void> check_initial_weights(const SomParameters& parameters, const Samples& samples) {
  if (parameters.initial_weights != InitialWeights::kLinear) return {};
  std::vector<float> low;
  std::vector<float> high;
  widen_ranges(samples, low, high);
  return check_plane(samples.count(), low, high);
}

void write_on_plane(const PrincipalPlane& plane, const SomParameters& parameters,
                    std::size_t neuron, std::span<float> out) {
  const PlanePlace place = place_on_plane(parameters.grid(), neuron);
  for (std::size_t d = 0; d < out.size(); ++d) {
    out[d] = static_cast<float>(plane.mean[d] + place.first * plane.first[d] +
                                place.second * plane.second[d]);
  }
  if (parameters.similarity == Similarity::kDotProduct) normalize_length(out);
}

InitialWeightsSource::InitialWeightsSource(SomParameters parameters, const Samples& samples,
                                           std::size_t threads)
    : InitialWeightsSource(std::move(parameters), samples, StoredElements(samples.size()),
                           threads) {}

InitialWeightsSource::InitialWeightsSource(SomParameters parameters, const Samples& samples,
                                           StoredElements elements, std::size_t threads)
    : parameters_(std::move(parameters)), samples_(samples), elements_(std::move(elements)) {
  require(samples.size() == elements_.count(), "initial weights need the stored elements' samples");
  require(samples.count() > 0, "initial weights need at least one sample");
  if (parameters_.initial_weights == InitialWeights::kSamples) {
    sample_of_neuron_ = initial_samples(parameters_, samples.count());
  } else if (parameters_.initial_weights != InitialWeights::kUniform) {
    widen_ranges(samples, low_, high_);
  }
  if (parameters_.initial_weights == InitialWeights::kLinear) {
    plane_ = principal_plane(samples, low_, high_, threads);
  }
}

void InitialWeightsSource::write(std::size_t neuron, std::span<float> out) const {
  require(out.size() == samples_.size(), "initial weights need space for one value per feature");
  if (parameters_.initial_weights == InitialWeights::kLinear) {
    return write_on_plane(plane_, parameters_, neuron, out);
  }
  if (parameters_.initial_weights == InitialWeights::kSamples) {
    write_dense(samples_[sample_of_neuron_[neuron]], out);
  } else {
    write_uniform(static_cast<std::uint32_t>(neuron), out);
  }
  if (parameters_.initial_weights == InitialWeights::kRange) {
    for (std::size_t d = 0; d < out.size(); ++d) out[d] = low_[d] + (high_[d] - low_[d]) * out[d];
  }
  if (parameters_.similarity == Similarity::kDotProduct) normalize_length(out);
}

// The numbers belong to the places of the elements in the input.
void InitialWeightsSource::write_uniform(std::uint32_t neuron, std::span<float> out) const {
  if (elements_.all()) {
    uniform_row(parameters_.seed, Stream::kInitialWeights, neuron, out);
  } else {
    uniform_row(parameters_.seed, Stream::kInitialWeights, neuron, elements_.listed(), out);
  }
}

}  // namespace somato
