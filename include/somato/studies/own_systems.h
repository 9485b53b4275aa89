#pragma once

#include <vector>

#include "somato/core/result.h"
#include "somato/studies/reproduction_plan.h"

namespace somato {

/// The files that travel with the library: those of `systems/`.
struct OwnSystems {
  std::vector<NamedFile> systems;    ///< The papers' nine, for the bodies that are simulated.
  std::vector<NamedFile> recorded;   ///< The same, where they apply, for data sets of others.
  std::vector<NamedFile> questions;  ///< Side questions about the nine.
};

/// Reads them; their names are those of the files. The nine stand in the order of the papers.
Result<OwnSystems> own_systems();

}  // namespace somato
