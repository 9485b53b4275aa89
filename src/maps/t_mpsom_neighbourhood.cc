#include "somato/maps/t_mpsom_neighbourhood.h"

#include <algorithm>
#include <array>

#include "core/kernels.h"
#include "somato/core/check.h"
#include "somato/core/elementary.h"

namespace somato {
namespace {

constexpr std::size_t kLanes = LaneMatrix<double>::kLanes;

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

// Up to kLanes lines along an axis, one a lane.
class Lines {
 public:
  // From number `first` of `all` lines.
  Lines(std::size_t first, std::size_t all, std::size_t extent, std::size_t stride)
      : count_(std::min(kLanes, all - first)), extent_(extent), stride_(stride) {
    for (std::size_t lane = 0; lane < count_; ++lane) {
      const std::size_t line = first + lane;
      starts_[lane] = line / stride * stride * extent + line % stride;
    }
  }

  void gather(const double* values, double* lanes) const {
    for (std::size_t lane = 0; lane < count_; ++lane) {
      const double* from = values + starts_[lane];
      for (std::size_t i = 0; i < extent_; ++i) lanes[i * kLanes + lane] = from[i * stride_];
    }
  }

  void scatter(const double* lanes, double* values) const {
    for (std::size_t lane = 0; lane < count_; ++lane) {
      double* to = values + starts_[lane];
      for (std::size_t i = 0; i < extent_; ++i) to[i * stride_] = lanes[i * kLanes + lane];
    }
  }

 private:
  std::size_t count_;
  std::size_t extent_;
  std::size_t stride_;
  std::array<std::size_t, kLanes> starts_{};
};

}  // namespace

GridGaussian::Workspace::Workspace(const GridGaussian& gaussian) {
  std::size_t longest = 0;
  for (const Axis& axis : gaussian.axes_) longest = std::max(longest, axis.extent);
  lines.resize(longest * kLanes);
  spread_lines.resize(longest * kLanes);
}

GridGaussian::GridGaussian(std::vector<std::size_t> shape, double sigma) {
  require(sigma > 0.0, "GridGaussian: sigma must be above 0");
  for (std::size_t axis = shape.size(); axis-- > 0;) {
    require(shape[axis] > 0, "GridGaussian: every axis needs at least one place");
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

void GridGaussian::spread(std::span<double> values, Workspace& workspace) const {
  require(values.size() == places_, "GridGaussian: one value a place");
  for (const Axis& axis : axes_) spread_along(axis, values, workspace);
}

void GridGaussian::spread_along(const Axis& axis, std::span<double> values, Workspace& workspace) {
  require(workspace.lines.size() >= axis.extent * kLanes,
          "GridGaussian: the workspace is of a smaller grid");
  const double* factors = axis.factors.data() + axis.factors.size() / 2;
  const std::size_t count = values.size() / axis.extent;
  for (std::size_t first = 0; first < count; first += kLanes) {
    const Lines lines(first, count, axis.extent, axis.stride);
    lines.gather(values.data(), workspace.lines.data());
    kernels::table<double>().spread(workspace.lines.data(), axis.extent, factors, axis.reach,
                                    workspace.spread_lines.data());
    lines.scatter(workspace.spread_lines.data(), values.data());
  }
}

}  // namespace somato
