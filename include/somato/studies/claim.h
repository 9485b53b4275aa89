#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato {

struct Metric;
struct ProtocolResults;

/// How the values of the pairs decide on a claim; docs/reference/reproduction.md defines each.
enum class ClaimCriterion {
  kShareOfPairs,  ///< By the share of the pairs whose value is within the bounds.
  kCentralRange,  ///< By whether the published value is in the central 90 % of the pairs' values.
  kMean,          ///< By whether the interval of the mean over the recordings is within the bounds.
};

template <>
struct Choices<ClaimCriterion> {
  static const std::vector<std::pair<ClaimCriterion, std::string>>& all();
};

/// Two ends, both included.
struct ClaimRange {
  double low = 0.0;
  double high = 0.0;

  /// Whether a value lies between them (to 1e-9, for rounding).
  bool contains(double value) const;
  /// The difference of the ends.
  double width() const { return high - low; }

  bool operator==(const ClaimRange&) const = default;
};

/// A statement of a paper in testable form: a metric of one system under one protocol is within
/// bounds; or, if another system, variation or metric is given as well, the difference of the
/// metrics, pair by pair, is within bounds. The keys `judged_...` declare a second measure, which
/// follows the words of the text more closely: see as_written().
struct Claim {
  std::string text;
  std::string paper;
  std::string system;
  std::string variation;
  std::string metric;
  std::string protocol = "train_is_test";
  std::string group;
  std::string than_system;
  std::string than_variation;
  std::string than_metric;
  std::optional<double> published;
  std::optional<double> at_least;
  std::optional<double> at_most;
  ClaimCriterion judged_by = ClaimCriterion::kShareOfPairs;
  std::string judged_metric = {};
  std::optional<double> judged_at_least = {};
  std::optional<double> judged_at_most = {};
  std::string contradicted_by = {};
  std::string where = {};     ///< `FILE:LINE`; not declared.
  std::string question = {};  ///< The question it belongs to, or empty; not declared.
  /// By which its outcome is judged; another one only in what as_written() returns. Not declared.
  ClaimCriterion criterion = ClaimCriterion::kShareOfPairs;
  /// Whether an interval of the mean that touches a bound is within it. False in what as_written()
  /// returns for kMean if the key `judged_at_least` or `judged_at_most` is given. Not declared.
  bool bounds_included = true;

  /// The claim by its second measure: with `judged_by` as its criterion, and with the metric and
  /// the bounds of the keys `judged_...` where they are given. Without a published value if it has
  /// another metric. Nothing if no such key differs from its default.
  std::optional<Claim> as_written() const;

  /// Whether it is from a paper; other claims are comparisons by this project.
  bool is_of_paper() const { return !paper.empty(); }
  /// Whether a value is within the bounds (to 1e-9, for rounding); NaN and infinity are not.
  bool is_met_by(double value) const;
  /// The bounds as text: "at least 4", "at most 6", "between 4 and 6"; of a mean whose bounds are
  /// not included "above 4"; for kCentralRange "range with 5".
  std::string bounds() const;

  /// Whether it is about the difference of two metrics.
  bool compares() const {
    return !than_system.empty() || !than_variation.empty() || !than_metric.empty();
  }
  /// The metric that is subtracted in a comparison: `than_metric`, by default `metric`.
  const std::string& other_metric() const { return than_metric.empty() ? metric : than_metric; }
  /// The other side of its comparison, as text: the other system, the other variation, or both;
  /// empty if it compares with nothing.
  std::string other() const;
  /// The measured quantity, as text: "accuracy", "accuracy less that of hardness, small" or
  /// "accuracy less baseline_accuracy of small".
  std::string measured() const;

  static const Declarations<Claim>& declarations();
};

/// The tables `[[claim]]` of a file. Errors (kUsage) with their location: unknown keys, no text or
/// metric, no bound; a second measure that is incomplete.
Result<std::vector<Claim>> read_claims(const Table& file);

