#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// One epoch of batch training: every weight becomes the mean of all samples, each weighted by the
/// neighbourhood function around its winner; a neuron that no winner reaches keeps its weights. The
/// map gets weights for all elements when the samples have one that it has not.
/// Returns the samples' winners before the epoch.
std::vector<std::size_t> batch_epoch(Som& som, const Samples& samples, double radius,
                                     std::size_t threads);

/// The winner of each sample, computed on `threads` threads.
std::vector<std::size_t> winners_of(const Som& som, const Samples& samples, std::size_t threads);

}  // namespace somato
