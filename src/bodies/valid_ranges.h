#pragma once

#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato::detail {

/// Whether every parameter lies in its declared range, whoever filled the struct. Errors (kUsage)
/// name the first that does not.
template <typename S>
Result<void> check_ranges(const S& parameters) {
  S copy;
  for (const Parameter<S>& parameter : S::declarations().all()) {
    auto assigned = parameter.assign(copy, parameter.read(parameters));
    if (!assigned) return assigned;
  }
  return {};
}

}  // namespace somato::detail
