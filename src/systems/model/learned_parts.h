#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "somato/codes/standardization.h"
#include "somato/graph/system.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

// The learned values of modules other than the maps of som_of(). The module is counted in the order
// of the description, and must be trained if it learns.

/// A copy of the T-MPSOM of a module; nothing when it is none.
std::optional<TMpsom> t_mpsom_of(const System& system, std::size_t module);

/// The means and deviations of a standardization; nothing when it is none.
std::optional<Standardization> standardization_of(const System& system, std::size_t module);

/// The range of a one-hot code for each element that comes in, in its unit; nothing when the module
/// is none.
std::optional<std::vector<std::pair<double, double>>> one_hot_ranges_of(const System& system,
                                                                        std::size_t module);

}  // namespace somato
