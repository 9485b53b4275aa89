#pragma once

#include <string>

#include "somato/recording/recording.h"

namespace somato {

/// A short text that differs if the recording does: `fnv1a64:` and 16 hexadecimal digits over all
/// labels, channels and values. The sources of the explorations are not included. It does not
/// protect against deliberate manipulation.
std::string content_hash(const Recording& recording);

}  // namespace somato
