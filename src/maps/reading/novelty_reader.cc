#include "maps/reading/novelty_reader.h"

namespace somato {

NoveltyReader::NoveltyReader(const Novelty& novelty, const Som& som, const NeuronLabels& labels)
    : novelty_(&novelty), labels_(labels) {
  if (!novelty.whitening.empty()) whitened_.emplace(novelty.whitening, som, labels.labelled());
}

double NoveltyReader::of(const SignalView& input, std::size_t label, double distance) const {
  if (!whitened_) return novelty_->of(label, distance);
  const WhitenedNeurons::Nearest nearest = whitened_->nearest(input);
  return novelty_->of(*labels_[nearest.neuron], nearest.distance);
}

}  // namespace somato
