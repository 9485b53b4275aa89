#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"
#include "studies/fold_run.h"
#include "studies/question.h"

namespace somato {

/// A metric of one map; `of_each` as in Metric.
struct Reading {
  std::string name;
  double value = 0.0;
  Distribution of_each = {};
};

/// Classes that are wrong on purpose (see wrong_groupings()), of the first `explorations`.
std::vector<std::vector<std::size_t>> wrong_classes(const AskedLabel& label,
                                                    std::size_t explorations, std::size_t count,
                                                    std::uint64_t seed);

/// What the papers read off a map with all samples on it, each with what luck would give:
/// docs/reference/results.md. `winners` are those of the samples that were learned from.
std::vector<Reading> read_map(const StudyParameters& study, const Question& question,
                              const std::vector<std::size_t>& winners, std::uint64_t seed);

/// What is read where new individuals were put on a map: the share that is placed with the known
/// individual most similar to it, and the same of the nearest neighbour; and the order of all
/// individuals, new and known, each beside that of numbers shuffled with `seed`. Nothing without an
/// order.
std::vector<Reading> read_placed(const Question& question, const FoldOutcome& outcome,
                                 std::uint64_t seed);

}  // namespace somato
