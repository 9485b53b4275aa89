#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// A feature of samples, and how much of it a map explains.
struct FeatureMeasures {
  double mean = 0.0;       ///< The mean of the samples.
  double deviation = 0.0;  ///< Their standard deviation, with divisor n.

  /// 1 - sum (x - w)^2 / sum (x - mean)^2 over the samples x with the weights w of their winners:
  /// at most 1, and below 0 if the mean is nearer to the samples than the winners are. NaN if all
  /// samples have the same value.
  double explained_variance = 0.0;
};

/// A feature by which a group of samples differs from all samples.
struct FeatureDifference {
  std::size_t feature = 0;

  /// The mean of the group minus that of all samples, in standard deviations of all samples; 0 if
  /// all samples have the same value.
  double difference = 0.0;
};

/// Measures the features of samples that are provided in parts, in double precision; the division
/// into parts and the number of threads have no effect. The samples are as the map sees them: after
/// normalization. Missing values (NaN) are left out. Refers to the map, which must not change in
/// the meantime.
class FeatureMeasurement {
 public:
  /// `group_of_neuron` assigns neurons to groups below `groups`, whose samples are to be compared
  /// with all samples; a neuron of a greater number is in no group. Throws InvalidArgument unless
  /// it has one number for each neuron, or is empty. Takes 16 bytes for each group and feature.
  explicit FeatureMeasurement(const Som& som, std::size_t threads = 1,
                              std::vector<std::size_t> group_of_neuron = {},
                              std::size_t groups = 0);

  /// Adds samples with their winners. Throws InvalidArgument if sizes or numbers differ.
  void add(const Samples& samples, std::span<const std::size_t> winners);

  /// One for each element of an input. All are NaN without a known value.
  std::vector<FeatureMeasures> features() const;

  /// The share of the variance of all features together that the map explains: 1 - sum |x - w|^2 /
  /// sum |x - mean|^2. NaN if all samples are equal.
  double explained_variance() const;

  /// The features by which a group differs from all samples, the greatest absolute difference
  /// first; equal ones in the order of the features. Features without a known value in the group
  /// are not listed. Throws InvalidArgument if there is no such group.
  std::vector<FeatureDifference> differences(std::size_t group) const;

 private:
  void add_to_groups(const Samples& samples, std::span<const std::size_t> winners);

  const Som& som_;
  std::size_t threads_;
  std::vector<std::size_t> group_of_neuron_;
  std::vector<double> means_;
  std::vector<double> squares_;    // sums of (x - mean)^2
  std::vector<double> residuals_;  // sums of (x - w)^2
  std::vector<std::size_t> counts_;
  Matrix<double> group_sums_;
  Matrix<std::size_t> group_counts_;
};

/// The component planes of a map in an order in which similar ones follow each other.
struct PlaneOrder {
  std::vector<std::size_t> order;             ///< Features, in this order.
  std::vector<std::size_t> group_of_feature;  ///< Numbered from 0 in the order.
  std::size_t groups = 0;
};

/// The most features that order_planes() compares.
inline constexpr std::size_t kMostPlanes = 2048;

/// Orders the component planes by their correlation over the neurons: the leaves of Ward's
/// clustering of the planes, which are first scaled to mean 0 and length 1, so that the squared
/// distance of two planes is 2 (1 - correlation). The number of groups, at most 20, is that
/// with the highest mean silhouette. Of two merged clusters, that of the lowest feature comes
/// first. Planes that are constant up to 2^-18 of their greatest absolute weight have no
/// correlation; they follow last, as one group. Throws InvalidArgument for more than kMostPlanes
/// features. Takes features^2 x neurons operations.
PlaneOrder order_planes(const Som& som);

}  // namespace somato
