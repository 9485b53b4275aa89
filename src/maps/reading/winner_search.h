#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "maps/reading/screened_map.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// The search for the winners of many dense samples at once. The winner is the argmin of distances
/// (argmax of inner products) in double precision, the first neuron in a tie, as Som::winner finds.
/// Refers to the map, which must not change meanwhile.
class WinnerSearch {
 public:
  /// The winners of all samples, or the two most similar neurons of each, by whatever way is
  /// fastest. The samples are as the map sees them: seen_samples().
  /// Without `skip`, every neuron is looked at for every sample: the same winners, and what
  /// skipping is measured against.
  static std::vector<Winners> find_all(const Som& som, const Samples& seen, bool two,
                                       std::size_t threads, bool skip = true);

 private:
  WinnerSearch(const Som& som, std::size_t threads);

  // Whether preparing a map pays for so many samples.
  static bool pays(const Som& som, const Samples& samples);

  // Finds the winners of samples begin, begin + 1, ..., one for each place of `found`.
  void find(const Samples& seen, std::size_t begin, bool two, bool skip,
            std::span<Winners> found) const;

  const Som& som_;
  ScreenedMap map_;
};

/// The normalized samples: of length 1 if the map normalizes its input, with its stored elements
/// only. `samples` itself, or `storage`.
const Samples& seen_samples(const Som& som, const Samples& samples, Samples& storage);

/// The winner of each.
std::vector<std::size_t> winners_of_seen(const Som& som, const Samples& seen, std::size_t threads);
}  // namespace somato
