#include "studies/measures/nearest_neighbour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "maps/reading/sample_reader.h"
#include "maps/reading/similarity_scores.h"
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

// The elements that both store are at the same time the next ones of both.
double sparse_manhattan_distance(const SignalView& a, const SignalView& b) {
  double sum = 0.0;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.indices.size() || j < b.indices.size()) {
    const bool of_a =
        j == b.indices.size() || (i < a.indices.size() && a.indices[i] <= b.indices[j]);
    const bool of_b =
        i == a.indices.size() || (j < b.indices.size() && b.indices[j] <= a.indices[i]);
    const double left = of_a ? double{a.values[i++]} : 0.0;
    const double right = of_b ? double{b.values[j++]} : 0.0;
    sum += std::fabs(left - right);
  }
  return sum;
}

// Distances of samples, which are equal for the nearest of two if those are: squares of Euclidean
// ones.
class Distances {
 public:
  Distances(const Samples& samples, Similarity similarity)
      : samples_(samples), similarity_(similarity) {}

  Similarity similarity() const { return similarity_; }
  bool needs_lengths() const {
    return samples_.is_sparse() && similarity_ == Similarity::kEuclidean;
  }

  double dense(const SignalView& a, const SignalView& b) const {
    return similarity_ == Similarity::kManhattan
               ? exact_score(similarity_, a.values.data(), b.values.data(), a.size)
               : dense_squared_distance(a.values.data(), b.values.data(), a.size);
  }

  // `lengths` are the squared ones, where needed.
  double of(const SignalView& candidate, double candidate_length, const SignalView& test,
            double length) const {
    if (!samples_.is_sparse()) return dense(candidate, test);
    if (similarity_ == Similarity::kManhattan) return sparse_manhattan_distance(candidate, test);
    return candidate_length - 2.0 * inner_product(candidate, test) + length;
  }

 private:
  const Samples& samples_;
  Similarity similarity_;
};

// Among the candidates; `lengths` are their squared ones, where they are needed.
std::size_t place_of_nearest(const Samples& samples, const Distances& distances,
                             const std::vector<std::size_t>& candidates,
                             const std::vector<double>& lengths, const SignalView& test) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  const double length = distances.needs_lengths() ? squared_length(test) : 0.0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double distance = distances.of(samples[candidates[i]], lengths[i], test, length);
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

// The training samples as neurons of a map in a row, whose search is faster for many tests; none
// where it is not, or where its single precision does not suffice.
std::optional<Som> map_of(const Samples& samples, const std::vector<std::size_t>& training,
                          const std::vector<std::size_t>& tests, Similarity similarity) {
  constexpr std::size_t kFewTraining = 32;
  constexpr std::size_t kFewTests = 64;
  if (samples.is_sparse() || training.size() < kFewTraining || tests.size() < kFewTests) return {};
  const auto fits = [&](std::size_t sample) { return is_in_range(samples[sample]); };
  if (!std::all_of(training.begin(), training.end(), fits)) return {};
  if (!std::all_of(tests.begin(), tests.end(), fits)) return {};
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = training.size();
  parameters.similarity = similarity;
  Matrix<float> weights(training.size(), samples.size());
  for (std::size_t i = 0; i < training.size(); ++i) {
    write_dense(samples[training[i]], weights.row(i));
  }
  return Som(std::move(parameters), weights);
}

// The search sums in another order: its answer counts where the second nearest sample is farther
// than rounding explains.
bool is_nearest(const Samples& samples, const Distances& distances, std::size_t nearest,
                std::size_t second, std::size_t test) {
  const double rounding = static_cast<double>(samples.size() + 8) * 0x1p-50;
  return distances.dense(samples[nearest], samples[test]) * (1.0 + rounding) <
         distances.dense(samples[second], samples[test]);
}

}  // namespace

double squared_distance(const SignalView& a, const SignalView& b) {
  if (a.sparse || b.sparse) {
    return inner_product(a, a) - 2.0 * inner_product(a, b) + inner_product(b, b);
  }
  return dense_squared_distance(a.values.data(), b.values.data(), a.size);
}

double manhattan_distance(const SignalView& a, const SignalView& b) {
  if (a.sparse) return sparse_manhattan_distance(a, b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    sum += std::fabs(double{a.values[i]} - double{b.values[i]});
  }
  return sum;
}

std::size_t nearest_neighbour(const Samples& samples, const std::vector<std::size_t>& training,
                              std::size_t test) {
  return nearest_neighbours(samples, training, {test}).front();
}

std::vector<std::size_t> nearest_neighbours(const Samples& samples,
                                            const std::vector<std::size_t>& training,
                                            const std::vector<std::size_t>& tests,
                                            Similarity distance) {
  require(!training.empty(), "a nearest neighbour needs training samples");
  require(distance == Similarity::kEuclidean || distance == Similarity::kManhattan,
          "a nearest neighbour has the Euclidean or the Manhattan distance");
  const Distances distances(samples, distance);
  std::vector<double> lengths;
  lengths.reserve(training.size());
  for (const std::size_t candidate : training) {
    lengths.push_back(distances.needs_lengths() ? squared_length(samples[candidate]) : 0.0);
  }
  const std::optional<Som> map = map_of(samples, training, tests, distance);
  std::vector<Winners> found;
  if (map) found = SampleReader(*map).read(samples.subset(tests), {.second = true}).winners;
  std::vector<std::size_t> nearest;
  nearest.reserve(tests.size());
  for (std::size_t i = 0; i < tests.size(); ++i) {
    if (map && is_nearest(samples, distances, training[found[i].first], training[found[i].second],
                          tests[i])) {
      nearest.push_back(training[found[i].first]);
    } else {
      nearest.push_back(
          training[place_of_nearest(samples, distances, training, lengths, samples[tests[i]])]);
    }
  }
  return nearest;
}

}  // namespace somato
