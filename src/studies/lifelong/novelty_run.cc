#include "studies/lifelong/novelty_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "somato/graph/system_model.h"
#include "studies/measures/nearest_neighbour.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

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

// The test explorations whose classes have training explorations: others are unknown themselves.
Numbers of_learned_classes(const Fold& part, const Numbers& class_of) {
  std::set<std::size_t> learned;
  for (const std::size_t one : part.training) learned.insert(class_of[one]);
  Numbers tested;
  std::copy_if(part.test.begin(), part.test.end(), std::back_inserter(tested),
               [&](std::size_t one) { return learned.contains(class_of[one]); });
  return tested;
}

}  // namespace

LabelledMap labelled_map(const TrainedFold& trained, const PreparedStudy& prepared,
                         const std::vector<std::size_t>& training) {
  return {*som_of(trained.system, prepared.map), trained.inputs, prepared.classes().of_sample,
          prepared.classes().names.size(), training};
}

Result<Novelty> find_novelty(const StudyDescription& description, const PreparedStudy& prepared,
                             const TrainedFold& trained, const std::vector<std::size_t>& training,
                             std::uint64_t seed, const Progress& progress) {
  const StudyParameters& study = description.study;
  SOMATO_TRY_VOID(check_scores(training.size(), study.false_alarm_rate));
  std::vector<double> scores;
  for (const Fold& part : folds_among(training, prepared.classes().of_sample,
                                      study.calibration_folds, study.first_seed)) {
    SOMATO_TRY(const auto without, train_fold(description, prepared, part, seed, progress));
    const Numbers learned = of_learned_classes(part, prepared.classes().of_sample);
    SOMATO_TRY(const auto held_out,
               labelled_map(without, prepared, part.training).held_out_scores(learned));
    scores.insert(scores.end(), held_out.begin(), held_out.end());
  }
  return labelled_map(trained, prepared, training)
      .novelty(std::move(scores), study.false_alarm_rate);
}

NoveltyOutcome test_novelty(const Novelty& novelty, const TrainedFold& trained,
                            const PreparedStudy& prepared, const Fold& fold) {
  const LabelledMap map = labelled_map(trained, prepared, fold.training);
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
