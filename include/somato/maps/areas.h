#pragma once

#include <cstddef>
#include <vector>

#include "somato/maps/grid.h"

namespace somato {

/// Gives every neuron the class of the nearest winner on the grid. Among winners equally near, the
/// class with most samples at them; then the lowest class number. `winners[i]` and `classes[i]`
/// belong to sample i; throws InvalidArgument when they differ in number or are empty.
std::vector<std::size_t> areas(const Grid& grid, const std::vector<std::size_t>& winners,
                               const std::vector<std::size_t>& classes);

/// Whether the neurons of each class that occurs in `area_of_neuron` form one region, connected
/// through shared edges.
bool areas_connected(const Grid& grid, const std::vector<std::size_t>& area_of_neuron);

/// Whether each class that has samples is one connected region of its area; false too when a class
/// has no area left, its winners being shared with a more frequent class.
bool classes_connected(const Grid& grid, const std::vector<std::size_t>& winners,
                       const std::vector<std::size_t>& classes);

/// Whether no neuron is the winner for samples of two classes.
bool individuals_apart(const std::vector<std::size_t>& winners,
                       const std::vector<std::size_t>& classes);

}  // namespace somato
