#include "studies/measures/nearest_neighbour.h"

#include <array>
#include <limits>

#include "somato/core/check.h"

namespace somato {

namespace {

// Several sums, so that additions do not wait for each other; added up in their order.
double dense_squared_distance(const float* a, const float* b, std::size_t size) {
  constexpr std::size_t kSums = 8;
  std::array<double, kSums> sums{};
  std::size_t d = 0;
  for (; d + kSums <= size; d += kSums) {
    for (std::size_t k = 0; k < kSums; ++k) {
      const double difference = double{a[d + k]} - double{b[d + k]};
      sums[k] += difference * difference;
    }
  }
  for (; d < size; ++d) {
    const double difference = double{a[d]} - double{b[d]};
    sums[d % kSums] += difference * difference;
  }
  double sum = 0.0;
  for (const double part : sums) sum += part;
  return sum;
}

double squared_length(const SignalView& sample) {
  return inner_product(sample, sample);
}

// Among the candidates; `lengths` are their squared ones, where samples are sparse.
std::size_t place_of_nearest(const Samples& samples, const std::vector<std::size_t>& candidates,
                             const std::vector<double>& lengths, const SignalView& test) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  const double length = samples.is_sparse() ? squared_length(test) : 0.0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const SignalView candidate = samples[candidates[i]];
    const double distance =
        samples.is_sparse()
            ? lengths[i] - 2.0 * inner_product(candidate, test) + length
            : dense_squared_distance(candidate.values.data(), test.values.data(), test.size);
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

}  // namespace

double squared_distance(const SignalView& a, const SignalView& b) {
  if (a.sparse || b.sparse) {
    return inner_product(a, a) - 2.0 * inner_product(a, b) + inner_product(b, b);
  }
  return dense_squared_distance(a.values.data(), b.values.data(), a.size);
}

std::size_t nearest_neighbour(const Samples& samples, const std::vector<std::size_t>& training,
                              std::size_t test) {
  return nearest_neighbours(samples, training, {test}).front();
}

std::vector<std::size_t> nearest_neighbours(const Samples& samples,
                                            const std::vector<std::size_t>& training,
                                            const std::vector<std::size_t>& tests) {
  require(!training.empty(), "a nearest neighbour needs training samples");
  std::vector<double> lengths;
  lengths.reserve(training.size());
  for (const std::size_t candidate : training) {
    lengths.push_back(samples.is_sparse() ? squared_length(samples[candidate]) : 0.0);
  }
  std::vector<std::size_t> nearest;
  nearest.reserve(tests.size());
  for (const std::size_t test : tests) {
    nearest.push_back(training[place_of_nearest(samples, training, lengths, samples[test])]);
  }
  return nearest;
}

}  // namespace somato
