#pragma once

#include <map>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/studies/reproduction.h"
#include "studies/sweep/sweep.h"
#include "studies/sweep/sweep_points.h"

namespace somato {

/// A sweep of one system.
struct SystemSweep {
  std::string system;  ///< Name of its study.
  SweepDescription sweep;
  NamedFile file;                       ///< The system's, with the changes of the sweep.
  std::vector<std::string> own_values;  ///< The value of each unknown in the system, in TOML.
  std::vector<Claim> claims;            ///< Those that are judged at every point.
  std::vector<std::string> not_judged;  ///< Texts of those that compare with another system.
};

/// Combines a sweep and the file of a system. `explore_defaults` are the defaults of the keys of
/// the exploration, by names such as "explore.simulation.placement_noise". Errors (kUsage) with
/// their location: a question; a key that the system does not have, with the nearest; no claims;
/// and those of plan_of_point() for the unchanged system.
Result<SystemSweep> plan_sweep(const SweepDescription& sweep, const NamedFile& system,
                               const std::map<std::string, std::string>& explore_defaults);

/// The systems that are run at a point: the system with the values of the point, and its variations
/// with claims. Errors: those of with_changes() and add_to_plan(), at the unknown.
Result<ReproductionPlan> plan_of_point(const SystemSweep& sweep, const SweepPoint& point);

/// A readable description of a point: "learning_rate = 0.3, rows = 10"; unknowns with the system's
/// own value are omitted.
std::string name_of_point(const SweepDescription& sweep, const SweepPoint& point);

}  // namespace somato
