#pragma once

#include <cstdint>
#include <string>

#include "somato/core/result.h"

namespace somato {

/// The refusal (kData) of the file `where`, whose format has the version `found`, by a reader of
/// the version `supported`. A later version advises to update Somato, an earlier one `for_earlier`.
tl::unexpected<Error> unsupported_format(std::uint64_t found, std::uint64_t supported,
                                         std::string where, std::string for_earlier);

}  // namespace somato
