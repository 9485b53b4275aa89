#pragma once

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
#include "studies/folds/fold_run.h"
#include "studies/folds/metrics.h"
#include "studies/folds/prepared_study.h"
#include "studies/folds/tally.h"
#include "studies/run/journal.h"

namespace somato {

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
  SystemRunner(const StudyDescription& description, const PreparedStudy& prepared,
               ProtocolPart part, std::size_t number);

  /// The number of trainings.
  std::size_t trainings() const { return outcomes_.size() - taken_; }

  /// Whether the journal has training number `index`.
  bool is_known(std::size_t index, const Journal& journal) const {
    return journal.find(number_, taken_ + index) != nullptr;
  }

  /// The number of trainings in the journal.
  std::size_t known(const Journal& journal) const;

  /// Runs training number `index`, from any thread, or takes its result from the journal.
  void run(std::size_t index, Journal& journal, Tally& tally);

  /// Takes the training on all samples with the first seed, and its result without the baseline, so
  /// that train_is_test does not run it again.
  void take(const TrainedFold& trained, const FoldOutcome& tested);

  /// After all trainings.
  ProtocolResults results() const;

 private:
  Result<FoldOutcome> outcome_of(std::size_t fold, std::uint64_t seed, Tally& tally);
  std::uint64_t seed(std::size_t index) const { return description_.study.first_seed + index; }
  std::vector<Neighbours> neighbours(const TrainedFold& trained, std::size_t fold);
  /// Adds the distances of the map's weights, where one map is tested with all samples.
  void add_distances(const TrainedFold& trained, FoldOutcome& outcome) const;
  std::vector<SeedOutcome> seeds() const;
  Run run_of(const SeedOutcome& seed) const;
  std::vector<std::string> names_of_tested(
      const Classes& classes, const std::vector<std::vector<std::size_t>>& of_folds) const;

  const StudyDescription& description_;
  const PreparedStudy& prepared_;
  ProtocolPart part_;
  std::size_t number_;
  std::size_t taken_;  ///< Trainings that are not run here.
  std::vector<Fold> folds_;
  std::vector<std::size_t> tested_;                     ///< All tested samples, ascending.
  std::vector<std::unique_ptr<FoldOutcome>> outcomes_;  // those that are known
  std::vector<std::vector<Neighbours>>
      neighbours_;  ///< The neighbours of folds whose vectors do not depend on the seed.
  std::vector<std::once_flag> are_known_;  ///< The state of neighbours_.
};

}  // namespace somato
