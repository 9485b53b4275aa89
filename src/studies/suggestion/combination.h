#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "somato/core/result.h"
#include "studies/codes/mutual_prediction.h"

namespace somato {

/// A code of a group that may become a part of a combination; at most one of each group does.
struct Choice {
  std::size_t group = 0;
  std::size_t code = 0;
  Part part;
};

/// A part of a combination, and the score of the combination up to it.
struct ChosenPart {
  std::size_t choice = 0;
  double weight = 1.0;
  double score = 1.0;
};

struct Combination {
  std::vector<ChosenPart> parts;
  std::size_t compared = 0;  ///< The number of combinations that were compared.
};

/// Settings of the search; see SuggestionParameters.
struct CombinationSettings {
  std::vector<double> weights;
  double least_gain = 0.0;
  std::size_t budget = 0;
  std::size_t threads = 1;
  std::function<Result<void>(double share)> proceed;  ///< Called with the share that is done.
};

/// The combination of choices that predicts the senses best, by forward selection: first the best
/// choice, then repeatedly the choice with the weight that lowers the score most, the first in a
/// tie. The same for any number of threads. Errors: those of `proceed`. Throws InvalidArgument
/// without choices.
Result<Combination> best_combination(std::span<const Choice> choices,
                                     std::span<const Neighbourhoods> senses,
                                     const CombinationSettings& settings);

/// The first choice of every group that uses a single sense, with equal weights.
Combination all_of(std::span<const Choice> choices, std::span<const Neighbourhoods> senses);

}  // namespace somato
