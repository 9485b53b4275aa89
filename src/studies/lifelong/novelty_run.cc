#include "studies/lifelong/novelty_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "maps/reading/novelty_reader.h"
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
                         const std::vector<std::size_t>& training,
                         std::optional<double> shrinkage) {
  return {*som_of(trained.system, prepared.map), trained.inputs, prepared.classes().of_sample,
          prepared.classes().names.size(),       training,       shrinkage};
}

Result<Novelty> find_novelty(const StudyDescription& description, const PreparedStudy& prepared,
                             const TrainedFold& trained, const std::vector<std::size_t>& training,
                             std::uint64_t seed, const Progress& progress) {
  const StudyParameters& study = description.study;
  SOMATO_TRY_VOID(check_scores(training.size(), study.false_alarm_rate));
  const std::optional<double> shrinkage = study.whitening_shrinkage;
  const bool is_plain = shrinkage.value_or(1.0) == 1.0;
  if (!is_plain && !can_be_whitened(*som_of(trained.system, prepared.map))) {
    return not_to_be_whitened();
  }
  std::vector<double> scores;
  for (const Fold& part :
       folds_among(training, prepared.classes().of_sample, study.calibration_folds,
                   study.first_seed, prepared.samples.choice)) {
    SOMATO_TRY(const auto without, train_fold(description, prepared, part, seed, progress));
    const Numbers learned = of_learned_classes(part, prepared.classes().of_sample);
    SOMATO_TRY(const auto held_out,
               labelled_map(without, prepared, part.training, shrinkage).held_out_scores(learned));
    scores.insert(scores.end(), held_out.begin(), held_out.end());
  }
  return labelled_map(trained, prepared, training, shrinkage)
      .novelty(std::move(scores), study.false_alarm_rate);
}

NoveltyOutcome test_novelty(const Novelty& novelty, const TrainedFold& trained,
                            const PreparedStudy& prepared, const Fold& fold) {
  const LabelledMap map = labelled_map(trained, prepared, fold.training, 1.0);
  const NoveltyReader reader(novelty, *som_of(trained.system, prepared.map), map.labels());
  const auto scores_of = [&](const Numbers& explorations) {
    NoveltyScores scores;
    const Numbers places = trained.inputs.places_of(explorations);
    const std::vector<LabelledNeuron> nearest = map.nearest(explorations);
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      const auto& [label, distance] = nearest[i];
      scores.novelty.push_back(reader.of(trained.inputs.samples[places[i]], label, distance));
      scores.distance.push_back(distance);
    }
    scores.nearest = nearest_distances(trained, fold, explorations);
    return scores;
  };
  return {scores_of(fold.known), scores_of(fold.test), {novelty.samples}};
}

}  // namespace somato
