#include "studies/sweep/design.h"

#include <utility>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr std::size_t kMostStrata = std::size_t{1} << 20;

// A fraction of 24 bits: with a number of up to 20 bits before the point nothing is rounded into
// the next stratum.
double place_within(Random& random) {
  return (random.next() >> 8) * 0x1p-24;
}

}  // namespace

std::vector<std::vector<double>> latin_hypercube(std::size_t points, std::size_t dimensions,
                                                 std::uint64_t seed) {
  require(points <= kMostStrata, "a Latin hypercube has up to 2^20 points");
  Random random(seed, Stream::kDesign);
  std::vector<std::vector<double>> all(points, std::vector<double>(dimensions));
  for (std::size_t d = 0; d < dimensions; ++d) {
    const std::vector<std::size_t> strata = random_order(points, random);
    for (std::size_t i = 0; i < points; ++i) {
      all[i][d] =
          (static_cast<double>(strata[i]) + place_within(random)) / static_cast<double>(points);
    }
  }
  return all;
}

std::vector<std::vector<std::size_t>> full_factorial(const std::vector<std::size_t>& levels) {
  std::vector<std::vector<std::size_t>> points{{}};
  for (const std::size_t count : levels) {
    std::vector<std::vector<std::size_t>> longer;
    longer.reserve(points.size() * count);
    for (const std::vector<std::size_t>& point : points) {
      for (std::size_t level = 0; level < count; ++level) {
        longer.push_back(point);
        longer.back().push_back(level);
      }
    }
    points = std::move(longer);
  }
  return points;
}

std::vector<std::vector<std::optional<std::size_t>>> one_at_a_time(
    const std::vector<std::size_t>& levels) {
  const std::vector<std::optional<std::size_t>> none(levels.size());
  std::vector<std::vector<std::optional<std::size_t>>> points{none};
  for (std::size_t d = 0; d < levels.size(); ++d) {
    for (std::size_t level = 0; level < levels[d]; ++level) {
      points.push_back(none);
      points.back()[d] = level;
    }
  }
  return points;
}

}  // namespace somato
