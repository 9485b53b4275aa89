#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/graph/system_model.h"
#include "somato/maps/labels.h"
#include "somato/recording/recording.h"

namespace somato {

/// Options of further learning.
struct FurtherLearning {
  std::uint64_t seed = 1;   ///< The seed of the draws.
  Progress progress = {};   ///< In draws.
  std::size_t threads = 1;  ///< Does not affect the result.
  /// The class of each input, for a map that learns names; empty: none. The names of explorations
  /// of a recording are used in their place.
  std::vector<std::size_t> classes = {};
};

/// Lets the map of a trained system learn `inputs`, one per exploration, in addition to what it has
/// learned, with as many draws as in a training on `inputs` only. All other modules remain as they
/// are. A system that was saved and loaded learns as if it had not been. Returns the origins of the
/// neurons, to which names must be moved.
///
/// If learning fails, the map is unchanged. Errors: those of train_system(). Throws InvalidArgument
/// if the module is not a trained map, or for inputs of another size.
Result<NeuronOrigins> learn_further(System& system, std::size_t map, const Samples& inputs,
                                    const FurtherLearning& options = {});

/// Lets a trained system learn explorations of a recording in addition to what it has learned, with
/// their names: the output map learns their inputs, then each exploration votes for the value of
/// its label at the neuron that it wins. No exploration occurs twice. New names become new classes.
/// Votes of earlier explorations stay with their neurons; those of removed neurons are lost.
///
/// If learning fails, the model is unchanged. Errors: those of train_system(), and kUsage if an
/// exploration does not have the label of the model's answer. Throws InvalidArgument if the model
/// has no answer, or if an exploration occurs twice.
Result<void> learn_further(SystemModel& model, const Recording& recording,
                           std::span<const std::size_t> explorations,
                           const FurtherLearning& options = {});

/// The result of teaching a model the name of one exploration.
struct Taught {
  std::string before;  ///< The name that the model answered before; may be "unknown".
  std::optional<std::size_t> neuron = {};  ///< The neuron of the output map that has the input of
                                           ///< the exploration as weights now; none if the name was
                                           ///< known.
};

/// Teaches a trained model the name of an exploration of a recording, after which the model answers
/// this name for it. If it did already, the exploration is a further vote for the neuron that named
/// it. Otherwise one neuron of the output map receives the map's input: a new one if the map can
/// add one, or else the most similar neuron without a name. A neuron that has this input already
/// takes over the name.
///
/// All other neurons keep their weights and names, so that the answer changes only for inputs that
/// are nearer to this neuron than to all others. A new name becomes a new class, with the mean
/// scale of the others for unknown inputs. Not given in the papers.
///
/// If teaching fails, the model is unchanged. Errors: kUsage for the name "unknown" or "", and if
/// all neurons have names and the map cannot add one; those of evaluate(). Throws InvalidArgument
/// if the model has no answer.
Result<Taught> teach(SystemModel& model, const Recording& recording, std::size_t exploration,
                     const std::string& name);

/// The same for an input of the output map.
Result<Taught> teach(SystemModel& model, const SignalView& input, const std::string& name);

}  // namespace somato
