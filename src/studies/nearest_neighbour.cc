#include "somato/studies/nearest_neighbour.h"

#include <cmath>
#include <limits>

#include "somato/core/check.h"

namespace somato {

double squared_distance(const SignalView& a, const SignalView& b) {
  if (a.sparse || b.sparse) {
    return inner_product(a, a) - 2.0 * inner_product(a, b) + inner_product(b, b);
  }
  double sum = 0.0;
  for (std::size_t d = 0; d < a.size; ++d) {
    const double difference = double{a.values[d]} - double{b.values[d]};
    sum = std::fma(difference, difference, sum);
  }
  return sum;
}

std::size_t nearest_neighbour(const Samples& samples, const std::vector<std::size_t>& training,
                              std::size_t test) {
  require(!training.empty(), "a nearest neighbour needs training samples");
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = training.front();
  for (const std::size_t candidate : training) {
    const double distance = squared_distance(samples[candidate], samples[test]);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace somato
