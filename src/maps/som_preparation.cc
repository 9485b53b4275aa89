#include "maps/som_preparation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "somato/core/memory.h"
#include "somato/maps/initial_weights.h"
#include "somato/maps/som.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

StoredElements worth_storing(const SomParameters& parameters, const Samples& samples) {
  return InitialWeightsSource::are_zero_without_samples(parameters)
             ? StoredElements::used_by(samples)
             : StoredElements(samples.size());
}

}  // namespace

// Refused before it is asked for: a system that promises more memory than it has would end the
// program later, without a word.
Result<void> check_memory(const SomParameters& parameters, std::size_t elements) {
  const double gibibytes = static_cast<double>(parameters.grid().size()) *
                           static_cast<double>(elements) * sizeof(float) / (1 << 30);
  const double there = static_cast<double>(memory_of_machine()) / (1 << 30);
  if (gibibytes <= there) return {};
  return fail(ErrorKind::kSystem,
              fmt::format("{} x {} neurons of {} features need {:.1f} GiB of memory, and this "
                          "machine has {:.1f}",
                          parameters.rows, parameters.columns, elements, gibibytes, there),
              {}, "choose fewer rows or columns");
}

Result<void> check_samples(const Samples& samples) {
  return check_samples(samples.count(), samples.size());
}

Result<void> check_samples(std::size_t count, std::size_t size) {
  if (count > 0 && size > 0) return {};
  return fail(ErrorKind::kData, "there are no samples to train on", {},
              "give at least one sample of at least one element");
}

Result<void> check_range(const Samples& prepared) {
  double longest = 0.0;
  for (std::size_t i = 0; i < prepared.count(); ++i) {
    longest = std::max(longest, inner_product(prepared[i], prepared[i]));
  }
  return check_range(longest);
}

// Distances are summed in single precision: beyond its range every winner would be the first.
Result<void> check_range(double longest_squared) {
  constexpr double kLongest = 1e18;
  constexpr double kShortest = 1e-15;
  const double longest = std::sqrt(longest_squared);
  if (longest <= kLongest && (longest >= kShortest || longest == 0.0)) return {};
  return fail(ErrorKind::kData,
              longest > kLongest ? "the samples are too large to be told apart in single precision"
                                 : "the samples are too small to be told apart in single precision",
              {}, "scale or standardize them; lengths from 1e-15 to 1e18 can be used");
}

Result<PreparedTraining> prepare_training(const SomParameters& parameters, const Samples& samples,
                                          Samples& storage) {
  if (auto usable = check_samples(samples); !usable) return fail(std::move(usable.error()));
  Result<SomParameters> resolved = resolve(parameters, samples.count(), samples.size());
  if (!resolved) return fail(std::move(resolved.error()));
  StoredElements elements = worth_storing(*resolved, samples);
  if (auto fits = check_memory(*resolved, elements.count()); !fits) {
    return fail(std::move(fits.error()));
  }
  const Samples* prepared = &prepared_samples(*resolved, samples, storage);
  if (auto fit = check_range(*prepared); !fit) return fail(std::move(fit.error()));
  if (prepared->is_sparse()) {
    storage = elements.gather(*prepared);
    prepared = &storage;
  }
  return PreparedTraining{std::move(*resolved), prepared, std::move(elements)};
}

const Samples& prepared_samples(const SomParameters& parameters, const Samples& samples,
                                Samples& storage) {
  // NOLINTNEXTLINE(bugprone-return-const-ref-from-parameter): the caller keeps both alive
  if (!parameters.normalize_input.value_or(false)) return samples;
  std::vector<Signal> normalized;
  normalized.reserve(samples.count());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const SignalView sample = samples[i];
    std::vector<float> values(sample.values.begin(), sample.values.end());
    normalize_length(values);
    normalized.push_back(sample.sparse
                             ? Signal::sparse({sample.size},
                                              {sample.indices.begin(), sample.indices.end()},
                                              std::move(values))
                             : Signal::dense(std::move(values)));
  }
  storage = Samples::from_signals(normalized);
  return storage;
}

}  // namespace somato
