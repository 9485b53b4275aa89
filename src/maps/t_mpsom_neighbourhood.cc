#include "somato/maps/t_mpsom_neighbourhood.h"

#include <algorithm>

#include "core/lanes.h"
#include "somato/core/check.h"
#include "somato/core/elementary.h"

namespace somato {
namespace {

LaneMatrix<double> gaussian_factors(std::size_t extent, double sigma) {
  LaneMatrix<double> factors(extent, extent);
  for (std::size_t u = 0; u < extent; ++u) {
    for (std::size_t v = 0; v < extent; ++v) {
      const double distance = static_cast<double>(u) - static_cast<double>(v);
      factors(u, v) = exponential(-distance * distance / (2.0 * sigma * sigma));
    }
  }
  return factors;
}

}  // namespace

GridGaussian::Workspace::Workspace(const GridGaussian& gaussian) {
  for (const Axis& axis : gaussian.axes_) {
    line.resize(std::max(line.size(), axis.factors.columns()));
    spread_line.resize(std::max(spread_line.size(), axis.factors.padded_rows()));
  }
}

GridGaussian::GridGaussian(std::vector<std::size_t> shape, double sigma) {
  require(sigma > 0.0, "GridGaussian: sigma must be above 0");
  for (std::size_t axis = shape.size(); axis-- > 0;) {
    require(shape[axis] > 0, "GridGaussian: every axis needs at least one place");
    if (shape[axis] > 1) axes_.push_back({gaussian_factors(shape[axis], sigma), places_});
    places_ *= shape[axis];
  }
}

void GridGaussian::spread(std::span<double> values, Workspace& workspace) const {
  require(values.size() == places_, "GridGaussian: one value a place");
  for (const Axis& axis : axes_) spread_along(axis, values, workspace);
}

void GridGaussian::spread_along(const Axis& axis, std::span<double> values, Workspace& workspace) {
  const std::size_t extent = axis.factors.columns();
  require(workspace.line.size() >= extent, "GridGaussian: the workspace is of a smaller grid");
  const kernels::Table<double>& kernels = kernels::table<double>();
  for (std::size_t block = 0; block < values.size(); block += extent * axis.stride) {
    for (std::size_t start = block; start < block + axis.stride; ++start) {
      for (std::size_t i = 0; i < extent; ++i) {
        workspace.line[i] = values[start + i * axis.stride];
      }
      kernels.inner_products(kernels::lanes(axis.factors), workspace.line.data(),
                             workspace.spread_line.data());
      for (std::size_t i = 0; i < extent; ++i) {
        values[start + i * axis.stride] = workspace.spread_line[i];
      }
    }
  }
}

}  // namespace somato
