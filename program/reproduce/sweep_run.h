#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reproduce/kept_studies.h"
#include "reproduce/part.h"
#include "reproduce/part_recordings.h"
#include "reproduce/stock.h"
#include "reproduce/sweep_progress.h"
#include "somato/core/result.h"
#include "studies/inference/targets.h"
#include "studies/sweep/sweep_plan.h"
#include "studies/sweep/sweep_results.h"
#include "terminal/folder_lock.h"

namespace somato::program {

/// The sweep described by the command line.
struct SweepRequest {
  SystemSweep sweep;
  std::vector<SweepPoint> points;
  PairsRequest pairs;
  Part part;
  std::filesystem::path out;
  std::optional<Targets> targets = {};  ///< Observations from which the unknowns are inferred.
};

/// Runs the points of one part, and combines the results of all parts.
class SweepRun {
 public:
  /// The request must outlive this object.
  explicit SweepRun(SweepRequest& request);

  /// Errors: kSystem.
  Result<void> make_folders() const;

  /// Locks the part against other runs. Errors: kSystem.
  Result<FolderLock> lock() const { return FolderLock::take(kept_.own_folder()); }

  /// Runs its points that no part has completed. Errors: those of PartRunner::run(), with the
  /// point.
  Result<void> run();

  /// The results of all parts, for the completed points.
  Result<SweepResults> results();

 private:
  const std::optional<std::size_t>& stock() const { return request_.sweep.sweep.sweep.stock; }
  Result<std::string> name_of(const ReproductionPart& part);
  /// With targets each point has seeds of its own, because it is a draw; otherwise all have the
  /// same. Recordings of a stock follow.
  Result<void> use_point(std::size_t number);
  /// Explores the missing files of the stock that the points require, and reports the time.
  Result<void> explore_stock(const std::vector<std::size_t>& points);
  Result<std::map<std::string, StockFile>> stock_files(const std::vector<std::size_t>& points);
  /// Nothing if a study is missing.
  Result<std::optional<std::vector<PartResults>>> found_at(std::size_t number);
  Result<std::vector<std::size_t>> missing_points();
  /// The recordings of a draw serve no other point, and those of a thousand draws fill a disk.
  Result<void> remove_recordings(const std::vector<ReproductionPart>& parts);
  Result<void> run_point(std::size_t number, SweepProgress& progress);
  Result<void> run_study_at(const SweepPoint& point, const ReproductionPart& part,
                            const SweepProgress& progress);
  Error at_point(Error error, const SweepPoint& point) const;

  SweepRequest& request_;
  PartRecordings recordings_;
  PartRunner runner_;
  KeptStudies kept_;
  std::uint64_t first_seed_;  // of the first point
};

}  // namespace somato::program
