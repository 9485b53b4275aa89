#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/studies/reproduction.h"

namespace somato {

/// The results of a part, as the content of a cache file: one line with a checksum. Data that a
/// sweep does not use are omitted: the study and its parameters, runs, and the recordings except
/// their names.
std::string part_file(const PartResults& part);

/// The content of such a file, named `where`; nothing if it is truncated or damaged. Errors: kData
/// if another version of Somato wrote it in another format.
Result<std::optional<PartResults>> read_part_file(std::string_view content,
                                                  const std::string& where);

}  // namespace somato
