#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// Convolves values on a rectangular grid with a Gaussian of the Euclidean distance between
/// positions:
///
///     out_p = sum over q of values_q exp(-|p - q|^2 / (2 sigma^2))
///
/// This is N' of a T-MPSOM (P06 section 4.1, P11 section II). The Gaussian is the product of one
/// Gaussian per axis, so the sum over all pairs of positions is one pass along each axis.
///
/// Along each axis a Gaussian below 1e-18 (beyond 9.1 sigma) is treated as zero. Only pairs whose
/// Gaussian is below 1e-18 are therefore omitted, and the error of a value is less than 1e-18 times
/// the sum of all |values|.
class GridGaussian {
 public:
  /// Scratch memory for spread(), for one thread: the values along an axis before the pass.
  using Workspace = AlignedVector<double>;

  GridGaussian() = default;

  /// `shape`: number of positions along each axis, at least 1 each; `sigma` in positions, above 0.
  GridGaussian(std::vector<std::size_t> shape, double sigma);

  Workspace make_workspace() const;

  /// Replaces `values`, one per position in row-major order, by the convolved values. Does not
  /// allocate. Throws InvalidArgument unless there is one value per position, or if the workspace
  /// belongs to a smaller grid.
  void spread(std::span<double> values, Workspace& workspace) const;

 private:
  // Number of positions along one axis, stride of neighbours along it, number of positions in the
  // range of the Gaussian, and its values: distance 0 in the middle, zeros beyond the range.
  struct Axis {
    std::size_t extent = 1;
    std::size_t stride = 1;
    std::size_t reach = 0;
    std::vector<double> factors;

    // Number of positions of neighbouring lines; a single line is surrounded by zeros.
    std::size_t values_at_once() const {
      return stride == 1 ? extent + 2 * reach : extent * stride;
    }
  };

  static Axis make_axis(std::size_t extent, std::size_t stride, double sigma);
  static void spread_along(const Axis& axis, std::span<double> values, Workspace& workspace);

  std::size_t places_ = 1;
  std::vector<Axis> axes_;
};

}  // namespace somato
