#include "somato/studies/next_grasp.h"

#include "base/core/elementary.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// The probabilities of each class together with a reading.
std::vector<double> joint(const std::vector<double>& belief, const ReadingProbabilities& grasp,
                          std::size_t reading) {
  std::vector<double> joint(belief.size());
  for (std::size_t label = 0; label < belief.size(); ++label) {
    joint[label] = belief[label] * grasp[label][reading];
  }
  return joint;
}

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

void check_sizes(const std::vector<double>& belief, const ReadingProbabilities& grasp) {
  require(!belief.empty() && grasp.size() == belief.size(),
          "a grasp needs probabilities of its readings for each class");
}

}  // namespace

std::vector<double> updated_belief(const std::vector<double>& belief,
                                   const ReadingProbabilities& grasp, std::size_t reading) {
  check_sizes(belief, grasp);
  require(reading < grasp.front().size(), "a grasp does not have this reading");
  std::vector<double> updated = joint(belief, grasp, reading);
  const double sum = sum_of(updated);
  require(sum > 0.0, "the reading is impossible for all classes");
  for (double& probability : updated) probability /= sum;
  return updated;
}

double expected_entropy(const std::vector<double>& belief, const ReadingProbabilities& grasp) {
  check_sizes(belief, grasp);
  double entropy = 0.0;
  for (std::size_t reading = 0; reading < grasp.front().size(); ++reading) {
    const std::vector<double> probabilities = joint(belief, grasp, reading);
    const double sum = sum_of(probabilities);
    for (const double one : probabilities) {
      if (one > 0.0) entropy -= one * natural_log(one / sum);
    }
  }
  return entropy;
}

std::size_t next_grasp(const std::vector<double>& belief,
                       const std::vector<ReadingProbabilities>& grasps,
                       const std::vector<std::size_t>& left) {
  require(!left.empty(), "no grasp is left");
  std::size_t next = left.front();
  double least = expected_entropy(belief, grasps[next]);
  for (const std::size_t grasp : left) {
    const double entropy = expected_entropy(belief, grasps[grasp]);
    if (entropy >= least) continue;
    least = entropy;
    next = grasp;
  }
  return next;
}

}  // namespace somato
