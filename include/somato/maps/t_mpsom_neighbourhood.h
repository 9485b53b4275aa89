#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/lane_matrix.h"

namespace somato {

/// Spreads values over a rectangular grid by a Gaussian of the Euclidean distance between places:
///
///     out_p = sum over q of values_q exp(-|p - q|^2 / (2 sigma^2))
///
/// This is N' of a T-MPSOM (P06 section 4.1, P11 section II). The Gaussian is the product of one
/// Gaussian an axis, so the sum over all pairs of places is one pass along each axis; nothing is
/// cut off.
class GridGaussian {
 public:
  /// Scratch memory for spread(), for one thread.
  struct Workspace {
    explicit Workspace(const GridGaussian& gaussian);
    std::vector<double> line;
    AlignedVector<double> spread_line;
  };

  GridGaussian() = default;

  /// `shape`: places along each axis, at least 1 each; `sigma` in places, above 0.
  GridGaussian(std::vector<std::size_t> shape, double sigma);

  /// Replaces `values`, one a place in row-major order, by their spread. Does not allocate. Throws
  /// InvalidArgument when there is not one value a place, or the workspace is of a smaller grid.
  void spread(std::span<double> values, Workspace& workspace) const;

 private:
  // exp(-(u - v)^2 / (2 sigma^2)) for all places u and v along one axis, and how far apart in
  // memory neighbours along this axis are.
  struct Axis {
    LaneMatrix<double> factors;
    std::size_t stride = 1;
  };

  static void spread_along(const Axis& axis, std::span<double> values, Workspace& workspace);

  std::size_t places_ = 1;
  std::vector<Axis> axes_;
};

}  // namespace somato
