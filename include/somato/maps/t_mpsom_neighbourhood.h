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
/// Gaussian an axis, so the sum over all pairs of places is one pass along each axis.
///
/// Along each axis a Gaussian below 1e-18 (beyond 9.1 sigma) is taken as zero. So only pairs whose
/// Gaussian is below 1e-18 are left out, and a value is off by less than 1e-18 times the sum of all
/// |values|.
class GridGaussian {
 public:
  /// Scratch memory for spread(), for one thread.
  struct Workspace {
    explicit Workspace(const GridGaussian& gaussian);
    AlignedVector<double> values;  // those along an axis, as they were
  };

  GridGaussian() = default;

  /// `shape`: places along each axis, at least 1 each; `sigma` in places, above 0.
  GridGaussian(std::vector<std::size_t> shape, double sigma);

  /// Replaces `values`, one a place in row-major order, by their spread. Does not allocate. Throws
  /// InvalidArgument when there is not one value a place, or the workspace is of a smaller grid.
  void spread(std::span<double> values, Workspace& workspace) const;

 private:
  // Places along one axis, how far apart in memory neighbours along it are, how many places the
  // Gaussian reaches, and its values: distance 0 in the middle, zeros beyond its reach.
  struct Axis {
    std::size_t extent = 1;
    std::size_t stride = 1;
    std::size_t reach = 0;
    std::vector<double> factors;

    // The places of neighbouring lines; a single line has zeros around it.
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
