#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/signal.h"

namespace somato {

/// The norm that is 1 for a normalized vector. The papers normalize inputs but do not specify the
/// norm (P06 section 1).
enum class Norm {
  kNone,     ///< The vector is unchanged.
  kL2,       ///< The root of the sum of squares.
  kL1,       ///< The sum of magnitudes.
  kMaximum,  ///< The largest magnitude.
};

template <>
struct Choices<Norm> {
  static const std::vector<std::pair<Norm, std::string>>& all();
};

/// The norm of `values`, summed in their order in double precision; 1 for kNone.
double norm_of(Norm norm, std::span<const float> values);

/// Divides `values` by their norm; a zero vector is unchanged.
void normalize(Norm norm, std::span<float> values);

/// `signal` divided by its norm, dense or sparse as before.
Signal normalized(Norm norm, Signal signal);

}  // namespace somato
