#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "command_line.h"
#include "reproduction_recordings.h"
#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "somato/studies/reproduction.h"
#include "somato/studies/reproduction_plan.h"
#include "somato/studies/study.h"

namespace somato::program {

/// The pairs of recording and seed that systems are run on.
struct PairsRequest {
  std::size_t pairs = 100;
  std::size_t recordings = 6;
  std::uint64_t seed = 2011;
  std::size_t threads = 1;
  std::optional<GivenRecordings> given;  ///< In place of exploring.
  std::optional<Recording> test_data;
};

/// Reads --threads, --data and --test-data.
Result<void> read_threads_and_data(const Arguments& arguments, PairsRequest& request);

/// Errors (kUsage): the part says nothing, or something wrong, about how it explores; nothing is
/// needed of it where recordings are given.
Result<void> check_explorable(const ReproductionPart& part, bool given);

/// What happens while a part is run.
struct PartEvents {
  /// The progress of the study on recording number `index` of `count`.
  std::function<Progress(std::size_t index, std::size_t count)> progress;
  /// The file that keeps what is done of it.
  std::function<std::filesystem::path(std::size_t index)> journal;
  /// Called with what it found; may be empty.
  std::function<Result<void>(std::size_t index, const PairedRecording& recording,
                             const StudyDescription& description, const StudyOutcome& outcome)>
      studied = {};
};

/// What came of a part, or why it cannot be run on what was given.
struct PartRun {
  PartResults results;
  std::optional<Error> misfit;
};

/// Runs parts of a plan on pairs of recording and seed.
class PartRunner {
 public:
  /// What is explored is kept in `recordings`. The request must outlive it.
  PartRunner(PairsRequest& request, const std::filesystem::path& recordings)
      : request_(request), explored_(recordings, request.seed, request.threads) {}

  /// Errors: those of recordings, of exploring and of run_study().
  Result<PartRun> run(const ReproductionPart& part, const PartEvents& events);

  /// A text that differs where the part is another, or is run on other pairs.
  Result<std::string> identity(const ReproductionPart& part);

 private:
  struct Seeds {
    std::uint64_t first;
    std::size_t count;
  };

  /// Numbers of the given recordings that the part can be about.
  std::vector<std::size_t> given_for(const ReproductionPart& part) const;
  std::size_t pairs_for(const ReproductionPart& part) const;
  std::size_t recordings_for(const ReproductionPart& part) const;
  Result<KeptRecordings::Kept> recording(const ReproductionPart& part, std::size_t index);
  Result<void> run_on(const PairedRecording& recording, const ReproductionPart& part,
                      std::size_t index, Seeds seeds, const PartEvents& events,
                      PartResults& results) const;
  Result<std::string> recording_identity(const ReproductionPart& part, std::size_t index);

  PairsRequest& request_;
  ExploredRecordings explored_;
  std::map<std::size_t, std::string> given_hashes_;
};

}  // namespace somato::program
