#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/archives/archive.h"
#include "somato/core/result.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// Whether all are from 1e-12 to 1e12, so that no product with an input of the usual size leaves
/// the range of single precision.
bool are_relevances(std::span<const double> relevances);

/// Som::input_scales() of these parameters; empty without relevances.
std::vector<float> scales_of_relevances(const SomParameters& parameters);

/// Adds the relevances to an archive; nothing without relevances.
void add_relevances(Archive& archive, const std::string& name, const SomParameters& parameters);

/// The relevances that add_relevances() added, for a map of these parameters and so many elements;
/// none if the archive has none. Errors (kData, at `where`): damaged, or not possible.
Result<std::vector<double>> relevances_from(const Archive& archive, const std::string& name,
                                            const SomParameters& parameters, std::size_t elements,
                                            const std::string& where);

}  // namespace somato
