#include "systems/walk/labelled_map.h"

#include <algorithm>
#include <utility>

#include "base/core/values_at.h"
#include "maps/reading/sample_reader.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

Numbers winners_at(const Som& som, const Samples& inputs, const Numbers& places) {
  return first_winners(SampleReader(som).read(inputs, places));
}

}  // namespace

LabelledMap::LabelledMap(const Som& som, const ExplorationValues& inputs, const Numbers& class_of,
                         std::size_t classes, const Numbers& training)
    : som_(som),
      inputs_(inputs),
      class_of_(values_at(class_of, training)),
      classes_(classes),
      places_(inputs_.places_of(training)),
      winners_(winners_at(som_, inputs_.samples, places_)),
      labels_(NeuronLabels::by_majority(winners_, class_of_, som_.neurons())) {}

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

// A neuron that no other exploration has won may be a copy of it.
double LabelledMap::distance_from_others(std::size_t i) const {
  SomWorkspace workspace;
  std::size_t neuron = winners_[i];
  const bool is_shared = std::count(winners_.begin(), winners_.end(), neuron) > 1;
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
  for (const LabelledNeuron& one : nearest(explorations)) {
    scores.push_back(one.distance / scale_of[one.label]);
  }
  return scores;
}

Result<Novelty> LabelledMap::novelty(std::vector<double> held_out_scores,
                                     double false_alarm_rate) const {
  Novelty novelty{false_alarm_rate, held_out_scores.size(), 1.0, {}};
  SOMATO_TRY(novelty.threshold, conformal_threshold(std::move(held_out_scores), false_alarm_rate));
  SOMATO_TRY(novelty.scales, scales());
  return novelty;
}

}  // namespace somato
