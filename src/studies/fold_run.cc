#include "studies/fold_run.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "somato/codes/standardization.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "somato/maps/areas.h"
#include "somato/maps/labels.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"
#include "somato/maps/stored_elements.h"
#include "somato/studies/nearest_neighbour.h"
#include "studies/exploration_samples.h"

namespace somato {
namespace {

std::vector<std::size_t> at(const std::vector<std::size_t>& values,
                            const std::vector<std::size_t>& places) {
  std::vector<std::size_t> chosen;
  chosen.reserve(places.size());
  for (const std::size_t place : places) chosen.push_back(values[place]);
  return chosen;
}

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

// A fold's samples as the areas and baselines see them: numbered among those learned or tested.
struct Tested {
  std::vector<std::size_t> training;
  std::vector<std::size_t> test;
  std::vector<std::size_t> classes;
};

void measure_areas(const Som& som, const std::vector<std::size_t>& winners,
                   const std::vector<std::size_t>& samples, const Tested& tested,
                   const std::vector<std::vector<std::size_t>>& wrong_groupings,
                   FoldOutcome& outcome) {
  outcome.apart = individuals_apart(winners, tested.classes);
  const WinnerAreas areas(som.grid(), winners);
  outcome.connected = areas.connected(tested.classes);
  for (const std::vector<std::size_t>& wrong : wrong_groupings) {
    outcome.connected_wrong += areas.connected(at(wrong, samples)) ? 1.0 : 0.0;
  }
  if (wrong_groupings.empty()) return;
  outcome.connected_wrong /= static_cast<double>(wrong_groupings.size());
}

void measure_baseline(const Samples& vectors, const Tested& tested, FoldOutcome& outcome) {
  const auto neighbours = [&](const Samples& samples) {
    std::vector<std::size_t> classes;
    classes.reserve(tested.test.size());
    for (const std::size_t test : tested.test) {
      classes.push_back(nearest_neighbour_class(samples, tested.training, test, tested.classes));
    }
    return classes;
  };
  outcome.raw_baseline = neighbours(vectors);
  outcome.standardized_baseline = outcome.raw_baseline;
  if (tested.training.size() < 2) return;
  // A column that is 0 in all training samples is 0 once standardized.
  const Samples narrow = StoredElements::used_by(vectors.subset(tested.training)).gather(vectors);
  const auto standardization =
      Standardization::fit(narrow.subset(tested.training), {ConstantColumns::kZero});
  if (standardization) outcome.standardized_baseline = neighbours(standardization->apply(narrow));
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

FoldOutcome test_fold(const TrainedFold& trained, const Question& question, const Fold& fold,
                      const std::vector<std::vector<std::size_t>>& wrong_groupings) {
  const Som& som = *som_of(trained.system, question.map);
  const Tested tested{places_of(fold.training, trained.samples),
                      places_of(fold.test, trained.samples),
                      at(question.classes.of_sample, trained.samples)};
  const std::vector<std::size_t> winners = winners_of(som, trained.inputs, 1);
  const NeuronLabels labels = NeuronLabels::by_majority(
      at(winners, tested.training), at(tested.classes, tested.training), som.neurons());
  const SomQuality quality = measure_quality(som, trained.inputs.subset(tested.test));

  FoldOutcome outcome;
  const auto count = static_cast<double>(tested.test.size());
  outcome.summed_distance = quality.quantization_error * count;
  outcome.torn = quality.topographic_error * count;
  outcome.winners = quality.winners;
  SomWorkspace workspace;
  for (const std::size_t sample : tested.test) {
    outcome.predictions.push_back(labels.classify(som, trained.inputs[sample], workspace));
  }
  measure_areas(som, winners, trained.samples, tested, wrong_groupings, outcome);
  measure_baseline(trained.vectors, tested, outcome);
  return outcome;
}

}  // namespace somato
