#pragma once

#include <optional>

#include "somato/codes/normalization.h"
#include "somato/graph/module.h"

namespace somato::modules {

/// Whether the module gives the sum of all frames so far.
bool adds_frames(const Module& module);

/// The norm by which the module divides its input; nothing for any other module.
std::optional<Norm> norm_divided_by(const Module& module);

}  // namespace somato::modules
