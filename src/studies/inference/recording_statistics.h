#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "systems/signals/channel_features.h"

namespace somato {

/// The table [match] of the file of a sweep: what of two recordings is compared.
struct MatchParameters {
  std::string label;
  std::vector<std::string> channels;

  static const Declarations<MatchParameters>& declarations();
};

/// A channel that has no part in the comparison.
struct IgnoredChannel {
  std::string name;
  std::string reason;
};

/// The subjects of the statistics of two recordings.
struct ComparedTouch {
  std::vector<FeaturedChannel> channels;
  std::vector<IgnoredChannel> ignored;
  std::string label;  ///< That of the things that are explored; empty without labels.
  /// The values of the label that both recordings have, which are compared one by one; empty: all
  /// explorations are compared together.
  std::vector<std::string> things;
};

/// A statistic of a recording.
struct Statistic {
  std::string channel;  ///< Its name; for a correlation between channels both, with a comma.
  std::string measure;  ///< Such as "mean", "mean of element 3", "spectrum, octave 2".
  std::string thing;    ///< Empty: of all explorations.

  bool operator==(const Statistic&) const = default;
};

/// Compares what `real` and `simulated` contain: the channels of one name, shape and unit (or
/// without one). True values of a simulation are not compared. A channel has a spectrum if the
/// rates of both are known and agree within 1 %, and all explorations of `real` have at least
/// kLeastSpectrumFrames frames. Without a given label, things are those of "object" or else
/// "material", if both recordings have it.
///
/// Errors: kUsage for a given label or channel that one of the recordings does not have; kData if
/// there is no common channel.
Result<ComparedTouch> compared_touch(const Recording& real, const Recording& simulated,
                                     const MatchParameters& parameters);

/// The statistics of a recording, in the order of statistics_of(): for each thing and channel the
/// mean, quantiles, spread, time course, spectrum and correlation of elements, as means over its
/// explorations; then over all explorations the spread between those of a thing, and the
/// correlations between channels.
std::vector<Statistic> statistic_names(const ComparedTouch& compared);

/// Explorations as rows of features, from which the statistics of any part of them follow.
struct TouchFeatures {
  Matrix<double> features;  ///< One row for each exploration; NaN where one cannot be measured.
  std::vector<std::size_t> thing;  ///< Number of each row among ComparedTouch::things, or 0.
  /// The number of each row's value of the label, in the order of first appearance.
  std::vector<std::size_t> same;
};

/// The features of the explorations of a recording that are compared. Errors (kData): one without a
/// channel or label that is compared, or with another number of elements.
Result<TouchFeatures> touch_features(const ComparedTouch& compared, const Recording& recording);

/// The statistics of the explorations `rows`; NaN for those that cannot be measured.
std::vector<double> statistics_of(const ComparedTouch& compared, const TouchFeatures& touch,
                                  const std::vector<std::size_t>& rows);

/// For each statistic, the difference between two explorations that is common in the recording: the
/// jackknife's standard error of the statistic times the root of the number of explorations (of a
/// mean, the standard deviation between explorations); for a thing that was explored once, the root
/// mean square of the other things. At least a
/// hundredth of the standard deviation of all values of the channel, or for a correlation 0.01. 0
/// if the channel is constant; NaN if fewer than two explorations measure the statistic.
///
/// Source: B. Efron, C. Stein, "The jackknife estimate of variance", Annals of Statistics 9 (1981).
std::vector<double> statistic_scales(const ComparedTouch& compared, const TouchFeatures& touch,
                                     const std::vector<std::size_t>& rows);

/// Divides explorations into a first half of each thing's, in their order, and the others. Those of
/// all things together are divided if no thing was explored twice.
std::pair<std::vector<std::size_t>, std::vector<std::size_t>> halves_of(const TouchFeatures& touch);

}  // namespace somato
