#include "studies/measures/most_similar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "somato/core/check.h"

namespace somato {
namespace {

void require_finite(const std::vector<SizedThing>& things) {
  const auto finite = [](const auto& thing) { return std::isfinite(thing.number); };
  require(std::all_of(things.begin(), things.end(), finite), "things need finite numbers");
}

// Infinite to those of another group.
double difference(const SizedThing& a, const SizedThing& b) {
  if (a.group != b.group) return std::numeric_limits<double>::infinity();
  return std::abs(a.number - b.number);
}

std::vector<std::size_t> most_similar_to(const SizedThing& query,
                                         const std::vector<SizedThing>& known) {
  double least = std::numeric_limits<double>::infinity();
  for (const SizedThing& other : known) least = std::min(least, difference(query, other));
  if (std::isinf(least)) return {};
  constexpr double kRounding = 1e-12;  // 0.3 is not quite as far from 0.2 as from 0.4
  const double nearest = least + kRounding * (std::abs(query.number) + least);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (difference(query, known[i]) <= nearest) found.push_back(i);
  }
  return found;
}

// The upper one where two are in the middle.
double number_of_median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

}  // namespace

std::vector<std::vector<std::size_t>> most_similar(const std::vector<SizedThing>& known,
                                                   const std::vector<SizedThing>& queries) {
  require_finite(known);
  require_finite(queries);
  std::vector<std::vector<std::size_t>> found;
  found.reserve(queries.size());
  for (const SizedThing& thing : queries) {
    found.push_back(most_similar_to(thing, known));
  }
  return found;
}

std::vector<bool> is_large(const std::vector<SizedThing>& things) {
  require_finite(things);
  std::map<std::size_t, std::vector<double>> numbers;
  for (const SizedThing& thing : things) numbers[thing.group].push_back(thing.number);
  std::map<std::size_t, double> medians;
  for (const auto& [group, its_numbers] : numbers) medians[group] = number_of_median(its_numbers);
  std::vector<bool> large;
  large.reserve(things.size());
  for (const SizedThing& thing : things) large.push_back(thing.number >= medians[thing.group]);
  return large;
}

}  // namespace somato
