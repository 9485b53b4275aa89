#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "somato/studies/reproduction.h"
#include "somato/studies/results.h"
#include "somato/studies/study.h"

namespace somato {

/// A recording to run a system on, with one to test it with if there is any.
struct PairedRecording {
  RecordingInfo info;
  Recording recording;
  std::shared_ptr<const PairedRecording> test = {};
};

/// The source of the recordings of a plan's parts.
class RecordingSource {
 public:
  RecordingSource() = default;
  RecordingSource(const RecordingSource&) = delete;
  RecordingSource(RecordingSource&&) = delete;
  RecordingSource& operator=(const RecordingSource&) = delete;
  RecordingSource& operator=(RecordingSource&&) = delete;
  virtual ~RecordingSource() = default;

  /// Whether they were given, so that parts may not fit them; otherwise they are explored for each
  /// part.
  virtual bool is_given() const = 0;

  /// The number of recordings for a part. Errors (kUsage): none.
  virtual Result<std::size_t> count(const ReproductionPart& part) const = 0;

  /// Recording number `index` for a part. Errors: those of reading or exploring it.
  virtual Result<std::shared_ptr<const PairedRecording>> get(const ReproductionPart& part,
                                                             std::size_t index) = 0;

  /// A text that differs where that recording does; nothing is explored for it.
  virtual Result<std::string> identity(const ReproductionPart& part, std::size_t index) = 0;
};

/// The pairs of recording and seed that systems are run on.
struct PairOptions {
  std::size_t pairs = 100;
  std::uint64_t seed = 2011;  ///< The first one.
  std::size_t threads = 1;
  std::shared_ptr<const PairedRecording> test_data = {};  ///< For all of them, or none.
  bool compare_folds = true;                              ///< See StudyOptions.
};

/// Callbacks while a part is run.
struct PartEvents {
  /// The progress of the study on recording number `index` of `count`.
  std::function<Progress(std::size_t index, std::size_t count)> progress;
  /// The path of the journal.
  std::function<std::string(std::size_t index)> journal;
  /// Called with the results of a recording, and those of the part so far; may be empty.
  std::function<Result<void>(std::size_t index, const StudyDescription& description,
                             const StudyOutcome& outcome, PartResults& part)>
      studied = {};
  /// The folder of the journals of parts of studies; may be empty.
  std::string parts = {};
};

/// The results of a part, or the reason why it cannot be run on the given recordings.
struct PartRun {
  PartResults results;
  std::optional<Error> misfit;
};

/// Runs parts of a plan on pairs of recording and seed.
class PartRunner {
 public:
  /// Both must outlive it.
  PartRunner(const PairOptions& options, RecordingSource& recordings)
      : options_(options), recordings_(recordings) {}

  /// Errors: those of recordings and of run_study().
  Result<PartRun> run(const ReproductionPart& part, const PartEvents& events);

  /// Runs only a part of the trainings (run_part_of_study()); none if the system does not fit the
  /// recordings. Errors: the same.
  Result<StudyProgress> run_part(const ReproductionPart& part, const StudyPart& share,
                                 const PartEvents& events);

  /// A text that differs where the part is another, or is run on other pairs.
  Result<std::string> identity(const ReproductionPart& part);

 private:
  std::size_t pairs_for(const ReproductionPart& part) const;
  Result<std::size_t> recordings_for(const ReproductionPart& part) const;
  bool is_misfit(const Error& error) const;
  /// Runs the study of the part on each recording. Returns the reason if it does not fit them.
  using RunStudy =
      std::function<Result<void>(const StudyDescription& description,
                                 const PairedRecording& recording, const StudyOptions& options)>;
  Result<std::optional<Error>> for_each_study(const ReproductionPart& part,
                                              const PartEvents& events, const RunStudy& run);
  const PairedRecording* test_of(const PairedRecording& recording) const;

  const PairOptions& options_;
  RecordingSource& recordings_;
};

/// A part in a few words: "question: system, variation".
std::string title_of(const ReproductionPart& part);

/// Runs all parts of a plan, one after the other, and judges its claims. `events` are those of a
/// part by its number. A part that does not fit the recordings is an error, or, with
/// `pass_over_misfits`, listed as not applicable. Errors: those of PartRunner::run().
Result<Results> run_reproduction(const ReproductionPlan& plan, PartRunner& runner,
                                 bool pass_over_misfits,
                                 const std::function<PartEvents(std::size_t part)>& events);

/// Runs only a part of all trainings of a plan, so that several processes can share them. `events`
/// name the folder of the parts. Errors: those of PartRunner::run_part().
Result<StudyProgress> run_part_of_reproduction(
    const ReproductionPlan& plan, PartRunner& runner, const StudyPart& share,
    const std::function<PartEvents(std::size_t part)>& events);

}  // namespace somato
