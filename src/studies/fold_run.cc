#include "studies/fold_run.h"

#include <utility>

#include "somato/maps/areas.h"
#include "somato/maps/labels.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

std::vector<std::size_t> at(const std::vector<std::size_t>& values,
                            const std::vector<std::size_t>& places) {
  std::vector<std::size_t> chosen;
  chosen.reserve(places.size());
  for (const std::size_t place : places) chosen.push_back(values[place]);
  return chosen;
}

void measure_areas(const Som& som, const std::vector<std::size_t>& winners,
                   const std::vector<std::size_t>& classes,
                   const std::vector<std::vector<std::size_t>>& wrong_groupings,
                   FoldOutcome& outcome) {
  outcome.apart = individuals_apart(winners, classes);
  const WinnerAreas areas(som.grid(), winners);
  outcome.connected = areas.connected(classes);
  for (const std::vector<std::size_t>& wrong : wrong_groupings) {
    outcome.connected_wrong += areas.connected(wrong) ? 1.0 : 0.0;
  }
  if (wrong_groupings.empty()) return;
  outcome.connected_wrong /= static_cast<double>(wrong_groupings.size());
}

}  // namespace

Result<FoldOutcome> run_fold(const SomParameters& parameters, const PreparedFold& prepared,
                             const std::vector<std::size_t>& classes,
                             const std::vector<std::vector<std::size_t>>& wrong_groupings) {
  const Fold& fold = prepared.fold;
  Result<Som> som = train_som(parameters, prepared.samples.subset(fold.training));
  if (!som) return fail(std::move(som.error()));
  const std::vector<std::size_t> winners = winners_of(*som, prepared.samples, 1);
  const NeuronLabels labels = NeuronLabels::by_majority(at(winners, fold.training),
                                                        at(classes, fold.training), som->neurons());
  const SomQuality quality = measure_quality(*som, prepared.samples.subset(fold.test));

  FoldOutcome outcome;
  const auto tested = static_cast<double>(fold.test.size());
  outcome.summed_distance = quality.quantization_error * tested;
  outcome.torn = quality.topographic_error * tested;
  SomWorkspace workspace;
  for (const std::size_t sample : fold.test) {
    outcome.winners.push_back(winners[sample]);
    outcome.predictions.push_back(labels.classify(*som, prepared.samples[sample], workspace));
  }
  measure_areas(*som, winners, classes, wrong_groupings, outcome);
  return outcome;
}

}  // namespace somato
