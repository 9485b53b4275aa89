#include "somato/maps/som_training.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "maps/inner_product_training.h"
#include "maps/map_rows.h"
#include "maps/som_preparation.h"
#include "maps/stop.h"
#include "somato/core/check.h"
#include "somato/maps/batch_training.h"
#include "somato/maps/initial_weights.h"
#include "somato/maps/som_learner.h"

namespace somato {
namespace {

constexpr std::uint64_t kIterationsBetweenReports = 64;
constexpr std::uint64_t kWeightsBetweenReports = std::uint64_t{1} << 26;

// Fewer on a large map: whoever asks it to stop does not want to wait.
std::uint64_t iterations_between_reports(const Som& som) {
  const std::uint64_t weights = std::uint64_t{som.neurons()} * som.elements().count();
  return std::clamp<std::uint64_t>(kWeightsBetweenReports / weights, 1, kIterationsBetweenReports);
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

Result<void> train_online(Som& som, const Samples& prepared, const Progress& progress) {
  const SomParameters& p = som.parameters();
  DrawSequence draws(p.draws, prepared.count(), p.seed);
  SomLearner learner(som);
  const Stop stop(progress, *p.iterations, iterations_between_reports(som));
  for (std::uint64_t t = 0; t < *p.iterations; ++t) {
    learner.learn(prepared[draws.next()], p.learning_rate().at(t), p.radius().at(t));
    if (stop.after(t + 1)) return Stop::error();
  }
  return {};
}

Result<void> train_batch(Som& som, const Samples& prepared, const TrainingOptions& options) {
  const SomParameters& p = som.parameters();
  const Stop stop(options.progress, p.epochs, 1);
  for (std::uint64_t epoch = 0; epoch < p.epochs; ++epoch) {
    batch_epoch(som, prepared, p.radius().at(epoch), options.threads);
    if (stop.after(epoch + 1)) return Stop::error();
  }
  return {};
}

Result<void> train_in_place(Som& som, const Samples& prepared, const TrainingOptions& options) {
  return som.parameters().training == Training::kBatch
             ? train_batch(som, prepared, options)
             : train_online(som, prepared, options.progress);
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
