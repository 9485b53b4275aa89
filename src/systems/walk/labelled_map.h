#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/evaluation.h"
#include "somato/maps/labels.h"
#include "somato/maps/novelty.h"
#include "somato/maps/som.h"

namespace somato {

/// The nearest labelled neuron of a sample.
struct LabelledNeuron {
  std::size_t label = 0;  ///< Its class.
  double distance = 0.0;
};

/// A trained map whose neurons have the classes of the explorations that it has learned, to find
/// thresholds for unknown explorations.
class LabelledMap {
 public:
  /// `inputs` has the inputs of `training` at least, and `class_of` the class of every exploration,
  /// below `classes`. Map and inputs must outlive it.
  LabelledMap(const Som& som, const ExplorationValues& inputs,
              const std::vector<std::size_t>& class_of, std::size_t classes,
              const std::vector<std::size_t>& training);

  /// The nearest labelled neuron for each exploration, for which the inputs must be known.
  std::vector<LabelledNeuron> nearest(const std::vector<std::size_t>& explorations) const;

  /// The scales of the classes: the mean distance of their training explorations, each from the
  /// neurons that other explorations have won. Errors: those of class_scales().
  Result<std::vector<double>> scales() const;

  /// The distances of explorations that the map has not learned, in units of the scales. Errors:
  /// those of scales().
  Result<std::vector<double>> held_out_scores(const std::vector<std::size_t>& explorations) const;

  /// The novelty with the scales of this map, whose threshold follows from the scores of held-out
  /// explorations. Errors: those of scales() and conformal_threshold().
  Result<Novelty> novelty(std::vector<double> held_out_scores, double false_alarm_rate) const;

 private:
  double distance_from_others(std::size_t place) const;

  const Som& som_;
  const ExplorationValues& inputs_;
  std::vector<std::size_t> class_of_;  ///< Those of the training explorations.
  std::size_t classes_;                ///< The number of classes.
  std::vector<std::size_t> places_;    ///< The places of these explorations among the inputs.
  std::vector<std::size_t> winners_;   ///< The winners of these.
  NeuronLabels labels_;
};

}  // namespace somato
