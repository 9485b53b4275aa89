#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The weights a map starts from, a function of the seed alone, so that they need not be stored:
/// any neuron's weights can be asked for at any time.
class InitialWeightsSource {
 public:
  /// `samples` are the inputs as the map sees them (already of length 1 where it normalizes) and
  /// must outlive this object; at least one.
  InitialWeightsSource(const SomParameters& parameters, const Samples& samples);

  /// Writes the weights of `neuron`, samples.size() values, to `out`; of length 1 for a dot-product
  /// map.
  void write(std::size_t neuron, std::span<float> out) const;

  /// The sample that `neuron` starts at; only with InitialWeights::kSamples.
  std::size_t sample_of(std::size_t neuron) const { return sample_of_neuron_[neuron]; }

 private:
  SomParameters parameters_;
  const Samples& samples_;
  std::vector<float> low_;
  std::vector<float> high_;
  std::vector<std::size_t> sample_of_neuron_;
};

}  // namespace somato
