#include "somato/maps/som_training.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "maps/inner_product_training.h"
#include "maps/map_rows.h"
#include "maps/som_preparation.h"
#include "maps/source_preparation.h"
#include "maps/stop.h"
#include "somato/core/check.h"
#include "somato/maps/batch_training.h"
#include "somato/maps/initial_weights.h"
#include "somato/maps/som_learner.h"

namespace somato {
namespace {

constexpr std::uint64_t kOnlineIterationsBetweenReports = 64;
constexpr std::uint64_t kLeastIterationsBetweenReports = 16;  // learned in one pass
constexpr std::uint64_t kWeightsBetweenReports = std::uint64_t{1} << 28;

// Fewer on a large map: whoever asks it to stop does not want to wait.
std::uint64_t iterations_between_reports(const Som& som) {
  const std::uint64_t weights = std::uint64_t{som.neurons()} * som.elements().count();
  return std::clamp<std::uint64_t>(kWeightsBetweenReports / weights, kLeastIterationsBetweenReports,
                                   kOnlineIterationsBetweenReports);
}

// Of the stored elements alone: everything else is 0 and stays 0.
Som initial_som(const PreparedTraining& prepared) {
  const InitialWeightsSource source(prepared.parameters, *prepared.samples, prepared.elements);
  LaneMatrix<float> weights(prepared.parameters.grid().size(), prepared.samples->size());
  std::vector<float> row(prepared.samples->size());
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    source.write(neuron, row);
    weights.set_row(neuron, row);
  }
  return Som(prepared.parameters, std::move(weights));
}

// A map of stored elements as one of whole inputs.
Som of_whole_inputs(Som som, const StoredElements& elements) {
  return Som(som.parameters(), std::move(som.weights()), elements);
}

Result<void> train_online(Som& som, const Samples& prepared, const TrainingOptions& options) {
  const SomParameters& p = som.parameters();
  DrawSequence draws(p.draws, prepared.count(), p.seed);
  SomLearner learner(som, options.threads);
  const std::uint64_t interval = iterations_between_reports(som);
  const Stop stop(options.progress, *p.iterations, interval);
  std::vector<SignalView> inputs;
  std::vector<LearningStep> steps;
  for (std::uint64_t t = 0; t < *p.iterations;) {
    const std::uint64_t end = std::min(t + interval, *p.iterations);
    inputs.clear();
    steps.clear();
    for (; t < end; ++t) {
      inputs.push_back(prepared[draws.next()]);
      steps.push_back({p.learning_rate().at(t), p.radius().at(t)});
    }
    learner.learn(inputs, steps);
    if (stop.after(t)) return Stop::error();
  }
  return {};
}

// An epoch on samples in `parts` parts; stops after any of them.
Result<void> train_epoch(Som& som, SampleSource& prepared, std::uint64_t epoch, std::uint64_t parts,
                         std::size_t threads, const Stop& stop) {
  BatchEpoch training(som, threads);
  std::uint64_t done = epoch * parts;
  auto gone_through = for_each_part(prepared, [&](const Samples& part) -> Result<void> {
    if (som.elements().all()) {
      training.add_seen(part);
    } else {
      training.add(part);
    }
    ++done;
    if (done % parts != 0 && stop.after(done)) return Stop::error();
    return {};
  });
  if (!gone_through) return gone_through;
  training.finish(som.parameters().radius().at(epoch));
  if (stop.after((epoch + 1) * parts)) return Stop::error();
  return {};
}

Result<void> train_batch(Som& som, SampleSource& prepared, std::uint64_t parts,
                         const TrainingOptions& options) {
  const std::uint64_t epochs = som.parameters().epochs;
  const Stop stop(options.progress, epochs * parts, 1);
  for (std::uint64_t epoch = 0; epoch < epochs; ++epoch) {
    auto trained = train_epoch(som, prepared, epoch, parts, options.threads, stop);
    if (!trained) return trained;
  }
  return {};
}

Result<void> train_batch(Som& som, const Samples& prepared, const TrainingOptions& options) {
  SamplesInMemory source(prepared);
  return train_batch(som, source, 1, options);
}

// The samples as the map sees them.
Result<Som> train_on_prepared(const SomParameters& parameters, SampleSource& prepared,
                              const TrainingOptions& options) {
  const Result<SampleSurvey> survey = survey_samples(prepared);
  if (!survey) return fail(survey.error());
  if (auto usable = check_samples(survey->count, prepared.size()); !usable) {
    return fail(std::move(usable.error()));
  }
  if (auto fit = check_longest(survey->longest); !fit) return fail(std::move(fit.error()));
  const auto resolved = resolve(parameters, survey->count, prepared.size());
  if (!resolved) return fail(resolved.error());
  auto som = initial_som(*resolved, prepared, *survey);
  if (!som) return som;
  auto trained = train_batch(*som, prepared, survey->parts, options);
  if (!trained) return fail(std::move(trained.error()));
  return som;
}

Result<void> train_in_place(Som& som, const Samples& prepared, const TrainingOptions& options) {
  return som.parameters().training == Training::kBatch ? train_batch(som, prepared, options)
                                                       : train_online(som, prepared, options);
}

}  // namespace

