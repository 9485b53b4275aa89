#include "studies/run/system_runner.h"

#include <algorithm>
#include <utility>

#include "somato/graph/system_model.h"
#include "somato/maps/som_quality.h"
#include "studies/lifelong/novelty_run.h"
#include "studies/lifelong/object_after_object.h"
#include "studies/lifelong/teaching_run.h"

namespace somato {
namespace {

std::vector<std::size_t> all_tested(const std::vector<Fold>& folds) {
  std::vector<std::size_t> tested;
  for (const Fold& fold : folds) tested.insert(tested.end(), fold.test.begin(), fold.test.end());
  std::sort(tested.begin(), tested.end());
  return tested;
}

std::size_t place_of(std::size_t sample, const std::vector<std::size_t>& ascending) {
  const auto place = std::lower_bound(ascending.begin(), ascending.end(), sample);
  return static_cast<std::size_t>(place - ascending.begin());
}

std::vector<std::vector<const ObjectsOutcome*>> objects_of(const std::vector<SeedOutcome>& seeds) {
  std::vector<std::vector<const ObjectsOutcome*>> all(seeds.size());
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    for (const FoldOutcome* fold : seeds[s].folds) all[s].push_back(&fold->objects);
  }
  return all;
}

FoldSamples division_of(const PreparedStudy& prepared, const ProtocolPart& part,
                        const std::optional<OtherFolds>& other) {
  FoldSamples samples = prepared.divided_by(part.group);
  if (other) samples.choice = other->choice;
  return samples;
}

}  // namespace

SystemRunner::SystemRunner(const StudyDescription& description, const PreparedStudy& prepared,
                           ProtocolPart part, std::size_t number, std::optional<OtherFolds> other)
    : description_(description),
      prepared_(prepared),
      part_(std::move(part)),
      number_(number),
      taken_(part_.protocol == Protocol::kTrainIsTest ? 1 : 0),
      has_baseline_(!other),
      folds_(folds(part_.protocol, division_of(prepared, part_, other))),
      inner_(inner_folds_for(part_.protocol, prepared.divided_by(part_.group), folds_.size())),
      tested_(all_tested(folds_)),
      outcomes_((other ? 1 : description.study.seeds) * folds_.size()),
      neighbours_(folds_.size()),
      are_known_(folds_.size()) {}

std::size_t SystemRunner::known(const Journal& journal) const {
  std::size_t known = 0;
  for (std::size_t i = 0; i < trainings(); ++i) known += is_known(i, journal) ? 1 : 0;
  return known;
}

void SystemRunner::run(std::size_t index, Journal& journal, Tally& tally) {
  if (tally.stopped()) return;
  const std::size_t training = taken_ + index;
  if (const FoldOutcome* known = journal.find(number_, training)) {
    outcomes_[training] = std::make_unique<FoldOutcome>(*known);
    return;
  }
  const std::size_t fold = training % folds_.size();
  auto outcome = outcome_of(fold, seed(training / folds_.size()), tally);
  if (!outcome) return tally.failed(std::move(outcome.error()));
  outcomes_[training] = std::make_unique<FoldOutcome>(std::move(*outcome));
  if (auto kept = journal.add(number_, training, *outcomes_[training]); !kept) {
    return tally.failed(std::move(kept.error()));
  }
  tally.one_done();
}

void SystemRunner::take(const TrainedFold& trained, const FoldOutcome& tested) {
  if (taken_ == 0) return;
  outcomes_[0] = std::make_unique<FoldOutcome>(tested);
  add_distances(trained, *outcomes_[0]);
  std::vector<Neighbours> nearest = neighbours(trained, 0);
  outcomes_[0]->nearest = std::move(nearest.front());
  for (std::size_t i = 0; i < prepared_.alterations.size(); ++i) {
    outcomes_[0]->altered[i].nearest = std::move(nearest[i + 1]);
  }
}

Result<FoldOutcome> SystemRunner::outcome_of(std::size_t fold, std::uint64_t seed, Tally& tally) {
  const Progress progress = [&](std::uint64_t, std::uint64_t) { return tally.should_continue(); };
  if (part_.protocol == Protocol::kObjectAfterObject) {
    const auto nearest = [&](const TrainedFold& trained) {
      auto found = neighbours(trained, fold);
      return found.empty() ? Neighbours() : std::move(found.front());
    };
    return learn_object_after_object(description_, prepared_, folds_[fold], seed, progress,
                                     nearest);
  }
  SOMATO_TRY(auto trained, train_fold(description_, prepared_, folds_[fold], seed, progress));
  FoldOutcome outcome = test_fold(trained, prepared_, folds_[fold], neighbours(trained, fold));
  add_distances(trained, outcome);
  if (part_.protocol != Protocol::kLeaveClassOut) return outcome;
  SOMATO_TRY(const auto novelty,
             find_novelty(description_, prepared_, trained, folds_[fold].training, seed, progress));
  outcome.novelty = test_novelty(novelty, trained, prepared_, folds_[fold]);
  if (description_.study.taught_per_class == 0) return outcome;
  SOMATO_TRY(outcome.teaching,
             test_teaching(description_.study, prepared_, folds_[fold], std::move(trained),
                           outcome.training_winners, novelty, seed));
  return outcome;
}

