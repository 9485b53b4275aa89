#pragma once

#include <set>
#include <string>

#include "base/archives/archive.h"
#include "somato/core/result.h"

namespace somato {

/// Checks that an archive holds a model of that kind and no part but those in `known`; errors
/// (kData, at `where`).
Result<void> check_kind(const Archive& archive, const std::string& kind, const std::string& where);
Result<void> check_parts(const Archive& archive, const std::set<std::string>& known,
                         const std::string& where);

}  // namespace somato
