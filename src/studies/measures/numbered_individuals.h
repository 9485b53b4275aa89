#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// The labels that define individuals: their name, their number, and their group.
struct NumberedLabels {
  std::string individual;
  std::string order;
  std::string within;  ///< Empty: all are in one group.
};

/// An individual, such as an object, with a number, such as its girth.
struct NumberedIndividual {
  std::string group;
  double number = 0.0;
  std::vector<std::size_t> samples;
};

/// The individuals, in the order of their numbers in `individuals`, which has one a sample.
/// Errors (kData): a label that is no number, an individual with two numbers or in two groups.
Result<std::vector<NumberedIndividual>> numbered_individuals(
    const Recording& recording, const NumberedLabels& labels,
    const std::vector<std::size_t>& individuals);

/// Whether there are three different numbers: two are always in order.
bool has_an_order(const std::vector<NumberedIndividual>& members);

/// The error (kData) where nothing has.
Error no_order(const std::string& order);

}  // namespace somato
