#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// Saves wholly or not at all (see save_whole); docs/formats/model-file.md describes the file.
Result<void> save_t_mpsom(const std::string& path, const TMpsom& map);

/// The same map, bit by bit. Errors: kSystem for a file that cannot be read, kData for one that is
/// damaged or holds something else.
Result<TMpsom> load_t_mpsom(const std::string& path);

}  // namespace somato
