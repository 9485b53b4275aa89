#include "studies/fold_run.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "somato/codes/standardization.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/batch_training.h"
#include "somato/maps/som_training.h"
#include "somato/maps/stored_elements.h"
#include "somato/studies/nearest_neighbour.h"
#include "studies/exploration_samples.h"

namespace somato {
namespace {

// Where each of `wanted` stands in `all`; both ascend.
std::vector<std::size_t> places_of(const std::vector<std::size_t>& wanted,
                                   const std::vector<std::size_t>& all) {
  std::vector<std::size_t> places;
  places.reserve(wanted.size());
  for (const std::size_t one : wanted) {
    const auto place = std::lower_bound(all.begin(), all.end(), one) - all.begin();
    places.push_back(static_cast<std::size_t>(place));
  }
  return places;
}

// Numbers of samples among those learned or tested, as numbers of explorations.
std::vector<std::size_t> neighbours_among(const Samples& samples,
                                          const std::vector<std::size_t>& training,
                                          const std::vector<std::size_t>& test,
                                          const std::vector<std::size_t>& explorations) {
  std::vector<std::size_t> nearest;
  nearest.reserve(test.size());
  for (const std::size_t sample : test) {
    nearest.push_back(explorations[nearest_neighbour(samples, training, sample)]);
  }
  return nearest;
}

}  // namespace

Result<TrainedFold> train_fold(const StudyDescription& description, const Question& question,
                               const Fold& fold, std::uint64_t seed, const Progress& progress) {
  auto system = question.system(description);
  if (!system) return fail(std::move(system.error()));
  Activations activations = question.fixed;
  auto trained =
      train_system(*system, question.recording, fold.training, {seed, 1, progress}, activations);
  if (!trained) return fail(std::move(trained.error()));
  std::vector<std::size_t> samples;
  std::set_union(fold.training.begin(), fold.training.end(), fold.test.begin(), fold.test.end(),
                 std::back_inserter(samples));
  const std::size_t input = system->modules()[question.map].inputs.front();
  auto seen =
      evaluate(*system, question.recording, samples, {input, question.vectors}, 1, activations);
  if (!seen) return fail(std::move(seen.error()));
  Samples inputs = single_values(activations, input, samples);
  Samples vectors = single_values(activations, question.vectors, samples);
  return TrainedFold{std::move(*system), std::move(samples), std::move(inputs), std::move(vectors)};
}

Neighbours nearest_neighbours(const TrainedFold& trained, const Fold& fold) {
  const std::vector<std::size_t> training = places_of(fold.training, trained.samples);
  const std::vector<std::size_t> test = places_of(fold.test, trained.samples);
  Neighbours nearest;
  nearest.raw = neighbours_among(trained.vectors, training, test, trained.samples);
  nearest.standardized = nearest.raw;
  if (training.size() < 2) return nearest;
  // A column that is 0 in all training samples is 0 once standardized.
  const Samples narrow =
      StoredElements::used_by(trained.vectors.subset(training)).gather(trained.vectors);
  const auto standardization =
      Standardization::fit(narrow.subset(training), {ConstantColumns::kZero});
  if (!standardization) return nearest;
  nearest.standardized =
      neighbours_among(standardization->apply(narrow), training, test, trained.samples);
  return nearest;
}

FoldOutcome test_fold(const TrainedFold& trained, const Question& question, const Fold& fold,
                      Neighbours nearest) {
  const Som& som = *som_of(trained.system, question.map);
  const std::vector<std::size_t> training = places_of(fold.training, trained.samples);
  const std::vector<std::size_t> test = places_of(fold.test, trained.samples);
  const SomQuality quality = measure_quality(som, trained.inputs.subset(test));
  const auto count = static_cast<double>(test.size());

  FoldOutcome outcome;
  outcome.training_winners = winners_of(som, trained.inputs.subset(training), 1);
  outcome.winners = quality.winners;
  outcome.nearest = std::move(nearest);
  outcome.summed_distance = quality.quantization_error * count;
  outcome.torn = quality.topographic_error * count;
  const std::set<std::size_t> won(outcome.training_winners.begin(), outcome.training_winners.end());
  const std::vector<std::size_t> named(won.begin(), won.end());
  outcome.named_by.reserve(test.size());
  SomWorkspace workspace;
  for (const std::size_t sample : test) {
    outcome.named_by.push_back(som.winner_among(named, trained.inputs[sample], workspace));
  }
  return outcome;
}

}  // namespace somato
