#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "explore/explore_table.h"
#include "reproduce/reproduction_recordings.h"
#include "somato/core/result.h"
#include "somato/core/value.h"
#include "studies/sweep/sweep_plan.h"

namespace somato::program {

/// The point with the system's own values for the unknowns that are only settings of sensors: what
/// is explored for the stock.
SweepPoint explored_point(const SweepDescription& sweep, const SweepPoint& point);

/// Errors (kUsage): an unknown that changes what is explored has a range of real numbers, so that
/// each point would need explorations of its own.
Result<void> check_stock(const SweepDescription& sweep);

/// A recording of a point, as it is made from the stock.
struct StockedRecording {
  Table sensors;           ///< The table [explore] of the point.
  Table explored;          ///< The table [explore] of explored_point().
  std::size_t number = 0;  ///< Number of the recording among those of all points.
  std::uint64_t seed = 0;  ///< Seed of the noise and of the differences between sensors.
};

/// A file of the stock.
struct StockFile {
  ExploreTable table;
  bool new_objects = false;
  std::uint64_t seed = 0;
};

/// Recordings with true values, which are explored once and stored in a folder. If the table
/// [explore] declares objects, each object has its own file, so that tables of objects are put
/// together from the files; the number and the seed then decide the noise of an object as if it had
/// been explored with the others.
class RecordingStock {
 public:
  RecordingStock(const std::filesystem::path& folder, std::uint64_t first_seed, std::size_t members,
                 std::size_t threads)
      : first_seed_(first_seed),
        members_(members),
        threads_(threads),
        explored_(folder, first_seed, threads) {}

  /// The files that a recording requires. Errors: those of read_explore_table().
  Result<std::vector<StockFile>> files(const StockedRecording& recording) const;

  /// The path of a file in the folder. Errors: kSystem.
  Result<std::string> path(const StockFile& file) const;

  /// Explores the file unless it exists. Errors: those of exploring.
  Result<void> explore(const StockFile& file) const;

  /// The recording with the sensors of its point. Missing files are explored. Errors: those of
  /// exploring and of sense().
  Result<KeptRecordings::Kept> get(const StockedRecording& recording);

  /// A text that identifies the recording before anything is explored. Errors: kSystem.
  Result<std::string> identity(const StockedRecording& recording) const;

 private:
  Result<KeptRecordings::Kept> read(const StockFile& file);
  /// Without its new objects, with true values.
  Result<std::shared_ptr<const Recording>> training(const StockedRecording& recording,
                                                    const std::vector<StockFile>& files);
  Result<PairedRecording> play(const Recording& explored, const StockedRecording& recording,
                               const ExploreTable& sensors, const std::string& name) const;

  std::uint64_t first_seed_;
  std::size_t members_;
  std::size_t threads_;
  ExploredRecordings explored_;
  KeptRecordings files_;
  KeptRecordings played_;
};

}  // namespace somato::program
