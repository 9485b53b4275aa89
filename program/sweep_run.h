#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "folder_lock.h"
#include "kept_studies.h"
#include "part_runner.h"
#include "somato/core/result.h"
#include "somato/studies/sweep_plan.h"
#include "somato/studies/sweep_results.h"
#include "sweep_part.h"
#include "sweep_progress.h"

namespace somato::program {

/// A sweep as the command line describes it.
struct SweepRequest {
  SystemSweep sweep;
  std::vector<SweepPoint> points;
  PairsRequest pairs;
  SweepPart part;
  std::filesystem::path out;
};

/// Runs the points of one part, and takes all parts together.
class SweepRun {
 public:
  /// The request must outlive it.
  explicit SweepRun(SweepRequest& request);

  /// Errors: kSystem.
  Result<void> make_folders() const;

  /// Keeps other runs of the same part out. Errors: kSystem.
  Result<FolderLock> lock() const { return FolderLock::take(kept_.own_folder()); }

  /// Runs those of its points that no part has run. Errors: those of PartRunner::run(), with the
  /// point.
  Result<void> run();

  /// What all parts have found, for as many points as are there.
  Result<SweepResults> results();

 private:
  Result<std::string> name_of(const ReproductionPart& part);
  /// Nothing where a study is missing.
  Result<std::optional<std::vector<PartResults>>> found_at(const SweepPoint& point);
  Result<std::vector<std::size_t>> missing_points();
  Result<void> run_point(const SweepPoint& point, SweepProgress& progress);
  Result<void> run_study_at(const SweepPoint& point, const ReproductionPart& part,
                            const SweepProgress& progress);
  Error at_point(Error error, const SweepPoint& point) const;

  SweepRequest& request_;
  PartRunner runner_;
  KeptStudies kept_;
};

}  // namespace somato::program
