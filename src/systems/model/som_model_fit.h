#pragma once

#include <string>

#include "somato/graph/som_model.h"

namespace somato {

/// The reason why the parts of a model do not fit each other, so that it could be saved but not be
/// loaded; empty if they do.
std::string misfit_of(const SomModel& model);

}  // namespace somato
