#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/signal.h"

namespace somato {

/// Which norm a normalized vector has as 1. The papers normalize inputs but do not name the norm
/// (P06 section 1).
enum class Norm {
  kNone,     ///< The vector stays as it is.
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

/// Divides `values` by their norm; a zero vector stays zero.
void normalize(Norm norm, std::span<float> values);

/// `signal` divided by its norm, dense or sparse as it was.
Signal normalized(Norm norm, Signal signal);

}  // namespace somato
