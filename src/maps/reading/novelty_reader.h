#pragma once

#include <cstddef>
#include <optional>

#include "maps/reading/class_whitening.h"
#include "somato/maps/labels.h"
#include "somato/maps/novelty.h"
#include "somato/maps/som.h"

namespace somato {

/// The novelty of the inputs of a map. All const functions can be used by several threads.
class NoveltyReader {
 public:
  /// The novelty must outlive it. Throws InvalidArgument for a whitening of another size than the
  /// inputs of the map, or if no neuron has a label.
  NoveltyReader(const Novelty& novelty, const Som& som, const NeuronLabels& labels);

  /// The novelty of an input whose nearest labelled neuron has the class `label`, at `distance`.
  /// With a whitening, that of the labelled neuron that is nearest after whitening, which may have
  /// another class.
  double of(const SignalView& input, std::size_t label, double distance) const;

 private:
  const Novelty* novelty_;
  NeuronLabels labels_;
  std::optional<WhitenedNeurons> whitened_;
};

}  // namespace somato
