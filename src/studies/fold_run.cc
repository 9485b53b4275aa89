#include "studies/fold_run.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "somato/codes/standardization.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "somato/maps/som.h"
#include "studies/nearest_neighbour.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// Numbers of samples among those known, as numbers of explorations.
Numbers neighbours_among(const Samples& samples, const Numbers& training, const Numbers& test,
                         const Numbers& explorations) {
  Numbers nearest = nearest_neighbours(samples, training, test);
  for (std::size_t& one : nearest) one = explorations[one];
  return nearest;
}

// Computes the outputs before the map for the explorations of a fold, unless they are the same in
// every training.
Result<void> see(const PreparedStudy& prepared, const Fold& fold, Activations& activations,
                 TrainedFold& trained) {
  if (prepared.fixed_inputs) {
    trained.inputs = *prepared.fixed_inputs;
    trained.vectors = *prepared.fixed_vectors;
    return {};
  }
  const std::size_t input = trained.system.modules()[prepared.map].inputs.front();
  Numbers samples;
  std::set_union(fold.training.begin(), fold.training.end(), fold.test.begin(), fold.test.end(),
                 std::back_inserter(samples));
  auto seen = evaluate(trained.system, prepared.recording, samples, {input, prepared.vectors}, 1,
                       activations);
  if (!seen) return seen;
  trained.inputs = activations.values_of(input);
  trained.vectors = activations.values_of(prepared.vectors);
  return {};
}

}  // namespace

Result<TrainedFold> train_fold(const StudyDescription& description, const PreparedStudy& prepared,
                               const Fold& fold, std::uint64_t seed, const Progress& progress) {
  auto system = prepared.system(description);
  if (!system) return fail(std::move(system.error()));
  TrainedFold trained{std::move(*system), {}, {}};
  Activations activations = prepared.fixed;
  const SystemTraining training{seed, 1, progress, {}, fold.test};
  auto done = train_system(trained.system, prepared.recording, fold.training, training, activations)
                  .and_then([&] { return see(prepared, fold, activations, trained); });
  if (!done) return fail(std::move(done.error()));
  return trained;
}

Neighbours nearest_neighbours(const ExplorationValues& vectors, const Fold& fold) {
  const Samples& samples = vectors.samples;
  const Numbers training = vectors.places_of(fold.training);
  const Numbers test = vectors.places_of(fold.test);
  // A column that is 0 in all training samples takes a tested one as far from each of them, and is
  // 0 once standardized.
  const Samples narrow = StoredElements::used_by(samples.subset(training)).gather(samples);
  Neighbours nearest;
  nearest.raw = neighbours_among(narrow, training, test, vectors.explorations);
  nearest.standardized = nearest.raw;
  if (training.size() < 2) return nearest;
  const auto standardization =
      Standardization::fit(narrow.subset(training), {ConstantColumns::kZero});
  if (!standardization) return nearest;
  nearest.standardized =
      neighbours_among(standardization->apply(narrow), training, test, vectors.explorations);
  return nearest;
}

FoldOutcome test_fold(const TrainedFold& trained, const PreparedStudy& prepared, const Fold& fold,
                      Neighbours nearest) {
  const Som& som = *som_of(trained.system, prepared.map);
  const Samples& inputs = trained.inputs.samples;
  SomWorkspace workspace;
  FoldOutcome outcome;
  outcome.nearest = std::move(nearest);
  for (const std::size_t sample : trained.inputs.places_of(fold.training)) {
    outcome.training_winners.push_back(som.winners(inputs, sample, workspace).first);
  }
  const std::set<std::size_t> won(outcome.training_winners.begin(), outcome.training_winners.end());
  const Numbers named(won.begin(), won.end());
  for (const std::size_t sample : trained.inputs.places_of(fold.test)) {
    const Winners winners = som.winners(inputs, sample, workspace);
    const bool topographic_errors =
        winners.first != winners.second && !prepared.grid.adjacent(winners.first, winners.second);
    outcome.winners.push_back(winners.first);
    outcome.summed_distance += som.distance(inputs, sample, winners.first, workspace);
    outcome.topographic_errors += topographic_errors ? 1.0 : 0.0;
    outcome.named_by.push_back(som.winner_among(named, inputs, sample, workspace));
  }
  return outcome;
}

}  // namespace somato
