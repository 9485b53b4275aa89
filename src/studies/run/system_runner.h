#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
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

/// The same folds by another choice, with the first seed only and without a baseline.
struct OtherFolds {
  FoldChoice choice = FoldChoice::kBlocks;
};

/// One protocol: all seeds and folds, and the metrics made of them. The description and the
/// question must outlive it.
class SystemRunner {
 public:
  /// `number` is the place of the protocol among those of the study.
  SystemRunner(const StudyDescription& description, const PreparedStudy& prepared,
               ProtocolPart part, std::size_t number, std::optional<OtherFolds> other = {});

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

  /// The classes of the tested samples, and those named with the first seed.
  struct NamedSamples {
    std::vector<std::string> labels;
    std::vector<std::string> named;
  };
  NamedSamples first_named() const;

 private:
  Result<FoldOutcome> outcome_of(std::size_t fold, std::uint64_t seed, Tally& tally);
  std::uint64_t seed(std::size_t index) const { return description_.study.first_seed + index; }
  std::vector<Neighbours> neighbours(const TrainedFold& trained, std::size_t fold);
  std::vector<Neighbours> find_neighbours(const ExplorationValues& vectors, std::size_t fold) const;
  std::map<std::string, std::size_t> chosen_neighbours() const;
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
  bool has_baseline_;
  std::vector<Fold> folds_;
  InnerFolds inner_;
  std::vector<std::size_t> tested_;                     ///< All tested samples, ascending.
  std::vector<std::unique_ptr<FoldOutcome>> outcomes_;  // those that are known
  std::vector<std::vector<Neighbours>>
      neighbours_;  ///< The neighbours of folds whose vectors do not depend on the seed.
  std::vector<std::once_flag> are_known_;  ///< The state of neighbours_.
};

}  // namespace somato
