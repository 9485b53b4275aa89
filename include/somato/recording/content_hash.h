#pragma once

#include <string>

#include "somato/recording/recording.h"

namespace somato {

/// A short text that differs when the recording does: `fnv1a64:` and 16 hexadecimal digits over all
/// labels, channels and values. Where the explorations came from does not count. Not a protection
/// against somebody who wants two recordings to look alike.
std::string content_hash(const Recording& recording);

}  // namespace somato
