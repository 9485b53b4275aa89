#include "studies/novelty_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "somato/graph/system_model.h"
#include "studies/nearest_neighbour.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

Numbers classes_of(const PreparedStudy& prepared, const Numbers& explorations) {
  Numbers classes;
  classes.reserve(explorations.size());
  for (const std::size_t one : explorations) {
    classes.push_back(prepared.classes().of_sample[one]);
  }
  return classes;
}

Numbers winners_at(const Som& som, const Samples& inputs, const Numbers& places) {
  SomWorkspace workspace;
  Numbers winners;
  winners.reserve(places.size());
  for (const std::size_t place : places) {
    winners.push_back(som.winners(inputs, place, workspace).first);
  }
  return winners;
}

// The distances of held-out explorations in units of the scales of a system that has not learned
// from them.
Result<std::vector<double>> held_out_scores(const TrainedFold& trained,
                                            const PreparedStudy& prepared, const Fold& part) {
  const LabelledMap map(trained, prepared, part.training);
  SOMATO_TRY(const auto scales, map.scales());
  std::vector<double> scores;
  scores.reserve(part.test.size());
  for (const LabelledNeuron& one : map.nearest(part.test)) {
    scores.push_back(one.distance / scales[one.label]);
  }
  return scores;
}

std::vector<double> nearest_distances(const TrainedFold& trained, const Fold& fold,
                                      const Numbers& explorations) {
  const Samples& vectors = trained.vectors.samples;
  const Numbers places = trained.vectors.places_of(explorations);
  const Numbers nearest =
      nearest_neighbours(vectors, trained.vectors.places_of(fold.training), places);
  std::vector<double> distances;
  distances.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double squared = squared_distance(vectors[places[i]], vectors[nearest[i]]);
    distances.push_back(std::sqrt(std::max(squared, 0.0)));
  }
  return distances;
}

}  // namespace

LabelledMap::LabelledMap(const TrainedFold& trained, const PreparedStudy& prepared,
                         const std::vector<std::size_t>& training)
    : som_(*som_of(trained.system, prepared.map)),
      inputs_(trained.inputs),
      classes_(classes_of(prepared, training)),
      count_(prepared.classes().names.size()),
      places_(inputs_.places_of(training)),
      winners_(winners_at(som_, inputs_.samples, places_)),
      labels_(NeuronLabels::by_majority(winners_, classes_, som_.neurons())) {}

std::vector<LabelledNeuron> LabelledMap::nearest(
    const std::vector<std::size_t>& explorations) const {
  SomWorkspace workspace;
  std::vector<LabelledNeuron> nearest;
  nearest.reserve(explorations.size());
  for (const std::size_t place : inputs_.places_of(explorations)) {
    const std::size_t neuron =
        som_.winner_among(labels_.labelled(), inputs_.samples, place, workspace);
    nearest.push_back({*labels_[neuron], som_.distance(inputs_.samples, place, neuron, workspace)});
  }
  return nearest;
}

// A neuron that no other exploration has won may be a copy of it.
double LabelledMap::distance_from_others(std::size_t i) const {
  std::vector<std::size_t> others = labels_.labelled();
  const bool is_shared = std::count(winners_.begin(), winners_.end(), winners_[i]) > 1;
  if (!is_shared && others.size() > 1) std::erase(others, winners_[i]);
  SomWorkspace workspace;
  const std::size_t neuron = som_.winner_among(others, inputs_.samples, places_[i], workspace);
  return som_.distance(inputs_.samples, places_[i], neuron, workspace);
}

Result<std::vector<double>> LabelledMap::scales() const {
  std::vector<double> distances;
  distances.reserve(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) distances.push_back(distance_from_others(i));
  return class_scales(classes_, distances, count_);
}

Result<Novelty> find_novelty(const StudyDescription& description, const PreparedStudy& prepared,
                             const TrainedFold& trained, const std::vector<std::size_t>& training,
                             std::uint64_t seed, const Progress& progress) {
  std::vector<double> scores;
  const StudyParameters& study = description.study;
  for (const Fold& part : folds_among(training, prepared.classes().of_sample,
                                      study.calibration_folds, study.first_seed)) {
    SOMATO_TRY(const auto without, train_fold(description, prepared, part, seed, progress));
    SOMATO_TRY(const auto held_out, held_out_scores(without, prepared, part));
    scores.insert(scores.end(), held_out.begin(), held_out.end());
  }
  Novelty novelty{study.false_alarm_rate, scores.size(), 1.0, {}};
  SOMATO_TRY(novelty.threshold, conformal_threshold(std::move(scores), novelty.false_alarm_rate));
  SOMATO_TRY(novelty.scales, LabelledMap(trained, prepared, training).scales());
  return novelty;
}

NoveltyOutcome test_novelty(const Novelty& novelty, const TrainedFold& trained,
                            const PreparedStudy& prepared, const Fold& fold) {
  const LabelledMap map(trained, prepared, fold.training);
  const auto scores_of = [&](const Numbers& explorations) {
    NoveltyScores scores;
    for (const LabelledNeuron& one : map.nearest(explorations)) {
      scores.novelty.push_back(novelty.of(one.label, one.distance));
      scores.distance.push_back(one.distance);
    }
    scores.nearest = nearest_distances(trained, fold, explorations);
    return scores;
  };
  return {scores_of(fold.known), scores_of(fold.test)};
}

}  // namespace somato
