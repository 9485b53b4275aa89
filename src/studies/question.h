#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "somato/maps/labels.h"
#include "somato/recording/recording.h"
#include "somato/studies/protocol.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// What a study asks: explorations, their classes, and the individuals behind them; and what of its
/// system never learns, computed once.
struct Question {
  Recording recording;  ///< What is divided, then the explorations of `--test-data`.
  FoldSamples samples;  ///< How it is divided.
  Classes classes;      ///< Of all explorations.
  std::vector<std::size_t> individuals;
  RecordingLayout layout;
  std::size_t map = 0;      ///< The module that answers.
  std::size_t vectors = 0;  ///< The module whose output the baseline compares: what the map learns,
                            ///< before a standardization that comes right before the map.
  Activations fixed;

  /// A system of its own for one training.
  Result<System> system(const StudyDescription& description) const;
};

/// Errors: see run_study(). `test` may be nullptr.
Result<Question> make_question(const StudyDescription& description, const Recording& recording,
                               const Recording* test, std::size_t threads);

}  // namespace somato
