#pragma once

#include <map>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/studies/reproduction.h"
#include "studies/sweep/sweep.h"
#include "studies/sweep/sweep_points.h"

namespace somato {

/// A sweep of one system, or of several on the same body.
struct SystemSweep {
  std::vector<std::string> systems;  ///< Names of their studies.
  SweepDescription sweep;
  std::vector<NamedFile> files;         ///< The systems', with the changes of the sweep.
  std::vector<std::string> own_values;  ///< The value of each unknown in the systems, in TOML.
  std::vector<Claim> claims;            ///< Those that are judged at every point.
  std::vector<std::string>
      not_judged;  ///< Texts of those that compare with a system that is not swept.
  std::vector<Claim> measured =
      {};  ///< Further measures that are taken at every point; their bounds have no meaning.
};

/// The names of its systems, separated by commas.
std::string names_of(const SystemSweep& sweep);

/// Combines a sweep and the files of systems. A key of a module applies to the systems that have
/// the module, and must be a key of at least one; a table of the sweep's changes likewise.
/// `explore_defaults` are the defaults of the keys of the exploration, by names such as
/// "explore.simulation.placement_noise". Errors (kUsage) with their location: no systems, a
/// question; a key that no system has, with the nearest; no claims; two systems of one name; and
/// those of plan_of_point() for the unchanged systems.
Result<SystemSweep> plan_sweep(const SweepDescription& sweep, const std::vector<NamedFile>& systems,
                               const std::map<std::string, std::string>& explore_defaults);

/// Combines a sweep and the exploration of one file, which needs no other tables. Errors (kUsage)
/// with their location: a key that the file does not have.
Result<SystemSweep> plan_body_sweep(const SweepDescription& sweep, const NamedFile& body,
                                    const std::map<std::string, std::string>& explore_defaults);

/// The files of the systems with the values of a point. Errors: those of with_changes(), at the
/// unknown.
Result<std::vector<NamedFile>> files_at(const SystemSweep& sweep, const SweepPoint& point);

/// The systems that are run at a point: each system with the values of the point, and its
/// variations with claims. Errors: those of files_at() and add_to_plan().
Result<ReproductionPlan> plan_of_point(const SystemSweep& sweep, const SweepPoint& point);

/// A readable description of a point: "learning_rate = 0.3, rows = 10"; unknowns with the system's
/// own value are omitted.
std::string name_of_point(const SweepDescription& sweep, const SweepPoint& point);

}  // namespace somato
