#include "studies/measures/nearest_neighbour.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "maps/reading/sample_reader.h"
#include "maps/som/sample_range.h"
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

// The training samples as neurons of a map in a row, whose search is faster for many tests; none
// where it is not, or where its single precision does not suffice.
std::optional<Som> map_of(const Samples& samples, const std::vector<std::size_t>& training,
                          const std::vector<std::size_t>& tests) {
  constexpr std::size_t kFewTraining = 32;
  constexpr std::size_t kFewTests = 64;
  if (samples.is_sparse() || training.size() < kFewTraining || tests.size() < kFewTests) return {};
  const auto fits = [&](std::size_t sample) { return is_in_range(samples[sample]); };
  if (!std::all_of(training.begin(), training.end(), fits)) return {};
  if (!std::all_of(tests.begin(), tests.end(), fits)) return {};
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = training.size();
  Matrix<float> weights(training.size(), samples.size());
  for (std::size_t i = 0; i < training.size(); ++i) {
    write_dense(samples[training[i]], weights.row(i));
  }
  return Som(std::move(parameters), weights);
}

// The search sums in another order: its answer counts where the second nearest sample is farther
// than rounding explains.
bool is_nearest(const Samples& samples, std::size_t nearest, std::size_t second, std::size_t test) {
  const double rounding = static_cast<double>(samples.size() + 8) * 0x1p-50;
  const auto distance_of = [&](std::size_t sample) {
    return dense_squared_distance(samples[sample].values.data(), samples[test].values.data(),
                                  samples.size());
  };
  return distance_of(nearest) * (1.0 + rounding) < distance_of(second);
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
  const std::optional<Som> map = map_of(samples, training, tests);
  std::vector<Winners> found;
  if (map) found = SampleReader(*map).read(samples.subset(tests), {.second = true}).winners;
  std::vector<std::size_t> nearest;
  nearest.reserve(tests.size());
  for (std::size_t i = 0; i < tests.size(); ++i) {
    if (map && is_nearest(samples, training[found[i].first], training[found[i].second], tests[i])) {
      nearest.push_back(training[found[i].first]);
    } else {
      nearest.push_back(training[place_of_nearest(samples, training, lengths, samples[tests[i]])]);
    }
  }
  return nearest;
}

}  // namespace somato
