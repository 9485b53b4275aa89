#pragma once

#include <cstddef>

#include "base/kernels/kernels.h"
#include "somato/core/matrix.h"

namespace somato {

/// The rows of a block of a LaneMatrix.
inline constexpr std::size_t kFloatLanes = LaneMatrix<float>::kLanes;
inline constexpr std::size_t kDoubleLanes = LaneMatrix<double>::kLanes;

}  // namespace somato

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
