#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/process_group.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/grid.h"

namespace somato {

/// The most rows of a matrix of which eigenvectors are computed.
inline constexpr std::size_t kMostRowsOfPlane = 4096;

/// The plane of the two largest principal components of samples. The covariance divides by the
/// number of samples. A component with a variance of at most 1e-12 of that of the first is 0.
struct PrincipalPlane {
  std::vector<double> mean;    ///< The mean of each feature.
  std::vector<double> first;   ///< The first component times its standard deviation. The element of
                               ///< greatest magnitude, in a tie the first, is positive.
  std::vector<double> second;  ///< The second one.
};

/// Refuses (kUsage) more than 4096 samples that have more than 4096 features that vary, which takes
/// too long. `low` and `high` are the least and greatest value of each feature.
Result<void> check_plane(std::size_t count, std::span<const float> low,
                         std::span<const float> high);

/// Whether the plane of so many samples is computed from the products of samples, of which all must
/// be in memory, instead of those of features: if no fewer features vary.
bool plane_needs_all(std::size_t count, std::span<const float> low, std::span<const float> high);

/// The plane of samples in memory, dense or sparse, which check_plane() accepts: the same bits for
/// every number of threads.
PrincipalPlane principal_plane(const Samples& samples, std::span<const float> low,
                               std::span<const float> high, std::size_t threads = 1);

/// The covariance of the features that vary, of samples that are given in parts. Each value is
/// rounded to 2^-22 of half the range of its feature (2^-21 from 2^18 samples on, and so on), so
/// that the sums are exact: the same bits for every division into parts and processes.
class CovarianceSums {
 public:
  /// For `count` samples in all.
  CovarianceSums(std::size_t count, std::span<const float> low, std::span<const float> high,
                 std::size_t threads);

  void add(const Samples& part);

  /// Takes in the samples of all processes. To be called once, after all samples.
  void combine(ProcessGroup& processes);

  /// The plane of these samples.
  PrincipalPlane plane();

 private:
  std::size_t size() const { return varying_.size(); }
  void add_strip();
  void flush();
  Matrix<double> covariance() const;

  std::size_t count_;
  std::size_t threads_;
  int bits_;
  std::vector<double> centres_;         // of the ranges of all features
  std::vector<std::size_t> varying_;    // features
  std::vector<double> scales_;          // of these
  std::vector<std::int64_t> sums_;      // of their integers
  std::vector<std::int64_t> products_;  // and of products of these, features x features
  Matrix<double> strip_;                // integers of some samples
  std::size_t in_strip_ = 0;
  Matrix<double> exact_;  // products of few samples, which a double holds exactly
  std::size_t in_exact_ = 0;
};

/// Where a neuron starts on the plane: the factors, -1 to 1, of the first and the second component.
/// The first follows the side with more neurons, in a square map the rows from left to right. A map
/// of one row or column uses one component.
struct PlanePlace {
  double first = 0.0;
  double second = 0.0;
};
PlanePlace place_on_plane(const Grid& grid, std::size_t neuron);

/// The combination of samples that a component is: sum_i f_i x_i = component for the returned f, if
/// the plane is that of `samples`. Zeros for a component that is 0.
std::vector<double> factors_of_component(const PrincipalPlane& plane,
                                         std::span<const double> component, const Samples& samples);

}  // namespace somato