// Computed once a fold where nothing that comes before the map learns: every seed has the same.
std::vector<Neighbours> SystemRunner::neighbours(const TrainedFold& trained, std::size_t fold) {
  if (!has_baseline_) return {};
  const auto& vectors = prepared_.fixed_vectors;
  if (!vectors) return find_neighbours(trained.vectors, fold);
  std::call_once(are_known_[fold], [&] { neighbours_[fold] = find_neighbours(*vectors, fold); });
  return neighbours_[fold];
}

std::vector<Neighbours> SystemRunner::find_neighbours(const ExplorationValues& vectors,
                                                      std::size_t fold) const {
  return nearest_neighbours(vectors, prepared_, folds_[fold], inner_);
}

std::map<std::string, std::size_t> SystemRunner::chosen_neighbours() const {
  std::map<std::string, std::size_t> chosen;
  for (const auto& outcome : outcomes_) {
    const auto& best = outcome->nearest.best;
    if (!best.empty()) ++chosen[kNeighbourKinds.at(best.front().kind).name()];
  }
  return chosen;
}

void SystemRunner::add_distances(const TrainedFold& trained, FoldOutcome& outcome) const {
  if (folds_.size() > 1) return;
  const Som& som = *som_of(trained.system, prepared_.map);
  outcome.map.u_matrix = u_matrix(som);
  outcome.map.edge_distances = edge_distances(som);
}

ProtocolResults SystemRunner::results() const {
  ProtocolResults results;
  results.protocol = choice_name(part_.protocol);
  results.group = part_.group;
  results.label = description_.study.label;
  results.samples = tested_.size();
  const std::vector<SeedOutcome> all = seeds();
  for (const SeedOutcome& seed : all) results.runs.push_back(run_of(seed));
  const MeasuredStudy measured{description_.study, prepared_, part_.protocol, folds_};
  if (part_.protocol == Protocol::kObjectAfterObject) {
    results.metrics = continual_metrics(objects_of(all));
    add_best_neighbour(measured, all, results.metrics);
  } else {
    results.metrics = metrics_of(measured, all);
  }
  if (results.find_metric("best_neighbour_accuracy"))
    results.chosen_neighbours = chosen_neighbours();
  return results;
}

SystemRunner::NamedSamples SystemRunner::first_named() const {
  const Run run = run_of(seeds().front());
  return {run.labels, run.predictions};
}

std::vector<SeedOutcome> SystemRunner::seeds() const {
  std::vector<SeedOutcome> seeds(outcomes_.size() / folds_.size());
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    seeds[s].seed = seed(s);
    for (std::size_t f = 0; f < folds_.size(); ++f) {
      seeds[s].folds.push_back(outcomes_[s * folds_.size() + f].get());
    }
  }
  return seeds;
}

Run SystemRunner::run_of(const SeedOutcome& seed) const {
  Run run{seed.seed, {}, {}, {}, {}, {}};
  const TrainedMap& map = seed.folds.front()->map;
  if (!map.u_matrix.empty()) run.map = map;
  run.winners.resize(tested_.size());
  for (std::size_t f = 0; f < folds_.size(); ++f) {
    const FoldOutcome& outcome = *seed.folds[f];
    const auto& winners = prepared_.recall ? outcome.recalled : outcome.winners;
    for (std::size_t i = 0; i < folds_[f].test.size(); ++i) {
      run.winners[place_of(folds_[f].test[i], tested_)] = winners[i];
    }
  }
  for (const StudiedLabel& label : prepared_.labels) {
    const bool is_own = &label == &prepared_.labels.front();
    if (part_.protocol == Protocol::kObjectAfterObject && !is_own) continue;
    std::vector<std::vector<std::size_t>> named;
    named.reserve(folds_.size());
    for (std::size_t f = 0; f < folds_.size(); ++f) {
      named.push_back(part_.protocol == Protocol::kObjectAfterObject
                          ? seed.folds[f]->objects.named
                          : predictions(label.classes, folds_[f], *seed.folds[f]));
    }
    std::vector<std::string> names = names_of_tested(label.classes, named);
    if (is_own) {
      run.predictions = std::move(names);
    } else {
      run.other_predictions.emplace_back(label.name, std::move(names));
    }
  }
  for (const std::size_t sample : tested_) {
    run.labels.push_back(prepared_.classes().names[prepared_.classes().of_sample[sample]]);
  }
  return run;
}

std::vector<std::string> SystemRunner::names_of_tested(
    const Classes& classes, const std::vector<std::vector<std::size_t>>& of_folds) const {
  std::vector<std::string> names(tested_.size());
  for (std::size_t f = 0; f < folds_.size(); ++f) {
    for (std::size_t i = 0; i < folds_[f].test.size(); ++i) {
      names[place_of(folds_[f].test[i], tested_)] = classes.names[of_folds[f][i]];
    }
  }
  return names;
}

}  // namespace somato
