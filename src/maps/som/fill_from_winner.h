#pragma once

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// Whether the winner among the neurons of `som` is defined for inputs of which some elements are
/// missing. Errors (kUsage): maps by inner products, and maps that scale inputs to length 1, which
/// is not known of such an input.
Result<void> check_takes_incomplete(const Som& som);

/// The samples, dense, with each missing element (NaN) replaced by the weight that the sample's
/// winner has for it. The winner is the neuron with the least Euclidean distance over the elements
/// that are known, in double precision, the first one in a tie; it is the winner of the filled
/// sample too, at the same distance.
/// `som` must pass check_takes_incomplete(); throws InvalidArgument when the sizes differ.
/// Source: Samad and Harp, "Self-organization with partial data", Network 3, 1992, who find the
/// winner by the known elements.
Samples filled_from_winners(const Som& som, const Samples& samples);

}  // namespace somato
