#pragma once

#include <cstddef>
#include <vector>

namespace somato {

/// How probable each reading of a grasp is for each class: classes x readings; the values of a
/// class add up to 1.
using ReadingProbabilities = std::vector<std::vector<double>>;

/// The probability of each class after a reading, by Bayes' rule. Throws InvalidArgument if the
/// sizes differ or the reading is impossible for all classes that are.
std::vector<double> updated_belief(const std::vector<double>& belief,
                                   const ReadingProbabilities& grasp, std::size_t reading);

/// The entropy of the classes that is to be expected after a grasp, in nats: the mean over its
/// possible readings, each with its probability under the belief. Throws InvalidArgument if the
/// sizes differ.
double expected_entropy(const std::vector<double>& belief, const ReadingProbabilities& grasp);

/// The grasp of `left` after which the least entropy is to be expected; the first in a tie.
/// `grasps` holds the probabilities of all grasps. Throws InvalidArgument if none is left.
std::size_t next_grasp(const std::vector<double>& belief,
                       const std::vector<ReadingProbabilities>& grasps,
                       const std::vector<std::size_t>& left);

}  // namespace somato
