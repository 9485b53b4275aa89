#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flags/command_line.h"
#include "reproduce/reproduction_recordings.h"
#include "reproduce/stock.h"
#include "somato/core/result.h"
#include "somato/studies/reproduction.h"
#include "studies/run/reproduction_run.h"

namespace somato::program {

/// The pairs that a command runs, and the source of their recordings.
struct PairsRequest : PairOptions {
  std::size_t recordings = 6;
  std::optional<GivenRecordings> given;  ///< Recordings to use instead of exploring.
};

/// --data and --test-data of the commands that run systems on pairs.
Flag given_recordings_flag();
Flag test_recording_flag();

/// Reads --threads, --data and --test-data.
Result<void> read_threads_and_data(const Arguments& arguments, PairsRequest& request);

/// Errors (kUsage): the part has a missing or invalid description of the exploration; with given
/// recordings it is not required.
Result<void> check_explorable(const ReproductionPart& part, bool given);

/// The place of a point of a sweep in a stock.
struct StockPoint {
  std::map<std::string, Table> explored;  ///< The explored table [explore] by title_of() of parts.
  std::size_t first = 0;  ///< Number of its first recording among those of all points.
};

/// The recordings of parts: given ones, explored and stored in a folder, or played from a stock.
class PartRecordings final : public RecordingSource {
 public:
  /// The request must outlive it.
  PartRecordings(PairsRequest& request, const std::filesystem::path& folder)
      : request_(request), explored_(folder, request.seed, request.threads) {}

  /// From now on recordings are played from this stock.
  void use_stock(RecordingStock stock) { stock_.emplace(std::move(stock)); }
  void use_stock_point(StockPoint point) { stock_point_ = std::move(point); }

  /// The stock, and the recording of a part in it; only after use_stock().
  const RecordingStock& stock() const { return *stock_; }
  StockedRecording stocked(const ReproductionPart& part, std::size_t index) const;

  /// Recordings are explored with the seeds of the request as it is now.
  void use_seeds() { explored_.begin_at(request_.seed); }

  /// Removes the files of the recordings that were explored for a part. Errors: those of
  /// identity().
  Result<void> remove_explored(const ReproductionPart& part);

  bool is_given() const override { return request_.given.has_value(); }
  Result<std::size_t> count(const ReproductionPart& part) const override;
  Result<KeptRecordings::Kept> get(const ReproductionPart& part, std::size_t index) override;
  Result<std::string> identity(const ReproductionPart& part, std::size_t index) override;

 private:
  /// The numbers of the given recordings that fit the part.
  std::vector<std::size_t> given_for(const ReproductionPart& part) const;

  PairsRequest& request_;
  ExploredRecordings explored_;
  std::optional<RecordingStock> stock_;
  StockPoint stock_point_;
  std::map<std::size_t, std::string> given_hashes_;
};

}  // namespace somato::program
