#include "maps/grid/ring.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>

#include "base/core/rank_correlation.h"

namespace somato {
namespace {

constexpr double kTolerance = 1e-9;
constexpr double kFullTurn = 4.0;

double length_of(const Position& from_centre) {
  return std::abs(from_centre.x) + std::abs(from_centre.y);
}

// 0 to 4, increasing with the angle: the position along a square on its corner instead of a circle.
// It only uses divisions, so that, unlike std::atan2, it has the same bits on all machines.
double turn_of(const Position& from_centre) {
  const double way = from_centre.y / length_of(from_centre);
  if (from_centre.x < 0.0) return 2.0 - way;
  return way < 0.0 ? kFullTurn + way : way;
}

// Individuals at one angle, by their numbers in a group.
using AtOneAngle = std::vector<std::size_t>;

// Those that are not at the centre, by ascending angle.
std::vector<AtOneAngle> by_angle(const std::vector<Position>& from_centre) {
  std::vector<std::pair<double, std::size_t>> turns;
  turns.reserve(from_centre.size());
  for (std::size_t i = 0; i < from_centre.size(); ++i) {
    if (length_of(from_centre[i]) > kTolerance) turns.emplace_back(turn_of(from_centre[i]), i);
  }
  std::sort(turns.begin(), turns.end());
  std::vector<AtOneAngle> ring;
  ring.reserve(turns.size());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (i == 0 || turns[i].first - turns[i - 1].first > kTolerance) ring.emplace_back();
    ring.back().push_back(turns[i].second);
  }
  // A full turn is no turn.
  if (ring.size() > 1 && turns.front().first + kFullTurn - turns.back().first <= kTolerance) {
    ring.front().insert(ring.front().end(), ring.back().begin(), ring.back().end());
    ring.pop_back();
  }
  return ring;
}

// The ranks of the places from angle `first` on.
std::vector<double> cut(const std::vector<AtOneAngle>& angles, std::size_t first,
                        std::size_t count) {
  std::size_t around = 0;
  for (const AtOneAngle& angle : angles) around += angle.size();
  const double middle = (static_cast<double>(around) + 1.0) / 2.0;
  std::vector<double> places(count, middle);
  double before = 0.0;
  for (std::size_t step = 0; step < angles.size(); ++step) {
    const AtOneAngle& here = angles[(first + step) % angles.size()];
    const auto many = static_cast<double>(here.size());
    for (const std::size_t individual : here) places[individual] = before + (many + 1.0) / 2.0;
    before += many;
  }
  return centred_ranks(places);
}

// The length of the longest subsequence that does not fall. `least_ends` is memory for reuse.
std::size_t longest_rise(std::span<const double> sequence, std::vector<double>& least_ends) {
  least_ends.clear();  // of the rises of each length
  for (const double value : sequence) {
    const auto longer = std::upper_bound(least_ends.begin(), least_ends.end(), value);
    if (longer == least_ends.end()) {
      least_ends.push_back(value);
    } else {
      *longer = value;
    }
  }
  return least_ends.size();
}

// The numbers by angle, in falling order at one angle, so that a rise cannot contain two different
// numbers there.
std::vector<double> numbers_around(const std::vector<AtOneAngle>& angles,
                                   const std::vector<double>& numbers) {
  std::vector<double> around;
  around.reserve(2 * numbers.size());
  for (const AtOneAngle& angle : angles) {
    for (const std::size_t individual : angle) around.push_back(numbers[individual]);
    std::sort(around.end() - static_cast<std::ptrdiff_t>(angle.size()), around.end(),
              std::greater<>());
  }
  return around;
}

}  // namespace

Ring::Ring(const std::vector<Position>& from_centre) {
  angles_ = by_angle(from_centre);
  cuts_.reserve(angles_.size());
  for (std::size_t first = 0; first < angles_.size(); ++first) {
    cuts_.push_back(cut(angles_, first, from_centre.size()));
  }
}

RingOrder Ring::best_order(const std::vector<double>& ranks) const {
  if (cuts_.empty()) return {};
  RingOrder best{-1.0, -1.0};
  for (const std::vector<double>& places : cuts_) {
    const double correlation = correlation_of_centred_ranks(ranks, places);
    best.growing = std::max(best.growing, correlation);
    // Another cut has this order backwards.
    best.falling = std::max(best.falling, -correlation);
  }
  return best;
}

std::size_t Ring::longest_run(const std::vector<double>& numbers) const {
  std::vector<double> twice = numbers_around(angles_, numbers);
  const std::size_t count = twice.size();
  for (std::size_t i = 0; i < count; ++i) twice.push_back(twice[i]);
  std::vector<double> memory;
  std::size_t longest = numbers.empty() ? 0 : 1;  // One individual is in order anywhere.
  std::size_t start = 0;
  for (const AtOneAngle& angle : angles_) {
    longest = std::max(longest, longest_rise(std::span(twice).subspan(start, count), memory));
    start += angle.size();
  }
  return longest;
}

RingExceptions Ring::least_exceptions(const std::vector<double>& numbers) const {
  std::vector<double> falling = numbers;
  for (double& number : falling) number = -number;
  return {numbers.size() - longest_run(numbers), numbers.size() - longest_run(falling)};
}

}  // namespace somato