Result<Som> untrained_som(const SomParameters& parameters, const Samples& samples) {
  Samples storage;
  auto ready = prepare_training(parameters, samples, storage);
  if (!ready) return fail(std::move(ready.error()));
  return of_whole_inputs(initial_som(*ready), ready->elements);
}

Result<Som> train_som(const SomParameters& parameters, const Samples& samples,
                      const TrainingOptions& options) {
  auto by_products = train_by_inner_products(parameters, samples, options);
  if (!by_products) return fail(std::move(by_products.error()));
  if (*by_products) return std::move(**by_products);
  Samples storage;
  auto ready = prepare_training(parameters, samples, storage);
  if (!ready) return fail(std::move(ready.error()));
  Som som = initial_som(*ready);
  if (auto trained = train_in_place(som, *ready->samples, options); !trained) {
    return fail(std::move(trained.error()));
  }
  return of_whole_inputs(std::move(som), ready->elements);
}

Result<Som> train_som(const SomParameters& parameters, SampleSource& samples,
                      const TrainingOptions& options) {
  const auto resolved = resolve(parameters, 1, samples.size());
  if (!resolved) return fail(resolved.error());
  if (resolved->training != Training::kBatch) {
    return fail(ErrorKind::kUsage, "online training needs all samples in memory", {},
                "set 'training' to batch");
  }
  if (auto fits = check_memory(*resolved, samples.size()); !fits) {
    return fail(std::move(fits.error()));
  }
  if (!*resolved->normalize_input) return train_on_prepared(parameters, samples, options);
  ChangedSamples normalized(samples, [&](const Samples& part) {
    Samples storage;
    prepared_samples(*resolved, part, storage);
    return storage;
  });
  return train_on_prepared(parameters, normalized, options);
}

Result<void> continue_som(Som& som, const Samples& samples, const TrainingOptions& options) {
  if (auto usable = check_samples(samples); !usable) return usable;
  require(samples.size() == som.input_size(),
          "the samples' size differs from the map's input size");
  Som trained = som;
  if (!has_weights_for(som, samples)) {
    auto fits = check_memory(som.parameters(), som.input_size());
    if (!fits) return fits;
    trained.store_all();
  }
  Samples storage;
  const Samples& prepared = prepared_samples(som.parameters(), samples, storage);
  if (auto fit = check_range(prepared); !fit) return fit;
  auto result = train_in_place(trained, prepared, options);
  if (result) som = std::move(trained);
  return result;
}

DrawSequence::DrawSequence(Draws draws, std::size_t samples, std::uint64_t seed)
    : draws_(draws), samples_(samples), random_(seed, Stream::kDraws) {}

std::size_t DrawSequence::next() {
  if (draws_ == Draws::kWithReplacement) return random_.below(samples_);
  if (left_.empty()) {
    left_.resize(samples_);
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }
  std::swap(left_[random_.below(left_.size())], left_.back());
  const std::size_t drawn = left_.back();
  left_.pop_back();
  return drawn;
}

}  // namespace somato
