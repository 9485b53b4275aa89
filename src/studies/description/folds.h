#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/studies/study_parameters.h"

namespace somato {

/// One training with its test: numbers of samples, ascending.
struct Fold {
  std::vector<std::size_t> training;
  std::vector<std::size_t> test;
  std::vector<std::size_t> known = {};  ///< Neither: held out of the training, of its classes; for
                                        ///< leave_class_out.

  bool operator==(const Fold&) const = default;
};

/// The samples to be divided.
struct FoldSamples {
  std::size_t samples = 0;  ///< Numbered from 0.
  std::size_t test_samples =
      0;  ///< The size of a separate recording, whose samples are numbered after the others.
  std::vector<std::size_t> groups = {};   ///< One per sample, for leave_group_out.
  std::vector<std::size_t> classes = {};  ///< One per sample, for folds and leave_class_out.
  std::size_t folds = 10;                 ///< For folds and leave_class_out.
  std::uint64_t seed = 1;                 ///< The seed of the assignment to folds.
  std::size_t test_last = 0;  ///< Above 0: folds and leave_class_out hold out that many of each
                              ///< class, the last ones, instead of parts.
  FoldChoice choice = FoldChoice::kInterleaved;  ///< For folds and leave_class_out.
};

/// The folds of a protocol; every test sample is tested in exactly one. With `test_last`, k_folds
/// and object_after_object have one fold, which tests these samples only. Throws InvalidArgument if
/// there are too few samples: 1 for train_is_test and test_data, otherwise 2; 2 groups for
/// leave_group_out; 2 classes for leave_class_out; as many samples as folds, or one that is not
/// among the last; a test sample for test_data. The known samples of a fold of leave_class_out are
/// those of a part of k_folds.
///
/// Both fold choices have the same number of samples of each class in each part. Interleaved
/// samples are drawn at random by the seed; blocks are consecutive samples of a class, the first
/// ones in the first of its parts, and do not depend on the seed.
std::vector<Fold> folds(Protocol protocol, const FoldSamples& samples);

/// The largest number of samples of one class that k_folds tests together; `samples` as folds().
std::size_t largest_block(const FoldSamples& samples);

/// The folds of k_folds among the `chosen` samples only, at most one for each of them; `classes`
/// has the class of every sample. Throws InvalidArgument as folds() does.
std::vector<Fold> folds_among(const std::vector<std::size_t>& chosen,
                              const std::vector<std::size_t>& classes, std::size_t parts,
                              std::uint64_t seed, FoldChoice choice = FoldChoice::kInterleaved);

}  // namespace somato
