#include "studies/measures/sample_distances.h"

#include <algorithm>
#include <cmath>

#include "base/core/threads.h"
#include "somato/core/check.h"
#include "studies/measures/nearest_neighbour.h"

namespace somato {
namespace {

// The mean over pairs of samples.
class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  bool empty() const { return count_ == 0; }
  double value() const { return sum_ / static_cast<double>(count_); }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

// Whom a sample's nearest candidate and a random one would take it for.
struct Verdict {
  bool is_right = false;
  double chance = 0.0;
};

Verdict judge(const Matrix<double>& distances, const std::vector<std::size_t>& classes,
              const std::vector<std::size_t>& groups, std::size_t sample) {
  std::optional<std::size_t> nearest;
  Mean alike;
  for (std::size_t other = 0; other < classes.size(); ++other) {
    if (groups[other] == groups[sample]) continue;
    alike.add(classes[other] == classes[sample] ? 1.0 : 0.0);
    if (!nearest || distances(sample, other) < distances(sample, *nearest)) nearest = other;
  }
  require(nearest.has_value(), "a nearest neighbour needs samples of another group");
  return {classes[*nearest] == classes[sample], alike.value()};
}

}  // namespace

Matrix<double> distances_between(const Samples& samples, std::size_t threads) {
  const std::size_t count = samples.count();
  Matrix<double> distances(count, count);
  for_each_task(count, threads, [&](std::size_t sample) {
    for (std::size_t other = 0; other < count; ++other) {
      // Rounding may leave the difference of two equal samples below 0.
      const double squared = squared_distance(samples[sample], samples[other]);
      distances(sample, other) = other == sample ? 0.0 : std::sqrt(std::max(0.0, squared));
    }
  });
  return distances;
}

NeighbourAccuracy neighbour_accuracy(const Matrix<double>& distances,
                                     const std::vector<std::size_t>& classes,
                                     const std::vector<std::size_t>& groups) {
  require(classes.size() == distances.rows() && groups.size() == distances.rows(),
          "a class and a group for each sample are required");
  Mean right;
  Mean chance;
  for (std::size_t sample = 0; sample < classes.size(); ++sample) {
    const Verdict verdict = judge(distances, classes, groups, sample);
    right.add(verdict.is_right ? 1.0 : 0.0);
    chance.add(verdict.chance);
  }
  return {right.value(), chance.value()};
}

std::optional<double> between_to_within(const Matrix<double>& distances,
                                        const std::vector<std::size_t>& classes) {
  require(classes.size() == distances.rows(), "a class for each sample is required");
  Mean between;
  Mean within;
  for (std::size_t sample = 0; sample < classes.size(); ++sample) {
    for (std::size_t other = 0; other < sample; ++other) {
      Mean& mean = classes[sample] == classes[other] ? within : between;
      mean.add(distances(sample, other));
    }
  }
  if (between.empty() || within.empty() || within.value() <= 0.0) return std::nullopt;
  return between.value() / within.value();
}

}  // namespace somato
