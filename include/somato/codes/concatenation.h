#pragma once

#include <span>

#include "somato/core/signal.h"

namespace somato {

/// One or more signals, flattened row-major and concatenated: the number of elements is the sum of
/// theirs, as when the 80 proprioceptive elements of system 1 form one vector (P06 section 2.1).
///
/// The result is sparse if all inputs are, otherwise dense: a dense part must be visited completely
/// in any case. Stored zeros are kept. Throws InvalidArgument without inputs and for more than 2^32
/// - 1 elements.
Signal concatenation(std::span<const Signal> inputs);

/// The same, flat, into `out`, which must not be among the inputs. Does not allocate if `out` is
/// large enough.
void concatenation(std::span<const SignalView> inputs, SignalBuffer& out);

}  // namespace somato
