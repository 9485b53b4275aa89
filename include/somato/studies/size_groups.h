#pragma once

#include <cstddef>
#include <vector>

#include "somato/studies/most_similar.h"

namespace somato {

/// Small and large individuals of each group as classes: those with a number below that of the
/// group's median individual are small (class 2 * group), the others large (2 * group + 1). The
/// median individual is the middle one in the order of the numbers, of an even number the upper of
/// the two: of five, two are small and three large. Equal numbers are never parted, so where the
/// lower half equals the median all are large. A class for each individual, in their order.
///
/// P11 (III-B, Fig. 6b) tells small and large cylinders and blocks apart on its map but not how
/// many objects it counts as small: the median is ours. Throws InvalidArgument for a number that is
/// not finite.
std::vector<std::size_t> size_groups(const std::vector<NumberedIndividual>& individuals);

}  // namespace somato
