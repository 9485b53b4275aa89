#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// A table of things, drawn from a recording of more.
struct ThingSelection {
  std::vector<std::string> things;  ///< In their order; empty: all, in that of the recording.
  std::optional<std::size_t> each;  ///< The first explorations of each; all by default.
};

/// The explorations of these things: object after object, each in the order of the recording. A
/// thing is named by the label `object`, or by `material` in recordings without objects. Errors
/// (kUsage): an unknown thing, with the nearest known one, a thing that is named twice, and one
/// with fewer explorations than `each`; kData for a recording with neither label.
Result<Recording> select_things(Recording recording, const ThingSelection& selection);

}  // namespace somato
