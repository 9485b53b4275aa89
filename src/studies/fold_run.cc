#include "studies/fold_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "somato/codes/standardization.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "somato/maps/som_training.h"
#include "somato/maps/stored_elements.h"
#include "somato/studies/nearest_neighbour.h"

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

// Computes what the modules before the map give for the explorations of a fold, unless every
// training has the same.
Result<void> see(const Question& question, const Recording& recording, const Fold& fold,
                 Activations& activations, TrainedFold& trained) {
  const std::size_t input = trained.system.modules()[question.map].inputs.front();
  if (question.fixed_inputs) {
    trained.inputs = *question.fixed_inputs;
    trained.vectors = *question.fixed_vectors;
    return {};
  }
  Numbers samples;
  std::set_union(fold.training.begin(), fold.training.end(), fold.test.begin(), fold.test.end(),
                 std::back_inserter(samples));
  auto seen =
      evaluate(trained.system, recording, samples, {input, question.vectors}, 1, activations);
  if (!seen) return seen;
  trained.inputs = values_of(activations, input, samples);
  trained.vectors = question.fixed_vectors ? *question.fixed_vectors
                                           : values_of(activations, question.vectors, samples);
  return {};
}

Error place(Error error, const System& system, std::size_t module) {
  return error.kind == ErrorKind::kInterrupted ? error : system.at_module(std::move(error), module);
}

// Trains the map that answers on what it sees, and forms its weights only where it needs them.
Result<void> train_map(const SomParameters& parameters, const Question& question, const Fold& fold,
                       const Progress& progress, TrainedFold& trained) {
  const Numbers training = trained.inputs.places_of(fold.training);
  const TrainingOptions options{1, progress};
  auto products = train_product_som(parameters, trained.inputs.samples, training, options);
  if (!products) return fail(place(std::move(products.error()), trained.system, question.map));
  trained.products = std::move(*products);
  if (trained.products) return {};
  auto som = train_som(parameters, trained.inputs.samples.samples().subset(training), options);
  if (!som) return fail(place(std::move(som.error()), trained.system, question.map));
  set_map(trained.system, question.map, std::move(*som));
  return {};
}

// What a map says of the samples it was trained on and tested with.
class Answers {
 public:
  Answers(const TrainedFold& trained, const Question& question)
      : products_(trained.products ? &*trained.products : nullptr),
        som_(products_ ? nullptr : som_of(trained.system, question.map)),
        samples_(trained.inputs.samples.samples()) {}

  Winners winners(std::size_t sample) {
    return products_ ? products_->winners(sample) : som_->winners(samples_[sample], workspace_);
  }

  std::size_t winner_among(const Numbers& candidates, std::size_t sample) {
    return products_ ? products_->winner_among(candidates, sample)
                     : som_->winner_among(candidates, samples_[sample], workspace_);
  }

  double distance(std::size_t sample, std::size_t neuron) {
    return products_ ? std::sqrt(products_->squared_distance(sample, neuron))
                     : som_->distance(samples_[sample], neuron, workspace_);
  }

 private:
  const ProductSom* products_;
  const Som* som_;
  const Samples& samples_;
  SomWorkspace workspace_;
};

}  // namespace

Result<TrainedFold> train_fold(const StudyDescription& description, const Question& question,
                               const Fold& fold, std::uint64_t seed, const Progress& progress) {
  auto system = question.system(description);
  if (!system) return fail(std::move(system.error()));
  TrainedFold trained{std::move(*system), {}, {}, {}};
  const auto alone = parameters_alone(trained.system, question.map, seed);
  Activations activations = question.fixed;
  const SystemTraining training{seed, 1, progress,
                                alone ? std::optional(question.map) : std::nullopt};
  auto done =
      train_system(trained.system, question.recording, fold.training, training, activations)
          .and_then([&] { return see(question, question.recording, fold, activations, trained); });
  if (done && alone) done = train_map(*alone, question, fold, progress, trained);
  if (!done) return fail(std::move(done.error()));
  return trained;
}

void form_map(TrainedFold& trained, const Question& question) {
  if (trained.products) set_map(trained.system, question.map, trained.products->form_som());
}

Neighbours nearest_neighbours(const ExplorationValues& vectors, const Fold& fold) {
  const Samples& samples = vectors.samples.samples();
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

FoldOutcome test_fold(const TrainedFold& trained, const Question& question, const Fold& fold,
                      Neighbours nearest) {
  Answers answers(trained, question);
  FoldOutcome outcome;
  outcome.nearest = std::move(nearest);
  for (const std::size_t sample : trained.inputs.places_of(fold.training)) {
    outcome.training_winners.push_back(answers.winners(sample).first);
  }
  const std::set<std::size_t> won(outcome.training_winners.begin(), outcome.training_winners.end());
  const Numbers named(won.begin(), won.end());
  for (const std::size_t sample : trained.inputs.places_of(fold.test)) {
    const Winners winners = answers.winners(sample);
    const bool torn =
        winners.first != winners.second && !question.grid.adjacent(winners.first, winners.second);
    outcome.winners.push_back(winners.first);
    outcome.summed_distance += answers.distance(sample, winners.first);
    outcome.torn += torn ? 1.0 : 0.0;
    outcome.named_by.push_back(answers.winner_among(named, sample));
  }
  return outcome;
}

}  // namespace somato
