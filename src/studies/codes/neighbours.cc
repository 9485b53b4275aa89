#include "studies/codes/neighbours.h"

#include <algorithm>
#include <utility>

#include "base/core/threads.h"
#include "somato/core/check.h"
#include "studies/measures/nearest_neighbour.h"

namespace somato {
namespace {

// The others of a sample with their distances, ordered by distance, then by number.
std::vector<std::uint32_t> ordered_others(std::span<const float> distances, std::size_t sample) {
  std::vector<std::uint32_t> others;
  others.reserve(distances.size());
  for (std::uint32_t other = 0; other < distances.size(); ++other) {
    if (other != sample) others.push_back(other);
  }
  std::ranges::sort(others, {},
                    [&](std::uint32_t other) { return std::pair(distances[other], other); });
  return others;
}

using PairDistance = double (*)(const SignalView&, const SignalView&);

Matrix<float> pair_distances(const Samples& samples, std::size_t threads, PairDistance distance) {
  const std::size_t count = samples.count();
  Matrix<float> distances(count, count);
  for_each_task(count, threads, [&](std::size_t sample) {
    for (std::size_t other = 0; other < sample; ++other) {
      distances(sample, other) = static_cast<float>(distance(samples[sample], samples[other]));
    }
  });
  for (std::size_t sample = 0; sample < count; ++sample) {
    for (std::size_t other = 0; other < sample; ++other) {
      distances(other, sample) = distances(sample, other);
    }
  }
  return distances;
}

}  // namespace

Matrix<float> squared_distances(const Samples& samples, std::size_t threads) {
  // Rounding may leave the distance of two equal sparse samples below 0.
  return pair_distances(samples, threads, [](const SignalView& a, const SignalView& b) {
    return std::max(0.0, squared_distance(a, b));
  });
}

Matrix<float> manhattan_distances(const Samples& samples, std::size_t threads) {
  return pair_distances(samples, threads, manhattan_distance);
}

double spread_of(const Matrix<float>& squared_distances) {
  require(!squared_distances.empty(), "a spread needs samples");
  double sum = 0.0;
  for (const float distance : squared_distances.values()) sum += double{distance};
  return sum / 2.0 / static_cast<double>(squared_distances.values().size());
}

std::vector<std::uint32_t> nearest_others(const Matrix<float>& squared_distances) {
  require(squared_distances.rows() >= 2, "a neighbour needs two samples");
  std::vector<std::uint32_t> nearest(squared_distances.rows());
  for (std::uint32_t sample = 0; sample < nearest.size(); ++sample) {
    const std::span<const float> distances = squared_distances.row(sample);
    std::uint32_t best = sample == 0 ? 1 : 0;
    for (std::uint32_t other = best + 1; other < nearest.size(); ++other) {
      if (other != sample && distances[other] < distances[best]) best = other;
    }
    nearest[sample] = best;
  }
  return nearest;
}

void add_ranks(const Matrix<float>& squared_distances, std::size_t threads, Matrix<float>& ranks) {
  for_each_task(squared_distances.rows(), threads, [&](std::size_t sample) {
    const std::span<const float> distances = squared_distances.row(sample);
    const std::vector<std::uint32_t> others = ordered_others(distances, sample);
    for (std::size_t first = 0, next = 0; first < others.size(); first = next) {
      while (next < others.size() && distances[others[next]] == distances[others[first]]) ++next;
      const float mean = static_cast<float>(first + 1 + next) / 2.0F;
      for (std::size_t i = first; i < next; ++i) ranks(sample, others[i]) += mean;
    }
  });
}

double information_imbalance(std::span<const std::uint32_t> nearest, const Matrix<float>& ranks) {
  double sum = 0.0;
  for (std::size_t sample = 0; sample < nearest.size(); ++sample) {
    sum += double{ranks(sample, nearest[sample])};
  }
  const auto count = static_cast<double>(nearest.size());
  return 2.0 / count * (sum / count);
}

}  // namespace somato
