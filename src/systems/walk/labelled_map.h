#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "maps/reading/class_whitening.h"
#include "somato/core/matrix.h"
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
  /// below `classes`. Map and inputs must outlive it. Distances are those between vectors that are
  /// whitened within the classes of `training` with this shrinkage; with 1, those of the map. Where
  /// it is automatic, they are whitened if they can be. Throws InvalidArgument for a shrinkage
  /// below 1 and a map for which can_be_whitened() is false.
  LabelledMap(const Som& som, const ExplorationValues& inputs,
              const std::vector<std::size_t>& class_of, std::size_t classes,
              const std::vector<std::size_t>& training, std::optional<double> shrinkage = 1.0);
  LabelledMap(const LabelledMap&) = delete;
  LabelledMap& operator=(const LabelledMap&) = delete;
  LabelledMap(LabelledMap&&) = delete;
  LabelledMap& operator=(LabelledMap&&) = delete;
  ~LabelledMap() = default;

  /// The labels of the neurons.
  const NeuronLabels& labels() const { return labels_; }

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
  LabelledNeuron nearest_whitened(std::size_t place, std::optional<std::size_t> except) const;
  std::vector<LabelledNeuron> nearest_measured(const std::vector<std::size_t>& explorations) const;

  const Som& som_;
  const ExplorationValues& inputs_;
  std::vector<std::size_t> class_of_;  ///< Those of the training explorations.
  std::size_t classes_;                ///< The number of classes.
  std::vector<std::size_t> places_;    ///< The places of these explorations among the inputs.
  std::vector<std::size_t> winners_;   ///< The winners of these.
  NeuronLabels labels_;
  Matrix<double> whitening_;  ///< No rows: distances are those of the map.
  std::optional<WhitenedNeurons> whitened_;
};

}  // namespace somato
