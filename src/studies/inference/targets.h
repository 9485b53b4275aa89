#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/studies/claim.h"
#include "studies/inference/acceptance.h"
#include "studies/sweep/sweep_plan.h"

namespace somato {

/// The table [inference] of a file of targets.
struct InferenceParameters {
  double accepted = 0.05;
  bool adjusted = true;
  std::size_t truths = 20;
  std::size_t bodies = 20;
  std::size_t pairs = 5;
  std::uint64_t seed = 9001;

  AcceptanceRule rule() const { return {accepted, adjusted}; }

  static const Declarations<InferenceParameters>& declarations();
};

/// A table [[target]]: a measure of one map of a system, and the value that was observed.
struct Target {
  std::string text;
  std::string paper;
  std::string system;
  std::string variation;
  std::string metric;
  std::string protocol = "train_is_test";
  std::string group;
  std::optional<double> observed;
  std::optional<double> scale;
  std::string where = {};  ///< `FILE:LINE`; not declared.

  static const Declarations<Target>& declarations();
};

/// Observations, and the rule by which settings are inferred from them.
struct Targets {
  InferenceParameters inference;
  std::vector<Target> targets;

  AcceptanceRule rule() const { return inference.rule(); }
  Observation observation() const;
};

/// Reads a file of targets. Errors (kUsage) with their location: unknown tables and keys; no
/// target; a target without text, system, metric, observed value or scale, or with an unknown
/// metric or protocol; a scale that is not above 0; two targets with the same measure.
Result<Targets> read_targets(const Table& file);

/// Errors (kUsage): a design in which not all unknowns vary at once; fresh seeds, of which there
/// are `fresh`, among the `drawn` seeds of the draws, each of which has its own.
Result<void> check_inferable(const InferenceParameters& inference, const SweepParameters& sweep,
                             std::size_t drawn, std::size_t fresh, const std::string& where);

/// Whether a claim, or the other side of its comparison, is about the measure of a target.
bool is_about(const Claim& claim, const Target& target);

/// Makes a sweep take the measures of the targets at every point. Errors (kUsage) with their
/// location: a system or variation that is not swept, or without the protocol of the target; a
/// design in which not all unknowns vary at once; a fresh seed among those of the draws, each of
/// which has its own.
Result<void> add_targets(const Targets& targets, SystemSweep& sweep);

}  // namespace somato
