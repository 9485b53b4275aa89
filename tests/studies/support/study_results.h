#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "somato/studies/study.h"
#include "studies/support/known_metrics.h"

namespace somato::testing {

inline const ProtocolResults& system_of(const StudyOutcome& outcome, const std::string& protocol) {
  for (const ProtocolResults& system : outcome.results.protocols) {
    if (system.protocol == protocol) return system;
  }
  throw std::out_of_range(protocol);
}

/// The results as results.json has them.
inline std::string json_of(const StudyOutcome& outcome) {
  return to_json(Results{{outcome.results}, {}, {}});
}

/// One a seed; none when there is no such metric.
inline std::vector<double> values_of(const ProtocolResults& system, const std::string& metric) {
  for (const Metric& candidate : system.metrics) {
    if (candidate.name == metric) return candidate.values;
  }
  return {};
}

/// Runs a study that can be run, and expects that its metrics are known.
inline StudyOutcome outcome_of(const StudyDescription& description, const Recording& recording,
                               const StudyOptions& options = {}) {
  StudyOutcome outcome = run_study(description, recording, options).value();
  for (const ProtocolResults& system : outcome.results.protocols) {
    expect_known_metrics(system.metrics);
  }
  return outcome;
}

}  // namespace somato::testing
