#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

// A trained map can be refined with the labels of its samples: its neurons move so that samples are
// nearer to neurons of their class than to others. The map answers more samples correctly, and
// loses some of its order. The papers of this project's systems do not refine maps.

/// The method that moves the neurons of a trained map by labels.
enum class Refinement {
  kNone,   ///< The map stays as training without labels made it.
  kGlvq,   ///< Generalized learning vector quantization.
  kGrlvq,  ///< The same with relevances of the elements, which it also learns.
};

template <>
struct Choices<Refinement> {
  static const std::vector<std::pair<Refinement, std::string>>& all();
};

/// The parameters of a refinement. declarations() gives the meaning, unit and range of each.
struct RefinementParameters {
  Refinement refine = Refinement::kNone;
  std::uint64_t refine_passes = 30;
  double refine_learning_rate = 0.1;
  double refine_steepness_start = 2.0;
  double refine_steepness_end = 30.0;
  double refine_neighbours = 0.3;
  double refine_relevance_rate = 0.03;

  static const Declarations<RefinementParameters>& declarations();
};

/// Why the parameter `name` has no effect with the other ones; empty if it has an effect.
std::string reason_without_effect(const RefinementParameters& parameters, std::string_view name);

/// Measures of the order of a map for samples, as in SomMeasure. Trustworthiness and continuity
/// compare 5 neighbours of each sample, of 500 random samples if there are more; NaN unless there
/// are more than 10 samples.
struct MapOrder {
  double quantization_error = 0.0;
  double topographic_error = 0.0;
  double trustworthiness = 0.0;
  double continuity = 0.0;
};

/// The measured effect of a refinement on the order of a map.
struct RefinedOrder {
  MapOrder before;
  MapOrder after;
  std::size_t named_by_nearest = 0;  ///< Neurons that won no sample, and took the nearest's class.
  std::size_t classes_without_neuron = 0;  ///< Classes whose samples had no effect.
};

/// A refined map and its order.
struct RefinedSom {
  Som som;
  RefinedOrder order;
};

/// Options of a refinement.
struct RefinementOptions {
  std::uint64_t seed = 1;   ///< Determines the order of the samples.
  std::size_t threads = 1;  ///< Does not affect the map.
  Progress progress = {};   ///< In samples of all passes.
};

/// Refuses (kUsage) a map whose distance the method does not know: it must be Euclidean or
/// Manhattan, without layers. Nothing is refused without a refinement.
Result<void> check_refinement(const RefinementParameters& parameters, const SomParameters& som);

/// Moves the neurons of a trained map by generalized learning vector quantization: Sato and Yamada,
/// "Generalized learning vector quantization", NIPS 8, 1996. docs/mathematics/refinement.md gives
/// the equations, and what differs from the paper.
///
/// Each neuron has the class that most of its samples have (NeuronLabels::by_majority()), and a
/// neuron that wins no sample that of the sample nearest to it: it would otherwise stay where it
/// is, and could win samples that other neurons have been pushed away from. `refine_passes` times,
/// all samples come in a new random order. Each moves the nearest neuron of its class towards
/// itself, together with the adjacent neurons that have the same class, and the nearest neuron of
/// another class away. With `refine = "grlvq"` the same samples also change how much each element
/// counts in the distance, which begins alike (Som::set_relevances()): Hammer and Villmann,
/// "Generalized relevance learning vector quantization", Neural Networks 15, 2002.
///
/// `classes[i]` is the class of sample i, or none: it is then not learned. Samples need not be
/// those of the training; elements of dense ones may be missing (NaN) and then have no effect, for
/// maps that do not scale their inputs. The same input gives the same bits for every number of
/// threads, instruction set and compiler.
///
/// The errors of the order after "grlvq" are those of its distance.
///
/// A map of `refine = "none"` is returned as it is, with its order in both places. Errors: those of
/// check_refinement(); kData if fewer than two classes have samples, or if samples are out of the
/// range of single precision; kSystem if memory does not suffice; kInterrupted. Throws
/// InvalidArgument if sizes differ, or a parameter is out of its range.
Result<RefinedSom> refine_som(const Som& som, const Samples& samples,
                              const std::vector<std::optional<std::size_t>>& classes,
                              const RefinementParameters& parameters,
                              const RefinementOptions& options = {});

}  // namespace somato
