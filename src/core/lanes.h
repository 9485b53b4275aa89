#pragma once

#include "core/kernels.h"
#include "somato/core/lane_matrix.h"

namespace somato::kernels {

/// A LaneMatrix as the kernels take it.
template <typename Real>
Lanes<const Real> lanes(const LaneMatrix<Real>& matrix) {
  return {matrix.data(), matrix.blocks(), matrix.columns()};
}

template <typename Real>
Lanes<Real> lanes(LaneMatrix<Real>& matrix) {
  return {matrix.data(), matrix.blocks(), matrix.columns()};
}

}  // namespace somato::kernels
