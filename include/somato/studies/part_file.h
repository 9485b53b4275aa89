#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "somato/studies/reproduction.h"

namespace somato {

/// What came of a part, as the content of a file that is kept until it is needed: one line with a
/// checksum. Settings and runs are left out.
std::string part_file(const PartResults& part);

/// What such a file holds; nothing where it is cut or damaged.
std::optional<PartResults> read_part_file(std::string_view content);

}  // namespace somato
