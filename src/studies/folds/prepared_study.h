#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "somato/maps/labels.h"
#include "somato/recording/recording.h"
#include "somato/studies/study_parameters.h"
#include "studies/description/exploration_samples.h"
#include "studies/description/folds.h"
#include "studies/folds/prediction.h"

namespace somato {

/// A studied label, and the units that are reassigned to its classes in wrong groupings.
struct StudiedLabel {
  std::string name;
  Classes classes;  ///< The classes of all explorations.
  std::vector<std::size_t> individuals;
};

/// Individuals with a number each, such as objects with their girth, and their groups.
struct StudiedOrder {
  std::vector<std::size_t> individuals;  ///< The individual of each exploration.
  std::vector<double> numbers;           ///< The number of each individual.
  std::vector<std::size_t> groups;       ///< The group of each individual.
};

/// The content of a study: explorations, their classes, and the individuals behind them; and the
/// outputs of its system that do not depend on learning, computed once.
struct PreparedStudy {
  Recording recording;  ///< The explorations to be divided, followed by those of `--test-data`,
                        ///< and all of them again for each alteration.
  FoldSamples samples;  ///< The division.
  std::vector<StudiedLabel> labels;                        ///< The study's own first.
  std::map<std::string, std::vector<std::size_t>> groups;  ///< For leave_group_out, by label.
  std::optional<StudiedOrder> order;
  RecordingLayout layout;
  std::size_t map = 0;                ///< The module that answers.
  std::optional<std::size_t> recall;  ///< The module that calls up its activity, if any.
  std::vector<std::size_t> vectors;   ///< The modules whose outputs the baseline compares.
  std::vector<Prediction> predictions;
  Activations fixed;
  std::optional<ExplorationValues>
      fixed_inputs;  ///< Inputs of the map, if nothing before it learns.
  std::optional<ExplorationValues> fixed_vectors;  ///< The same, for the baseline.

  const Classes& classes() const { return labels.front().classes; }
  /// The division with the groups of a label; empty: the default.
  FoldSamples divided_by(const std::string& group) const;

  std::vector<std::string> alterations;  ///< Their names.

  /// The numbers of `explorations` as altered by alteration number `alteration`.
  std::vector<std::size_t> altered(const std::vector<std::size_t>& explorations,
                                   std::size_t alteration) const;
  /// The test explorations of a fold with its known ones, followed by those altered by each
  /// alteration.
  std::vector<std::size_t> tested_by(const Fold& fold) const;
  /// These and the training explorations, ascending.
  std::vector<std::size_t> used_by(const Fold& fold) const;

  /// A separate system for one training.
  Result<System> system(const StudyDescription& description) const;
};

/// The output map: the one with that name, or if that is empty, the only one whose output no other
/// module uses. Errors (kUsage, at `where`): there is none, or more than one.
Result<std::size_t> find_map(const System& system, const std::string& name,
                             const std::string& where);

/// Errors: see run_study(). `test` may be nullptr.
Result<PreparedStudy> prepare_study(const StudyDescription& description, const Recording& recording,
                                    const Recording* test, std::size_t threads);

}  // namespace somato
