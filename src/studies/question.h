#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/labels.h"
#include "somato/recording/recording.h"
#include "somato/studies/protocol.h"
#include "somato/studies/study_parameters.h"
#include "somato/studies/vectors.h"

namespace somato {

/// What a study asks: vectors, their classes, and the individuals behind them.
struct Question {
  Vectors vectors;
  Classes classes;
  std::vector<std::size_t> individuals;
};

/// Errors: see run_study().
Result<Question> make_question(const StudyDescription& description, const Recording& recording);

/// A fold with all samples as its map takes them, and what the baseline says.
struct PreparedFold {
  Fold fold;
  Samples samples;                                 ///< All, standardized on the training part.
  std::vector<std::size_t> raw_baseline;           ///< Nearest-neighbour classes of the tested.
  std::vector<std::size_t> standardized_baseline;  ///< The same on standardized vectors.
};

/// The folds of a protocol. Errors (kData): a constant element that is to be refused.
Result<std::vector<PreparedFold>> prepare_folds(const Question& question,
                                                const VectorParameters& parameters,
                                                Protocol protocol);

}  // namespace somato
