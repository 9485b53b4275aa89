#include "maps/som/som_preparation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/core/memory.h"
#include "maps/som/initial_weights.h"
#include "maps/som/relevances.h"
#include "maps/som/sample_range.h"
#include "somato/core/check.h"
#include "somato/maps/layers.h"
#include "somato/maps/som.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

StoredElements worth_storing(const SomParameters& parameters, const Samples& samples) {
  // Layers count all elements.
  return InitialWeightsSource::are_zero_without_samples(parameters) && parameters.layers.empty()
             ? StoredElements::used_by(samples)
             : StoredElements(samples.size());
}

Samples prepared_dense(const Samples& samples, bool normalize, std::span<const float> scales) {
  Matrix<float> rows(samples.count(), samples.size());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    write_dense(samples[i], rows.row(i));
    if (normalize) normalize_length(rows.row(i));
    scale_elements(scales, rows.row(i));
  }
  return Samples(std::move(rows));
}

std::vector<float> prepared_values(const SignalView& sample, bool normalize,
                                   std::span<const float> scales) {
  std::vector<float> values(sample.values.begin(), sample.values.end());
  if (normalize) normalize_length(values);
  for (std::size_t i = 0; i < values.size() && !scales.empty(); ++i) {
    values[i] *= scales[sample.indices[i]];
  }
  return values;
}

}  // namespace

// Batch training adds the sums of samples a neuron and their means over the neighbourhood, in
// double precision, and rearranges the weights for the search.
double training_memory(const SomParameters& parameters, std::size_t elements) {
  const bool batch = parameters.training == Training::kBatch;
  const double of_weight = batch ? 2 * sizeof(float) + 2 * sizeof(double) : sizeof(float);
  return static_cast<double>(parameters.grid().size()) * static_cast<double>(elements) * of_weight;
}

// Checked before allocation: on a system that overcommits memory, the program would otherwise be
// killed later without a message.
Result<void> check_memory(const SomParameters& parameters, std::size_t elements) {
  const double needed = training_memory(parameters, elements);
  const std::size_t limit = memory_limit();
  if (needed <= static_cast<double>(limit)) return {};
  return fail(
      ErrorKind::kSystem,
      fmt::format("{} x {} neurons of {} features need {} of memory, and {} {}", *parameters.rows,
                  *parameters.columns, elements, memory_text(needed),
                  limit < memory_of_machine() ? "limits leave this process" : "this machine has",
                  memory_text(static_cast<double>(limit))),
      {}, "choose fewer rows or columns");
}

Result<void> check_samples(const Samples& samples) {
  return check_samples(samples.count(), samples.size());
}

Result<void> check_samples(std::size_t count, std::size_t size) {
  if (count > 0 && size > 0) return {};
  return fail(ErrorKind::kData, "no samples to train on", {},
              "provide at least one sample with at least one element");
}

double longest_of(const Samples& prepared) {
  double longest = 0.0;
  for (std::size_t i = 0; i < prepared.count(); ++i) {
    longest = std::max(longest, inner_product(prepared[i], prepared[i]));
  }
  return std::sqrt(longest);
}

// Distances are summed in single precision: beyond its range every winner would be the first.
Result<void> check_longest(double longest) {
  constexpr double kShortest = 1e-15;
  if (longest <= kLongestSample && (longest >= kShortest || longest == 0.0)) return {};
  return fail(ErrorKind::kData,
              longest > kLongestSample
                  ? "the samples are too large to be distinguished in single precision"
                  : "the samples are too small to be distinguished in single precision",
              {}, "scale or standardize them; lengths from 1e-15 to 1e18 can be used");
}

Result<void> check_range(const Samples& prepared) {
  return check_longest(longest_of(prepared));
}

bool may_diverge(const SomParameters& parameters) {
  return parameters.neighbourhood == NeighbourhoodShape::kMexicanHat &&
         parameters.similarity != Similarity::kDotProduct;
}

Result<void> check_bounded(const Som& som) {
  const LaneMatrix<float>& weights = som.weights();
  const std::size_t count = weights.padded_rows() * weights.columns();
  const bool bounded = std::all_of(weights.data(), weights.data() + count, [](float weight) {
    return std::fabs(weight) <= kLongestSample;
  });
  if (bounded) return {};
  return fail(
      ErrorKind::kData,
      "the weights grow without limit, because neurons beyond the radius are pushed away "
      "from samples more than others are drawn to them",
      "neighbourhood = \"mexican_hat\"",
      "use similarity = \"dot_product\", whose weights have length 1, a lower learning rate, "
      "fewer iterations, or another neighbourhood");
}

Result<PreparedTraining> prepare_training(const SomParameters& parameters, const Samples& samples,
                                          Samples& storage) {
  SOMATO_TRY_VOID(check_samples(samples));
  SOMATO_TRY(SomParameters resolved, resolve(parameters, samples.count(), samples.size()));
  SOMATO_TRY_VOID(check_layers(resolved, samples.size()));
  resolved = with_scales(std::move(resolved), samples);
  SOMATO_TRY_VOID(check_scales(resolved));
  StoredElements elements = worth_storing(resolved, samples);
  SOMATO_TRY_VOID(check_memory(resolved, elements.count()));
  const Samples* prepared = &prepared_samples(resolved, samples, storage);
  SOMATO_TRY_VOID(check_range(*prepared));
  SOMATO_TRY_VOID(check_initial_weights(resolved, *prepared));
  if (prepared->is_sparse()) {
    storage = elements.gather(*prepared);
    prepared = &storage;
  }
  return PreparedTraining{std::move(resolved), prepared, std::move(elements)};
}

const Samples& prepared_samples(const SomParameters& parameters, const Samples& samples,
                                Samples& storage) {
  const bool normalize = parameters.normalize_input.value_or(false);
  // NOLINTNEXTLINE(bugprone-return-const-ref-from-parameter): the caller keeps both alive
  if (!normalize && parameters.relevances.empty()) return samples;
  const std::vector<float> scales = scales_of_relevances(parameters);
  require(scales.empty() || scales.size() == samples.size(),
          "samples have as many elements as the map's relevances");
  if (!samples.is_sparse()) {
    storage = prepared_dense(samples, normalize, scales);
    return storage;
  }
  std::vector<Signal> prepared;
  prepared.reserve(samples.count());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const SignalView sample = samples[i];
    prepared.push_back(Signal::sparse({sample.size}, {sample.indices.begin(), sample.indices.end()},
                                      prepared_values(sample, normalize, scales)));
  }
  storage = Samples::from_signals(prepared);
  return storage;
}

}  // namespace somato
