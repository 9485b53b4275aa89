#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"

namespace somato {

/// Which samples are learned from and which are tested.
enum class Protocol {
  kTrainIsTest,  ///< All for both, as in the papers: it measures memory, not generalization.
  kLeaveOneOut,  ///< Each exploration in turn is tested on a map that never met it.
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

/// The folds of a protocol on `samples` samples; every sample is tested in exactly one. Throws
/// InvalidArgument when there are too few: 1 for train_is_test, 2 for leave_one_out.
std::vector<Fold> folds(Protocol protocol, std::size_t samples);

}  // namespace somato
