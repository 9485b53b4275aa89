#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som_parameters.h"

namespace somato {

// The size and the length of training of a map that follow from its samples, without labels
// (docs/decisions/0040-automatic-size.md). A map of measured size keeps about as much of the
// samples as a nearest neighbour does, and it is less suitable for looking at than a map of few
// neurons.

/// How the size of a map is decided where it is not given.
enum class SizeChoice {
  kByNumber,  ///< From the number of samples (decide_size()).
  kMeasured,  ///< From the distances of samples that are not learned (measured_size()).
};

template <>
struct Choices<SizeChoice> {
  static const std::vector<std::pair<SizeChoice, std::string>>& all();
};

/// The choice of the size as a parameter.
struct SizeParameters {
  SizeChoice size = SizeChoice::kByNumber;

  static const Declarations<SizeParameters>& declarations();
};

/// Why the parameter `name` of SomParameters has no effect with this choice of the size; empty if
/// it has an effect. A measured size decides the sides, the initial weights, the method, the length
/// and the radius of training.
std::string reason_without_effect(SizeChoice size, std::string_view name);

/// A map, and the mean distance from its winners of samples that it has not learned.
struct SizeCheck {
  std::size_t neurons = 0;
  double error = 0.0;
};

/// The measured size of a map.
struct MeasuredSize {
  double share = 1.0;             ///< Neurons for each sample that is learned; 1 is the greatest.
  std::vector<SizeCheck> checks;  ///< In ascending order of neurons; empty if nothing was measured.
};

/// Options of a measurement of the size.
struct SizeOptions {
  std::size_t threads = 1;                          ///< Does not affect the size.
  std::function<Result<void>()> proceed = nullptr;  ///< Called before each map; may be empty.
};

/// The number of neurons by measured convergence: maps of a sixteenth, an eighth, a quarter, a half
/// and as many neurons as samples learn four of five samples in batches, and the distance of a
/// random fifth is measured; of fewer than 2500 samples, others are held out in turn, until 500
/// distances or those of all samples are measured. The least number is taken than which the best
/// one is not better by more than one standard error of the differences (the rule of Breiman and
/// others, Classification and Regression Trees, 1984), or by at most 1e-4 of the distance from a
/// single neuron. `parameters` give the similarity, the grid and the layers of the maps. Without
/// labels, and the same for any number of threads.
///
/// Fewer than 50 samples are not measured, because fewer than ten would decide. Errors: those of
/// training and of `proceed`.
Result<MeasuredSize> measured_size(const SomParameters& parameters, const Samples& samples,
                                   const SizeOptions& options = {});

/// The greatest number of neurons for so many samples: as many, and above 2500 samples 50 times the
/// root of their number, because the time of training grows with the product of both.
double most_neurons(std::size_t samples);

/// Rows and columns of an approximately square map of at most so many neurons, and at least one.
std::pair<std::size_t, std::size_t> sides_of(double neurons);

/// The parameters with the training of maps of measured size: `rows` x `columns` neurons that begin
/// on the plane of the principal components, batches over 100 epochs and further ones while the
/// quantization error improves by a thousandth (SomParameters::tolerance), and a radius that falls
/// exponentially from an eighth of the longer side, at least 1, to 0.2. An eighth is that of
/// Vesanto and others (SOM Toolbox, 2000) for such initial weights. Throws InvalidArgument if a
/// side is 0.
SomParameters with_size(SomParameters parameters, std::size_t rows, std::size_t columns);

/// Parameters with a measured size, and what was measured.
struct SizedParameters {
  SomParameters parameters;
  MeasuredSize size;
};

/// `parameters` with the size that measured_size() finds for `samples`, of which at most 2500 are
/// measured, drawn at random, and with_size() for it: an approximately square map of
/// at most most_neurons(). Samples must be complete.
///
/// Errors: the neighbourhood cannot be used in batches (kUsage); elements are missing (kData);
/// those of measured_size().
Result<SizedParameters> sized_by_measurement(const SomParameters& parameters,
                                             const Samples& samples,
                                             const SizeOptions& options = {});

}  // namespace somato
