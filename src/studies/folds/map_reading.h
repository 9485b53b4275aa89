#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"
#include "studies/folds/fold_run.h"
#include "studies/folds/prepared_study.h"

namespace somato {

/// A metric of one map; `of_each` as in Metric.
struct MeasuredValue {
  std::string name;
  double value = 0.0;
  Distribution of_each = {};
};

/// Classes that are wrong on purpose (see wrong_groupings()), of the first `explorations`.
std::vector<std::vector<std::size_t>> wrong_classes(const StudiedLabel& label,
                                                    std::size_t explorations, std::size_t count,
                                                    std::uint64_t seed);

/// The measures of a map with all samples, each with its value by chance:
/// docs/reference/results.md. `winners` are those of the training samples on the map, which has
/// `grid`.
std::vector<MeasuredValue> read_map(const StudyParameters& study, const PreparedStudy& prepared,
                                    const Grid& grid, const std::vector<std::size_t>& winners,
                                    std::uint64_t seed);

/// The measures for new individuals on a map: the share that is placed with the most similar known
/// individual, and the same for the nearest neighbour; and the order of all individuals, new and
/// known, each with that of numbers shuffled with `seed`. Empty without an order.
std::vector<MeasuredValue> read_placed(const PreparedStudy& prepared, const FoldOutcome& outcome,
                                       std::uint64_t seed);

}  // namespace somato
