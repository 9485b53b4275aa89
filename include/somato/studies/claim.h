#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/studies/results.h"

namespace somato {

/// What a paper says came out, put so that it can hold or not: a metric of one system under one
/// protocol lies within bounds; or, where another system or variation is named as well, the metric
/// less that of the other one, pair by pair, does.
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
  std::optional<double> published;
  std::optional<double> at_least;
  std::optional<double> at_most;
  std::string where = {};     ///< `file:line`; not declared.
  std::string question = {};  ///< That it belongs to, or empty; not declared.

  /// Whether a paper makes it; the others are comparisons of our own.
  bool is_of_paper() const { return !paper.empty(); }
  /// Whether a value lies within the bounds (to 1e-9, for rounding); NaN and infinity do not.
  bool is_met_by(double value) const;
  /// The bounds in words: "at least 4", "at most 6", "between 4 and 6".
  std::string bounds() const;

  /// Whether it is about the difference of two.
  bool compares() const { return !than_system.empty() || !than_variation.empty(); }

  static const Declarations<Claim>& declarations();
};

/// The tables `[[claim]]` of a file. Errors (kUsage) with their place: unknown keys, no text or
/// metric, no bound.
Result<std::vector<Claim>> read_claims(const Table& file);

/// What the pairs of recording and seed say about a claim; docs/reference/reproduction.md defines
/// each verdict.
enum class ClaimVerdict {
  kHolds,             ///< In at least kHoldsFrom of the pairs.
  kHoldsByChanceToo,  ///< The same, and in at least kChanceFrom of the wrong groupings.
  kMostly,            ///< In at least kMostlyFrom of the pairs.
  kFails,
  kUndecided,  ///< Fewer than kLeastPairs pairs, or explorations that cannot decide it.
};

template <>
struct Choices<ClaimVerdict> {
  static const std::vector<std::pair<ClaimVerdict, std::string>>& all();
};

inline constexpr std::size_t kLeastPairs = 20;
inline constexpr double kHoldsFrom = 0.95;
inline constexpr double kMostlyFrom = 0.5;
inline constexpr double kChanceFrom = 0.5;

/// Whether a share is at least a limit, to 1e-9 for rounding.
bool reaches(double share, double limit);

/// How a claim came out.
struct ClaimOutcome {
  Claim claim;
  std::vector<double> values;     ///< The metric, or the difference, of each pair.
  std::optional<double> by_luck;  ///< Mean of the same metric on wrong groupings, if there is one.
  /// Mean over the pairs of the share of wrong groupings that meet the bounds, 0 to 1; nothing
  /// where they are not known, and for comparisons.
  std::optional<double> chance_share = {};
  std::string undecidable = {};  ///< Why these explorations cannot decide it, or empty.

  /// The share of pairs for which it holds; a pair without a finite value is one of the others.
  double share() const;
  ClaimVerdict verdict() const;
  /// Why it cannot be decided here, or empty.
  std::string reason() const;
};

/// Why explorations such as those of `system` cannot decide a claim, or empty: its bound asks for
/// more of them than there are, or it is about a thing that was not explored. Without runs, which
/// name the things, only the first is seen.
std::string reason_undecidable(const Claim& claim, const SystemResults& system);

/// The chance_share of a claim about a metric, of which `luck` is the metric `_by_luck`.
std::optional<double> chance_share_of(const Claim& claim, const Metric& luck);

}  // namespace somato
