#include "studies/folds/fold_run.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "maps/reading/sample_reader.h"
#include "somato/codes/standardization.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "somato/maps/som.h"
#include "studies/folds/senses.h"
#include "studies/measures/nearest_neighbour.h"

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
  const std::size_t input = trained.system.modules()[prepared.map].inputs.front();
  Numbers wanted;
  if (!prepared.fixed_vectors) wanted = prepared.vectors;
  if (!prepared.fixed_inputs) wanted.push_back(input);
  SOMATO_TRY_VOID(
      evaluate(trained.system, prepared.recording, prepared.used_by(fold), wanted, 1, activations));
  trained.inputs = prepared.fixed_inputs ? *prepared.fixed_inputs : activations.values_of(input);
  trained.vectors =
      prepared.fixed_vectors ? *prepared.fixed_vectors : values_of(activations, prepared.vectors);
  return {};
}

// The activities that are called up for the tested explorations, and the predictions.
Result<void> recall(const PreparedStudy& prepared, const Fold& fold, Activations& activations,
                    TrainedFold& trained) {
  if (prepared.recall) {
    SOMATO_TRY_VOID(evaluate(trained.system, prepared.recording, prepared.tested_by(fold),
                             {*prepared.recall}, 1, activations));
    trained.recalled = activations.values_of(*prepared.recall);
  }
  for (const Prediction& prediction : prepared.predictions) {
    SOMATO_TRY(auto compared, compare_prediction(trained.system, prepared.recording, prediction,
                                                 fold, activations));
    trained.predictions.push_back(compared);
  }
  return {};
}

// The strongest of these neurons for each exploration; the first in a tie.
Numbers strongest_among(const Numbers& neurons, const ExplorationValues& activities,
                        const Numbers& explorations) {
  std::vector<float> activity(activities.samples.size());
  const auto weaker = [&](std::size_t a, std::size_t b) { return activity[a] < activity[b]; };
  Numbers strongest;
  strongest.reserve(explorations.size());
  for (const std::size_t sample : activities.places_of(explorations)) {
    write_dense(activities.samples[sample], activity);
    strongest.push_back(*std::max_element(neurons.begin(), neurons.end(), weaker));
  }
  return strongest;
}

Numbers strongest_of_all(const ExplorationValues& activities, const Numbers& explorations) {
  Numbers neurons(activities.samples.size());
  std::iota(neurons.begin(), neurons.end(), std::size_t{0});
  return strongest_among(neurons, activities, explorations);
}

// The neighbours of `test`; `narrow` contains the vectors of all explorations.
Neighbours neighbours_of(const ExplorationValues& vectors, const Samples& narrow,
                         const std::optional<Samples>& standardized, const Numbers& training,
                         const Numbers& test) {
  const Numbers places = vectors.places_of(test);
  Neighbours nearest;
  nearest.raw = neighbours_among(narrow, training, places, vectors.explorations);
  nearest.standardized =
      standardized ? neighbours_among(*standardized, training, places, vectors.explorations)
                   : nearest.raw;
  return nearest;
}

// Names test samples by the neurons that training samples won.
class Naming {
 public:
  Naming(const TrainedFold& trained, const PreparedStudy& prepared, const Numbers& training_winners)
      : som_(*som_of(trained.system, prepared.map)),
        inputs_(trained.inputs),
        recalled_(trained.recalled) {
    const std::set<std::size_t> won(training_winners.begin(), training_winners.end());
    won_.assign(won.begin(), won.end());
  }

  Numbers named_by(const Numbers& explorations) {
    if (recalled_) return strongest_among(won_, *recalled_, explorations);
    return SampleReader(som_, 1, won_)
        .read(inputs_.samples, inputs_.places_of(explorations))
        .nearest;
  }

 private:
  const Som& som_;
  const ExplorationValues& inputs_;
  const std::optional<ExplorationValues>& recalled_;
  Numbers won_;
};

}  // namespace

Result<TrainedFold> train_fold(const StudyDescription& description, const PreparedStudy& prepared,
                               const Fold& fold, std::uint64_t seed, const Progress& progress) {
  SOMATO_TRY(auto system, prepared.system(description));
  TrainedFold trained{std::move(system), {}, {}, {}, {}};
  Activations activations = prepared.fixed;
  const Numbers tested = prepared.tested_by(fold);
  const SystemTraining training{seed, 1, progress, {}, tested, prepared.classes().of_sample};
  auto done = train_system(trained.system, prepared.recording, fold.training, training, activations)
                  .and_then([&] { return see(prepared, fold, activations, trained); })
                  .and_then([&] { return recall(prepared, fold, activations, trained); });
  if (!done) return fail(std::move(done.error()));
  return trained;
}

std::vector<Neighbours> nearest_neighbours(const ExplorationValues& vectors, const Numbers& learned,
                                           const std::vector<Numbers>& tests) {
  const Samples& samples = vectors.samples;
  const Numbers training = vectors.places_of(learned);
  // A column that is 0 in all training samples takes a tested one as far from each of them, and is
  // 0 once standardized.
  const Samples narrow = StoredElements::used_by(samples.subset(training)).gather(samples);
  std::optional<Samples> standardized;
  if (training.size() >= 2) {
    const auto standardization =
        Standardization::fit(narrow.subset(training), {ConstantColumns::kZero});
    if (standardization) standardized = standardization->apply(narrow);
  }
  std::vector<Neighbours> nearest;
  nearest.reserve(tests.size());
  for (const Numbers& test : tests) {
    nearest.push_back(neighbours_of(vectors, narrow, standardized, training, test));
  }
  return nearest;
}

std::vector<Neighbours> nearest_neighbours(const ExplorationValues& vectors,
                                           const PreparedStudy& prepared, const Fold& fold) {
  std::vector<Numbers> tests{fold.test};
  for (std::size_t i = 0; i < prepared.alterations.size(); ++i) {
    tests.push_back(prepared.altered(fold.test, i));
  }
  return nearest_neighbours(vectors, fold.training, tests);
}

FoldOutcome test_fold(const TrainedFold& trained, const PreparedStudy& prepared, const Fold& fold,
                      std::vector<Neighbours> nearest) {
  const Som& som = *som_of(trained.system, prepared.map);
  const Samples& inputs = trained.inputs.samples;
  FoldOutcome outcome;
  outcome.map.grid = som.grid();
  nearest.resize(1 + prepared.alterations.size());
  outcome.nearest = std::move(nearest.front());
  outcome.training_winners =
      first_winners(SampleReader(som).read(inputs, trained.inputs.places_of(fold.training)));
  Naming naming(trained, prepared, outcome.training_winners);
  outcome.named_by = naming.named_by(fold.test);
  const SampleReadings tested =
      SampleReader(som).read(inputs, trained.inputs.places_of(fold.test), {true, true});
  outcome.winners = first_winners(tested);
  for (std::size_t i = 0; i < tested.winners.size(); ++i) {
    const auto [first, second] = tested.winners[i];
    outcome.summed_distance += tested.distances[i];
    outcome.topographic_errors +=
        first != second && !som.grid().adjacent(first, second) ? 1.0 : 0.0;
  }
  for (std::size_t i = 0; i < prepared.alterations.size(); ++i) {
    outcome.altered.push_back(
        {naming.named_by(prepared.altered(fold.test, i)), std::move(nearest[i + 1])});
  }
  if (trained.recalled) outcome.recalled = strongest_of_all(*trained.recalled, fold.test);
  outcome.predictions = trained.predictions;
  return outcome;
}

}  // namespace somato
