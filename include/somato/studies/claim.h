#pragma once

#include <optional>
#include <string>
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

  /// Whether it is about the difference of two.
  bool compares() const { return !than_system.empty() || !than_variation.empty(); }

  static const Declarations<Claim>& declarations();
};

/// The tables `[[claim]]` of a file. Errors (kUsage) with their place: unknown keys, no text or
/// metric, no bound.
Result<std::vector<Claim>> read_claims(const Table& file);

/// How a claim came out.
struct ClaimOutcome {
  Claim claim;
  std::vector<double> values;     ///< The metric, or the difference, of each pair.
  std::optional<double> by_luck;  ///< Mean of the same metric on wrong groupings, if there is one.

  /// The share of pairs for which it holds.
  double share() const;
};

}  // namespace somato
