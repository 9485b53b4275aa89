#pragma once

#include <cstddef>
#include <vector>

#include "somato/maps/grid.h"

namespace somato {

// The measures that the papers derive from a trained map, as counts over the samples' winners:
// `winners[i]` is the neuron of sample i and `classes[i]` its class, numbered from 0. All throw
// InvalidArgument when the two differ in number, when there is no sample, or when a winner is not
// on the grid they get. docs/reference/results.md says which sentence of which paper each stands
// for.

/// For each class up to the greatest number, whether it is separated: it has samples, and no winner
/// of its samples is the winner of a sample of another class. P11's materials "perfectly
/// discriminated" (IV-F).
std::vector<bool> separated_classes(const std::vector<std::size_t>& winners,
                                    const std::vector<std::size_t>& classes);

/// How many samples share their neuron with a sample of another class: of P11's explorations whose
/// "hard/soft category is undetermined" (IV-F).
std::size_t ambiguous_samples(const std::vector<std::size_t>& winners,
                              const std::vector<std::size_t>& classes);

/// For each sample the class that its surroundings on the map stand for: of the other samples whose
/// winners are nearest to its own on the grid (at distance 0 if any; squared distances within 1e-9
/// are equal), the class with most; in a tie the sample's own class if it is among them, else the
/// lowest number. A single sample stands for itself. A sample whose surroundings are of another
/// class is "mapped with" that one (P11, III-B).
std::vector<std::size_t> classes_of_surroundings(const Grid& grid,
                                                 const std::vector<std::size_t>& winners,
                                                 const std::vector<std::size_t>& classes);

/// The share of samples whose winner stands in the first or last row or column; on a torus, which
/// has no border, the same rows and columns, for comparison.
double share_on_border(const Grid& grid, const std::vector<std::size_t>& winners);

/// The share of neurons that stand there: what a map with its samples spread evenly would have.
/// Throws InvalidArgument for a grid without neurons.
double border_of(const Grid& grid);

}  // namespace somato
