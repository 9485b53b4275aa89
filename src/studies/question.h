#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "somato/maps/grid.h"
#include "somato/maps/labels.h"
#include "somato/recording/recording.h"
#include "somato/studies/protocol.h"
#include "somato/studies/study_parameters.h"
#include "studies/exploration_samples.h"

namespace somato {

/// A label that is asked, and what is dealt to its classes anew in wrong groupings.
struct AskedLabel {
  std::string name;
  Classes classes;  ///< Of all explorations.
  std::vector<std::size_t> individuals;
};

/// Individuals with a number each, such as objects with their girth, and what they are within.
struct AskedOrder {
  std::vector<std::size_t> individuals;  ///< Of each exploration.
  std::vector<double> numbers;           ///< Of each individual.
  std::vector<std::size_t> groups;       ///< Of each individual.
};

/// What a study asks: explorations, their classes, and the individuals behind them; and what of its
/// system never learns, computed once.
struct Question {
  Recording recording;             ///< What is divided, then the explorations of `--test-data`.
  FoldSamples samples;             ///< How it is divided.
  std::vector<AskedLabel> labels;  ///< The study's own first.
  std::map<std::string, std::vector<std::size_t>> groups;  ///< Of leave_group_out, by label.
  std::optional<AskedOrder> order;
  RecordingLayout layout;
  std::size_t map = 0;      ///< The module that answers.
  std::size_t vectors = 0;  ///< The module whose output the baseline compares: what the map learns,
                            ///< before a standardization that comes right before the map.
  Grid grid;                ///< Of the map.
  Activations fixed;
  std::optional<ExplorationValues> fixed_inputs;   ///< Of the map, where nothing before it learns.
  std::optional<ExplorationValues> fixed_vectors;  ///< The same, for the baseline.

  const Classes& classes() const { return labels.front().classes; }
  /// How it is divided with the groups of a label; empty: as it is.
  FoldSamples divided_by(const std::string& group) const;

  /// A system of its own for one training.
  Result<System> system(const StudyDescription& description) const;
};

/// The map that answers: the one of that name, or where that is empty, the only one that nobody
/// listens to. Errors (kUsage, at `where`): there is none, or more than one.
Result<std::size_t> find_map(const System& system, const std::string& name,
                             const std::string& where);

/// Errors: see run_study(). `test` may be nullptr.
Result<Question> make_question(const StudyDescription& description, const Recording& recording,
                               const Recording* test, std::size_t threads);

}  // namespace somato
