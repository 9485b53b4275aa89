#include "maps/grid/ring.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
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

// The length of the longest subsequence that does not fall.
std::size_t longest_rise(const std::vector<double>& sequence) {
  std::vector<double> least_ends;  // of the rises of each length
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

// In falling order at one angle, so that a rise cannot contain two different numbers there.
std::size_t Ring::longest_run(const std::vector<double>& numbers) const {
  std::vector<std::vector<double>> at_angles;
  at_angles.reserve(angles_.size());
  for (const AtOneAngle& angle : angles_) {
    std::vector<double>& here = at_angles.emplace_back();
    for (const std::size_t individual : angle) here.push_back(numbers[individual]);
    std::sort(here.begin(), here.end(), std::greater<>());
  }
  std::size_t longest = numbers.empty() ? 0 : 1;  // One individual is in order anywhere.
  for (std::size_t first = 0; first < at_angles.size(); ++first) {
    std::vector<double> sequence;
    for (std::size_t step = 0; step < at_angles.size(); ++step) {
      const std::vector<double>& here = at_angles[(first + step) % at_angles.size()];
      sequence.insert(sequence.end(), here.begin(), here.end());
    }
    longest = std::max(longest, longest_rise(sequence));
  }
  return longest;
}

RingExceptions Ring::least_exceptions(const std::vector<double>& numbers) const {
  std::vector<double> falling = numbers;
  for (double& number : falling) number = -number;
  return {numbers.size() - longest_run(numbers), numbers.size() - longest_run(falling)};
}

}  // namespace somato
