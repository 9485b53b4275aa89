#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/archives/archive.h"
#include "somato/core/result.h"
#include "somato/maps/novelty.h"

namespace somato {

/// Puts a threshold for unknown inputs into the archive of a system.
void add_novelty(Archive& archive, const Novelty& novelty);

/// The threshold in the archive, if it has one, for so many classes and elements of the
/// map's input. Errors (kData, at `where`): a
/// missing part, other sizes, values out of range.
Result<std::optional<Novelty>> novelty_from(const Archive& archive, std::size_t classes,
                                            std::size_t elements, const std::string& where);

}  // namespace somato
