#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/result.h"
#include "somato/maps/som_parameters.h"
#include "studies/question.h"

namespace somato {

/// What one map gave: everything the metrics of a seed are made of.
struct FoldOutcome {
  std::vector<std::size_t> winners;      ///< Of the tested samples.
  std::vector<std::size_t> predictions;  ///< Classes of the tested samples.
  double summed_distance = 0.0;          ///< Of the tested samples from their winners.
  double torn = 0.0;                     ///< Tested samples whose two winners do not touch.
  bool apart = false;                    ///< No winner shared between classes, all samples.
  bool connected = false;                ///< Each class one region, all samples.
  double connected_wrong = 0.0;          ///< Share of wrong groupings connected.
};

/// Trains the map of one seed on one fold and tests it.
Result<FoldOutcome> run_fold(const SomParameters& parameters, const PreparedFold& fold,
                             const std::vector<std::size_t>& classes,
                             const std::vector<std::vector<std::size_t>>& wrong_groupings);

}  // namespace somato
