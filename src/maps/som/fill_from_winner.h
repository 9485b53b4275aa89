#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// Whether an element of dense samples is missing (NaN); sparse ones have none.
bool has_missing(const Samples& samples);

/// Whether the winner among the neurons of `som` is defined for inputs of which some elements are
/// missing: for distances that are sums or maxima over elements. Errors (kUsage): maps by inner
/// products or cosine distances, and maps that scale inputs to length 1, which is not known of such
/// an input.
Result<void> check_takes_incomplete(const Som& som);

/// The samples, dense, with each missing element (NaN) replaced by the weight that the sample's
/// winner has for it. The winner is the neuron with the least distance (of the map's similarity)
/// over the elements that are known, in double precision, the first one in a tie; it is the winner
/// of the filled sample too, at the same distance. `som` must pass check_takes_incomplete(); throws
/// InvalidArgument when the sizes differ. Source: Samad and Harp, "Self-organization with partial
/// data", Network 3, 1992, who find the winner by the known elements.
Samples filled_from_winners(const Som& som, const Samples& samples);

/// These winners of dense samples; `som` stores all elements. By `threads` threads.
std::vector<std::size_t> winners_by_known(const Som& som, const Samples& samples,
                                          std::size_t threads);

}  // namespace somato
