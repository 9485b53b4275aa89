#include "systems/walk/labelled_map.h"

#include <algorithm>
#include <utility>

#include "base/core/values_at.h"
#include "maps/reading/sample_reader.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

Numbers winners_at(const Som& som, const Samples& inputs, const Numbers& places) {
  return first_winners(SampleReader(som).read(inputs, places));
}

}  // namespace

LabelledMap::LabelledMap(const Som& som, const ExplorationValues& inputs, const Numbers& class_of,
                         std::size_t classes, const Numbers& training,
                         std::optional<double> shrinkage)
    : som_(som),
      inputs_(inputs),
      class_of_(values_at(class_of, training)),
      classes_(classes),
      places_(inputs_.places_of(training)),
      winners_(winners_at(som_, inputs_.samples, places_)),
      labels_(NeuronLabels::by_majority(winners_, class_of_, som_.neurons())) {
  const bool possible = can_be_whitened(som_);
  const double share = shrinkage.value_or(possible ? kWhiteningShrinkage : 1.0);
  if (share == 1.0) return;
  require(possible, "distances of this map cannot be whitened");
  whitening_ = whitening_within_classes(inputs_.samples, places_, class_of_, share);
  whitened_.emplace(whitening_, som_, labels_.labelled());
}

std::vector<LabelledNeuron> LabelledMap::nearest(const Numbers& explorations) const {
  const Numbers places = inputs_.places_of(explorations);
  const Numbers neurons =
      SampleReader(som_, 1, labels_.labelled()).read(inputs_.samples, places).nearest;
  SomWorkspace workspace;
  std::vector<LabelledNeuron> nearest;
  nearest.reserve(neurons.size());
  for (std::size_t i = 0; i < neurons.size(); ++i) {
    nearest.push_back(
        {*labels_[neurons[i]], som_.distance(inputs_.samples, places[i], neurons[i], workspace)});
  }
  return nearest;
}

LabelledNeuron LabelledMap::nearest_whitened(std::size_t place,
                                             std::optional<std::size_t> except) const {
  const WhitenedNeurons::Nearest found = whitened_->nearest(inputs_.samples[place], except);
  return {*labels_[found.neuron], found.distance};
}

// In the distance in which novelty is measured.
std::vector<LabelledNeuron> LabelledMap::nearest_measured(const Numbers& explorations) const {
  if (!whitened_) return nearest(explorations);
  std::vector<LabelledNeuron> measured;
  measured.reserve(explorations.size());
  for (const std::size_t place : inputs_.places_of(explorations)) {
    measured.push_back(nearest_whitened(place, {}));
  }
  return measured;
}

// A neuron that no other exploration has won may be a copy of it.
double LabelledMap::distance_from_others(std::size_t i) const {
  SomWorkspace workspace;
  std::size_t neuron = winners_[i];
  const bool is_shared = std::count(winners_.begin(), winners_.end(), neuron) > 1;
  if (whitened_) {
    return nearest_whitened(places_[i], is_shared ? std::nullopt : std::optional(neuron)).distance;
  }
  if (!is_shared && labels_.labelled().size() > 1) {
    std::vector<std::size_t> others = labels_.labelled();
    std::erase(others, neuron);
    neuron = som_.winner_among(others, inputs_.samples, places_[i], workspace);
  }
  return som_.distance(inputs_.samples, places_[i], neuron, workspace);
}

Result<std::vector<double>> LabelledMap::scales() const {
  std::vector<double> distances;
  distances.reserve(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) distances.push_back(distance_from_others(i));
  return class_scales(class_of_, distances, classes_);
}

Result<std::vector<double>> LabelledMap::held_out_scores(const Numbers& explorations) const {
  SOMATO_TRY(const auto scale_of, scales());
  std::vector<double> scores;
  scores.reserve(explorations.size());
  for (const LabelledNeuron& one : nearest_measured(explorations)) {
    scores.push_back(one.distance / scale_of[one.label]);
  }
  return scores;
}

Result<Novelty> LabelledMap::novelty(std::vector<double> held_out_scores,
                                     double false_alarm_rate) const {
  Novelty novelty{false_alarm_rate, held_out_scores.size(), 1.0, {}, whitening_};
  SOMATO_TRY(novelty.threshold, conformal_threshold(std::move(held_out_scores), false_alarm_rate));
  SOMATO_TRY(novelty.scales, scales());
  return novelty;
}

}  // namespace somato
