#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// The choice of what is read for each sample besides its winner.
struct ReadingChoice {
  bool second = false;    ///< The second most similar neuron.
  bool distance = false;  ///< The distance from the winner.
};

/// The readings of many samples, in their order.
struct SampleReadings {
  std::vector<Winners> winners;      ///< The second one only if it was chosen.
  std::vector<double> distances;     ///< From the winners; empty unless they were chosen.
  std::vector<std::size_t> nearest;  ///< The most similar candidates; empty without candidates.
};

/// Reads many samples from a map at once: their winners, and the most similar neurons among
/// candidates, for example among those with labels. The results are those of Som::winners(),
/// Som::distance() and Som::winner_among() for each sample, bit by bit, for any number of threads.
/// Refers to the map, which must not change meanwhile. For one thread at a time.
class SampleReader {
 public:
  /// `candidates` are ascending neurons of the map; without any, nothing is read among them. Throws
  /// InvalidArgument if there is no such neuron.
  explicit SampleReader(const Som& som, std::size_t threads = 1,
                        std::vector<std::size_t> candidates = {});

  /// Reads the samples by the weights of the map. Throws InvalidArgument if their size differs from
  /// that of the map's inputs.
  SampleReadings read(const Samples& samples, ReadingChoice choice = {});

  /// Reads the samples at `places`, by inner products if the map knows() the samples, otherwise by
  /// its weights.
  SampleReadings read(const Samples& samples, std::span<const std::size_t> places,
                      ReadingChoice choice = {});

 private:
  SampleReadings read_known(const Samples& samples, std::span<const std::size_t> places,
                            ReadingChoice choice) const;
  std::vector<double> distances(const Samples& samples, const std::vector<Winners>& winners) const;
  std::vector<std::size_t> nearest(const Samples& seen, const std::vector<Winners>& winners);
  std::vector<std::size_t> nearest_by_search(const Samples& seen);
  bool is_candidate(std::size_t neuron) const { return is_candidate_[neuron]; }

  const Som& som_;
  std::size_t threads_;
  std::vector<std::size_t> candidates_;
  std::vector<bool> is_candidate_;        // of each neuron
  std::optional<Som> map_of_candidates_;  // once it has been needed
};

/// Writes the activity of all neurons for each sample, as Som::activity() does, one row after the
/// other: `out` has samples x neurons values. Throws InvalidArgument if a size differs.
void read_activity(const Som& som, const Samples& samples, std::size_t threads,
                   std::span<float> out);

/// The winner of each sample, without the others.
std::vector<std::size_t> first_winners(const SampleReadings& readings);

}  // namespace somato
