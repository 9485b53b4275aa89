#include "base/text/format_version.h"

#include <fmt/format.h>

#include <utility>

namespace somato {

tl::unexpected<Error> unsupported_format(std::uint64_t found, std::uint64_t supported,
                                         std::string where, std::string for_earlier) {
  const bool newer = found > supported;
  return fail(ErrorKind::kData,
              fmt::format("written by {} version of Somato (format {}, supported is {})",
                          newer ? "a newer" : "an earlier", found, supported),
              std::move(where), newer ? "update Somato" : std::move(for_earlier));
}

}  // namespace somato
