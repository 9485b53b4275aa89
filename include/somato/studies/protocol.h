#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"

namespace somato {

/// Which explorations are learned from and which are tested.
enum class Protocol {
  kTrainIsTest,    ///< All for both, as in the papers: it measures memory, not generalization.
  kLeaveOneOut,    ///< Each exploration in turn is tested on what never met it.
  kLeaveGroupOut,  ///< The same with all explorations that share a label.
  kFolds,          ///< The same with equal parts, each class spread over all of them.
  kTestData,       ///< A recording of its own is tested on what learned from all of the other.
};

template <>
struct Choices<Protocol> {
  static const std::vector<std::pair<Protocol, std::string>>& all();
};

/// One training with its test: numbers of samples, ascending.
struct Fold {
  std::vector<std::size_t> training;
  std::vector<std::size_t> test;

  bool operator==(const Fold&) const = default;
};

/// What there is to divide.
struct FoldSamples {
  std::size_t samples = 0;       ///< Numbered from 0.
  std::size_t test_samples = 0;  ///< Of a recording of their own, numbered after the others.
  std::vector<std::size_t> groups = {};   ///< One a sample, for leave_group_out.
  std::vector<std::size_t> classes = {};  ///< One a sample, for folds.
  std::size_t folds = 10;                 ///< For folds.
  std::uint64_t seed = 1;                 ///< Of the dealing, for folds.
};

/// The folds of a protocol; every tested sample is tested in exactly one. Throws InvalidArgument
/// when there are too few: 1 sample for train_is_test and test_data, else 2; 2 groups for
/// leave_group_out; as many samples as folds; a test sample for test_data.
std::vector<Fold> folds(Protocol protocol, const FoldSamples& samples);

}  // namespace somato
