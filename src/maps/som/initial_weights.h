#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "maps/grid/principal_plane.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The sample that each neuron starts at with InitialWeights::kSamples, of `samples` in all: in
/// random order, and in a new order whenever they run out. `samples` must not be 0.
std::vector<std::size_t> initial_samples(const SomParameters& parameters, std::size_t samples);

/// Refuses (kUsage) initial weights that take too long to compute for these samples, as the map
/// sees them.
Result<void> check_initial_weights(const SomParameters& parameters, const Samples& samples);

/// Writes the weights at the place of `neuron` on the plane, as InitialWeights::kLinear has them.
void write_on_plane(const PrincipalPlane& plane, const SomParameters& parameters,
                    std::size_t neuron, std::span<float> out);

/// The initial weights of a map, a function of the samples and the seed only, so that they need not
/// be stored: the weights of any neuron can be computed at any time.
class InitialWeightsSource {
 public:
  /// `samples` are the inputs as the map sees them (already of length 1 where it normalizes) and
  /// must outlive this object; at least one. check_initial_weights() accepts them. `threads` do
  /// not affect the weights.
  InitialWeightsSource(SomParameters parameters, const Samples& samples, std::size_t threads = 1);

  /// The same for samples reduced to the stored `elements`, without values elsewhere: the weights
  /// of those elements, bit by bit, which is meaningful if all others are 0 (see
  /// are_zero_without_samples()). Throws InvalidArgument unless the samples have a value for each.
  InitialWeightsSource(SomParameters parameters, const Samples& samples, StoredElements elements,
                       std::size_t threads = 1);

  /// Whether an element that is 0 in all samples starts with the weight 0.
  static bool are_zero_without_samples(const SomParameters& parameters) {
    return parameters.initial_weights != InitialWeights::kUniform;
  }

  /// Writes the weights of `neuron`, samples.size() values, to `out`; of length 1 for a dot-product
  /// map.
  void write(std::size_t neuron, std::span<float> out) const;

  /// The sample that `neuron` starts at; only with InitialWeights::kSamples.
  std::size_t sample_of(std::size_t neuron) const { return sample_of_neuron_[neuron]; }

 private:
  void write_uniform(std::uint32_t neuron, std::span<float> out) const;

  SomParameters parameters_;
  const Samples& samples_;
  StoredElements elements_;
  std::vector<float> low_;
  std::vector<float> high_;
  std::vector<std::size_t> sample_of_neuron_;
  PrincipalPlane plane_;
};

}  // namespace somato
