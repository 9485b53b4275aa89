#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"
#include "studies/fold_run.h"
#include "studies/journal.h"
#include "studies/metrics.h"
#include "studies/question.h"

namespace somato {

/// Counts trainings over all protocols, and keeps the first failure.
class Tally {
 public:
  Tally(const Progress& progress, std::uint64_t total) : progress_(progress), total_(total) {}

  void one_done();
  void failed(Error error);
  bool stopped() const { return stopped_; }
  const Error& error() const { return *error_; }

  /// Asks now and then, during a training, whether to stop.
  bool goes_on();

 private:
  void keep(Error error);

  const Progress& progress_;
  std::uint64_t total_;
  std::uint64_t done_ = 0;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point asked_;
  std::optional<Error> error_;
  std::atomic<bool> stopped_ = false;
};

/// A protocol with the label of its groups, if it has any.
struct ProtocolPart {
  Protocol protocol;
  std::string group;
};

/// One protocol: all seeds and folds, and the metrics made of them. The description and the
/// question must outlive it.
class SystemRunner {
 public:
  /// `number` is the place of the protocol among those of the study.
  SystemRunner(const StudyDescription& description, const Question& question, ProtocolPart part,
               std::size_t number);

  /// How many trainings there are to run.
  std::size_t trainings() const { return outcomes_.size() - taken_; }

  /// How many of these the journal knows.
  std::size_t known(const Journal& journal) const;

  /// Training number `index` of these, from any thread, or what the journal knows of it.
  void run(std::size_t index, Journal& journal, Tally& tally);

  /// Takes the training on everything with the first seed, and what it gave but for the baseline:
  /// train_is_test needs not run it again.
  void take(const TrainedFold& trained, const FoldOutcome& tested);

  /// After all trainings.
  SystemResults results() const;

 private:
  std::uint64_t seed(std::size_t index) const { return description_.study.first_seed + index; }
  Neighbours neighbours(const TrainedFold& trained, std::size_t fold);
  std::vector<SeedOutcome> seeds() const;
  Run run_of(const SeedOutcome& seed) const;
  std::vector<std::string> names_of_tested(
      const Classes& classes, const std::vector<std::vector<std::size_t>>& of_folds) const;

  const StudyDescription& description_;
  const Question& question_;
  ProtocolPart part_;
  std::size_t number_;
  std::size_t taken_;  ///< Trainings that are not run here.
  std::vector<Fold> folds_;
  std::vector<std::size_t> tested_;                     ///< All tested samples, ascending.
  std::vector<std::unique_ptr<FoldOutcome>> outcomes_;  // those that are known
  std::vector<Neighbours> neighbours_;                  ///< Of folds whose vectors know no seed.
  std::vector<std::once_flag> are_known_;               ///< Of neighbours_.
};

}  // namespace somato
