#include "somato/studies/most_similar.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "somato/core/check.h"

namespace somato {
namespace {

void require_finite(const std::vector<NumberedIndividual>& individuals) {
  const auto finite = [](const auto& individual) { return std::isfinite(individual.number); };
  require(std::all_of(individuals.begin(), individuals.end(), finite),
          "individuals need finite numbers");
}

// Infinite to those of another group.
double difference(const NumberedIndividual& a, const NumberedIndividual& b) {
  if (a.group != b.group) return std::numeric_limits<double>::infinity();
  return std::abs(a.number - b.number);
}

std::vector<std::size_t> most_similar_to(const NumberedIndividual& asked,
                                         const std::vector<NumberedIndividual>& known) {
  double least = std::numeric_limits<double>::infinity();
  for (const NumberedIndividual& other : known) least = std::min(least, difference(asked, other));
  if (std::isinf(least)) return {};
  constexpr double kRounding = 1e-12;  // 0.3 is not quite as far from 0.2 as from 0.4
  const double nearest = least + kRounding * (std::abs(asked.number) + least);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (difference(asked, known[i]) <= nearest) found.push_back(i);
  }
  return found;
}

}  // namespace

std::vector<std::vector<std::size_t>> most_similar(const std::vector<NumberedIndividual>& known,
                                                   const std::vector<NumberedIndividual>& asked) {
  require_finite(known);
  require_finite(asked);
  std::vector<std::vector<std::size_t>> found;
  found.reserve(asked.size());
  for (const NumberedIndividual& individual : asked) {
    found.push_back(most_similar_to(individual, known));
  }
  return found;
}

}  // namespace somato
