#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/graph/system_model.h"
#include "somato/maps/contributions.h"

namespace somato {

/// The elements to which contributions are traced back: those of a channel that a system reads, or
/// of the output of a module that cannot be traced further.
struct ContributionSource {
  std::string name;                ///< Name of the channel or the module.
  bool is_channel = false;         ///< Whether it is a channel.
  std::vector<std::size_t> shape;  ///< Shape of its frames, or of its output.

  /// The numbers of the elements among those of that shape, from 0, ascending.
  std::vector<std::size_t> places;

  /// Their names; those without are numbered from 1 by their places.
  std::vector<std::string> elements;
};

/// The contributions of channels to the answer for an input. They are positive where the input
/// is more similar to the neuron that answers, and negative where it is more similar to the nearest
/// neuron of another class.
struct InputContributions {
  DecidingNeurons neurons;
  std::size_t nearest = 0;  ///< The class of the answer.
  std::size_t other = 0;    ///< The class of the other neuron.
  double of_nearest = 0.0;  ///< As Contributions.
  double of_other = 0.0;    ///< As Contributions.

  /// One for each element of each source; they sum to the difference of the distances.
  std::vector<std::vector<double>> values;
};

/// Traces the contributions of the elements of a map's input (see contributions()) through a
/// trained system back to the channels. Modules preserve their sum:
///
/// - `concatenation`: each input receives those of its elements.
/// - `tensor_product`: each factor of an element receives an equal share of its contribution. An
///   element is 0 unless all its factors are there, so that this is also their Shapley value.
/// - `one_hot`, `number_code`, `spectrum`, `resampling`: those of all bins, digits, bands or points
///   of an element are summed.
/// - Memories, `first`, `last`, `mean`, `change`, `tare`, `delay`, filters, windows, `scale`,
///   `logarithm`, `standardization` and `normalization` pass them on to the same element.
///
/// They end at any other module: a T-MPSOM, another map, an association, a loop; and at the map's
/// input if more than 256 paths lead back from it. Contributions that reach the same element of a
/// channel on several paths are summed.
class ContributionReader {
 public:
  /// Errors (kData): those of answering_map(); fewer than two classes have a neuron.
  static Result<ContributionReader> build(std::shared_ptr<const SystemModel> model);

  /// Channels in the order of their first use, then modules.
  const std::vector<ContributionSource>& sources() const;

  /// The unit of all contributions: that of the channels if all of them have the same, no module
  /// has changed it, and the distance is in the unit of its elements; otherwise empty.
  const std::string& unit() const;

  /// The map whose neurons decide.
  const Som& som() const;

  /// The neurons that decide for inputs of the map, for any number of threads.
  std::vector<DecidingNeurons> deciding(const Samples& inputs, std::size_t threads = 1) const;

  /// The contributions to the decision between two neurons with labels.
  InputContributions read(const SignalView& input, DecidingNeurons neurons) const;

  /// Those to the answer for an input.
  InputContributions read(const SignalView& input) const;

  /// The same for each of many inputs, for any number of threads.
  std::vector<InputContributions> read(const Samples& inputs, std::size_t threads = 1) const;

 private:
  struct Tracing;

  explicit ContributionReader(std::shared_ptr<const Tracing> tracing);

  std::shared_ptr<const Tracing> tracing_;
};

}  // namespace somato
