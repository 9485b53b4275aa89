#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "somato/core/error.h"

namespace somato {

/// A value, or the Error that kept us from it. Returned by whatever depends on files, devices or
/// data.
template <typename T>
using Result = tl::expected<T, Error>;

/// Makes the failed side of any Result.
inline tl::unexpected<Error> fail(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

/// Makes the failed side of any Result from its parts; see Error.
inline tl::unexpected<Error> fail(ErrorKind kind, std::string what, std::string where = {},
                                  std::string advice = {}) {
  return fail(Error{kind, std::move(what), std::move(where), std::move(advice)});
}

}  // namespace somato
