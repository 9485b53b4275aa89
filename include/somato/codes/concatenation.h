#pragma once

#include <span>

#include "somato/core/signal.h"

namespace somato {

/// One or more signals, flattened row-major and put one after the other: a vector of as many
/// elements as they have together, as when all 80 proprioceptive elements of system 1 form one
/// vector (P06 section 2.1).
///
/// The result is sparse when all inputs are, otherwise dense: a dense part has to be visited in
/// full anyhow. Stored zeros are kept. Throws InvalidArgument for no input and for more than 2^32 -
/// 1 elements.
Signal concatenation(std::span<const Signal> inputs);

}  // namespace somato
