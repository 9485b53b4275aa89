#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "explore/explore_table.h"
#include "flags/command_line.h"
#include "reproduce/kept_studies.h"
#include "reproduce/part.h"
#include "reproduce/reproduction_recordings.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "studies/inference/match.h"
#include "studies/sweep/sweep_plan.h"
#include "terminal/folder_lock.h"

namespace somato::program {

/// A body that is fitted to a recording, as the command line describes it.
struct MatchRequest {
  SystemSweep sweep;
  std::vector<SweepPoint> points;
  InferenceParameters inference;
  MatchParameters match;
  Recording real;
  Part part;
  std::filesystem::path out;
  std::size_t threads = 1;
};

/// Whether all draws can play the sensors of few recordings with true values: every unknown that is
/// not one of a sensor has a list of values.
bool plays_sensors(const SweepDescription& sweep);

/// Simulates the draws of one part, and combines those of all parts. Each draw, and each setting
/// that is checked, has one recording with seeds of its own.
class MatchRun {
 public:
  /// The request must outlive this object.
  explicit MatchRun(const MatchRequest& request);

  /// Errors: kSystem.
  Result<void> make_folders() const;

  /// Locks the part against other runs. Errors: kSystem.
  Result<FolderLock> lock() const { return FolderLock::take(kept_.own_folder()); }

  /// Compares the recording with the unchanged body, and simulates the draws of this part that no
  /// part has completed. Errors: those of matched_touch() and of exploring, with the draw.
  Result<void> run();

  /// The number of draws that all parts have completed.
  Result<std::size_t> completed();

  /// The match, when all draws are completed: the settings that were inferred are simulated, too.
  Result<Match> result();

 private:
  /// The seeds of a recording: of its noise, and of the movements if sensors are played.
  struct Seeds {
    std::uint64_t own = 0;
    std::uint64_t movements = 0;
  };

  Seeds seeds_of_draw(std::size_t number) const;
  /// The recording whose sensors a draw plays. Consecutive draws share one: those of a sequence of
  /// Sobol are evenly distributed over the prior, and every second or fourth draw is not.
  std::size_t recording_of_draw(std::size_t number) const;
  Result<Recording> simulate(const SweepPoint& point, Seeds seeds);
  Result<std::string> name_at(const SweepPoint& point, Seeds seeds) const;
  /// Nothing if it is missing or damaged.
  std::optional<std::vector<double>> found(const std::string& name) const;
  Result<std::vector<double>> statistics_at(const SweepPoint& point, Seeds seeds);
  Result<Matrix<double>> checked(const std::vector<SweepPoint>& points, std::size_t first);
  Error at_point(Error error, const SweepPoint& point) const;

  const MatchRequest& request_;
  ExploredRecordings stock_;
  KeptStudies kept_;
  MatchedTouch touch_;
};

/// Writes match.json, and for each setting of the posterior a folder `bodies/01`, ... with the file
/// of the body, and settings.toml and objects.toml for `somato explore`. Errors: kSystem.
Result<void> save_match(const MatchRequest& request, const Match& match);

/// Fits a body to the recording of --match: simulates the draws of --over, and if no other part
/// has draws left, writes the results and prints them. Errors (kUsage): flags, tables and keys that
/// have no effect; several systems; those of reading the files. Others: those of MatchRun.
Result<void> run_match(const Arguments& arguments);

}  // namespace somato::program
