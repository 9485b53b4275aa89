#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace somato {

/// The most dimensions of a Sobol' point.
inline constexpr std::size_t kSobolDimensions = 32;

/// Point number `index` of Sobol's sequence, from 0: one number in [0, 1) per dimension, a multiple
/// of 2^-32, not scrambled. The points are in their natural order (not in that of the Gray code):
/// the first dimension is the van der Corput sequence, and the first 2^m points have exactly one in
/// each of the 2^m equal parts of every dimension.
///
/// Direction numbers: S. Joe and F. Y. Kuo, "Constructing Sobol' sequences with better
/// two-dimensional projections", SIAM J. Sci. Comput. 30 (2008), their table new-joe-kuo-6.
/// Recurrence: P. Bratley and B. L. Fox, "Algorithm 659", ACM TOMS 14 (1988). Throws
/// InvalidArgument for more than kSobolDimensions.
std::vector<double> sobol_point(std::uint32_t index, std::size_t dimensions);

}  // namespace somato
