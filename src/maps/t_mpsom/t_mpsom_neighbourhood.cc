#include "maps/t_mpsom/t_mpsom_neighbourhood.h"

#include <algorithm>

#include "base/core/elementary.h"
#include "base/kernels/t_mpsom_kernels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

double gaussian(std::size_t distance, double sigma) {
  const auto apart = static_cast<double>(distance);
  return exponential(-apart * apart / (2.0 * sigma * sigma));
}

// The farthest distance along an axis at which the Gaussian matters.
std::size_t reach_of(std::size_t extent, double sigma) {
  std::size_t reach = 0;
  while (reach + 1 < extent && gaussian(reach + 1, sigma) >= kernels::kNegligible<float>) ++reach;
  return reach;
}

}  // namespace

GridGaussian::GridGaussian(std::vector<std::size_t> shape, double sigma) {
  require(sigma > 0.0, "GridGaussian: sigma must be above 0");
  for (std::size_t axis = shape.size(); axis-- > 0;) {
    require(shape[axis] > 0, "GridGaussian: every axis needs at least one position");
    if (shape[axis] > 1) axes_.push_back(make_axis(shape[axis], places_, sigma));
    places_ *= shape[axis];
  }
}

GridGaussian::Axis GridGaussian::make_axis(std::size_t extent, std::size_t stride, double sigma) {
  Axis axis{extent, stride, reach_of(extent, sigma), {}};
  const std::size_t middle = axis.reach + kernels::kSpreadGroup;
  axis.factors.resize(2 * middle + 1);
  for (std::size_t distance = 0; distance <= axis.reach; ++distance) {
    const double factor = gaussian(distance, sigma);
    axis.factors[middle - distance] = factor;
    axis.factors[middle + distance] = factor;
  }
  return axis;
}

GridGaussian::Workspace GridGaussian::make_workspace() const {
  std::size_t most = 0;
  for (const Axis& axis : axes_) most = std::max(most, axis.values_at_once());
  return Workspace(most);
}

void GridGaussian::spread(std::span<double> values, Workspace& workspace) const {
  require(values.size() == places_, "GridGaussian: one value per position is required");
  for (const Axis& axis : axes_) spread_along(axis, values, workspace);
}

// Rows along the axis, side by side in memory, are spread at once.
void GridGaussian::spread_along(const Axis& axis, std::span<double> values, Workspace& workspace) {
  require(workspace.size() >= axis.values_at_once(),
          "GridGaussian: the workspace belongs to a smaller grid");
  const kernels::TMpsomTable& kernels = kernels::t_mpsom_table();
  const double* const factors = axis.factors.data() + axis.factors.size() / 2;
  const bool is_line = axis.stride == 1;
  double* const before = workspace.data() + (is_line ? axis.reach : 0);
  if (is_line) std::fill_n(workspace.begin(), axis.values_at_once(), 0.0);
  const std::size_t count = axis.extent * axis.stride;
  for (double* at = values.data(); at != values.data() + values.size(); at += count) {
    std::copy_n(at, count, before);
    if (is_line) {
      kernels.spread_line(before, axis.extent, factors, axis.reach, at);
    } else {
      kernels.spread_rows(before, axis.extent, axis.stride, factors, axis.reach, at);
    }
  }
}

}  // namespace somato
