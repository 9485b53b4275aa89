#pragma once

#include <map>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/studies/reproduction_plan.h"
#include "somato/studies/sweep.h"
#include "somato/studies/sweep_points.h"

namespace somato {

/// A sweep of one system.
struct SystemSweep {
  std::string system;  ///< Name of its study.
  SweepDescription sweep;
  NamedFile file;                       ///< The system's, with the changes of the sweep.
  std::vector<std::string> own_values;  ///< Of each unknown, what it is in the system, as TOML.
  std::vector<Claim> claims;            ///< Those that are judged at every point.
  std::vector<std::string> not_judged;  ///< Texts of those that compare with another system.
};

/// Puts a sweep and the file of a system together. `explore_defaults` are what the keys of
/// exploring are unless a file says it, by names such as "explore.simulation.placement_noise".
/// Errors (kUsage) with their place: a question; a key that the system does not have, with the
/// nearest; no claims; and those of plan_of_point() for the system as it stands.
Result<SystemSweep> plan_sweep(const SweepDescription& sweep, const NamedFile& system,
                               const std::map<std::string, std::string>& explore_defaults);

/// What is run at a point: the system, with the values of the point, and those of its variations
/// that claims are about. Errors: those of with_changes() and add_to_plan(), at the unknown.
Result<ReproductionPlan> plan_of_point(const SystemSweep& sweep, const SweepPoint& point);

/// A point for a reader: "learning_rate = 0.3, rows = 10"; unknowns that stand as in the system are
/// left out.
std::string name_of_point(const SweepDescription& sweep, const SweepPoint& point);

}  // namespace somato