/// The verdict on a claim from the pairs of recording and seed; docs/reference/reproduction.md
/// defines each verdict.
enum class ClaimVerdict {
  kHolds,             ///< In at least kHoldsFrom of the pairs.
  kHoldsByChanceToo,  ///< The same, and in at least kChanceFrom of the wrong groupings.
  kCompatible,        ///< The published value is in the central range, narrower than by chance.
  kCompatibleByChanceToo,  ///< It is in the central range, which is not narrower than by chance.
  kMostly,                 ///< In at least kMostlyFrom of the pairs.
  kUndetermined,           ///< The interval of the mean is on both sides of a bound, or touches it.
  kFails,
  kUndecided,  ///< Fewer than kLeastPairs pairs, or explorations that do not permit a decision.
};

template <>
struct Choices<ClaimVerdict> {
  static const std::vector<std::pair<ClaimVerdict, std::string>>& all();
};

inline constexpr std::size_t kLeastPairs = 20;  ///< Pairs that a verdict requires.
inline constexpr double kHoldsFrom = 0.95;      ///< Share of pairs from which a claim holds.
inline constexpr double kMostlyFrom = 0.5;      ///< Share of pairs from which it mostly holds.
inline constexpr double kChanceFrom = 0.5;      ///< Share of wrong groupings that also reach it.

inline constexpr double kCentralShare = 0.9;  ///< Share of the values in a central range.
inline constexpr std::size_t kLeastRecordings =
    2;  ///< Recordings that the interval of a mean needs.

/// Whether a share is at least a limit, to 1e-9 for rounding.
bool reaches(double share, double limit);

/// The outcome of a claim.
struct ClaimOutcome {
  Claim claim;
  std::vector<double> values;  ///< The metric, or the difference, of each pair.
  std::optional<double>
      by_chance;  ///< Mean of the same metric on wrong groupings, if there is one.
  /// Mean over the pairs of the share of wrong groupings that meet the bounds, 0 to 1; empty if
  /// they are unknown, and for comparisons.
  std::optional<double> chance_share = {};
  std::string undecidable =
      {};  ///< The reason why these explorations do not permit a decision, or empty.
  /// The number of the recording of each pair; of the system with fewer recordings in a comparison
  /// of two. Empty: unknown.
  std::vector<std::size_t> recordings = {};
  /// The central range of the values of all wrong groupings of all pairs, if they are known.
  std::optional<ClaimRange> chance_range = {};
  /// The best value of the metric that the numbers of the explored individuals permit at all: the
  /// metric `_greatest` or `_least`, if there is one. Empty for comparisons.
  std::optional<double> limit = {};
  /// The outcome of claim.as_written(): one, which cannot be decided if its metric was not
  /// measured, or none without such a measure.
  std::vector<ClaimOutcome> as_written = {};

  /// The share of pairs for which it holds; a pair without a finite value is one of the others.
  double share() const;
  /// For kMean the 95 % interval of the mean of the recordings' means (Student's t: pairs with one
  /// recording are not independent); for others the central range of the values. Nothing if a value
  /// is missing or there are too few.
  std::optional<ClaimRange> range() const;
  /// For kMean the mean of the recordings' means, which is the centre of range(), if the recordings
  /// are known; otherwise the mean over the pairs. NaN without pairs.
  double mean() const;
  ClaimVerdict verdict() const;
  /// The verdict by the second measure, if there is one; otherwise verdict().
  ClaimVerdict verdict_as_written() const;
  /// The reason why it cannot be decided here, or empty.
  std::string reason() const;
  /// The measured quantity and the bounds and, if there are values, the mean, the ranges and the
  /// share, as text.
  std::string summary() const;
};

/// The reason why the explorations of `system` do not permit a decision on a claim, or empty: its
/// bound requires more explorations than there are, or it is about an object that was not explored.
/// Without runs, which name the objects, only the first reason is detected.
std::string reason_undecidable(const Claim& claim, const ProtocolResults& system);

/// The chance_share of a claim about a metric; `chance` is the corresponding metric `_chance`.
std::optional<double> chance_share_of(const Claim& claim, const Metric& by_chance);

/// The chance_range of claims about a metric; `chance` is the corresponding metric `_chance`.
std::optional<ClaimRange> chance_range_of(const Metric& by_chance);

}  // namespace somato
