#include "studies/sweep/sweep_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/core/elementary.h"
#include "studies/sweep/design.h"
#include "studies/sweep/sobol.h"

namespace somato {
namespace {

constexpr std::size_t kLevelsUnlessGiven = 5;
constexpr double kMostParts = 8.0;

// At this fraction of the way from low to high; the ends are exact.
double on_scale(UnknownScale scale, double low, double high, double fraction) {
  if (fraction <= 0.0) return low;
  if (fraction >= 1.0) return high;
  const double number = scale == UnknownScale::kLinear
                            ? low + fraction * (high - low)
                            : low * exponential(fraction * (natural_log(high) - natural_log(low)));
  return std::clamp(number, low, high);
}

Value whole_value(double number) {
  return {static_cast<std::int64_t>(number)};
}

// A level is at an end of the range or evenly between the ends.
Value level_value(const UnknownParameters& unknown, std::size_t level, std::size_t levels) {
  if (!unknown.is_range()) return unknown.values[level];
  const double fraction = static_cast<double>(level) / static_cast<double>(levels - 1);
  const double number = on_scale(unknown.scale, *unknown.low, *unknown.high, fraction);
  return unknown.whole ? whole_value(std::round(number)) : Value{number};
}

// Each whole number has as much of the scale as lies between it and the next.
double whole_number_at(const UnknownParameters& range, double fraction) {
  return on_scale(range.scale, *range.low, *range.high + 1.0, fraction);
}

std::size_t part_of(double fraction, std::size_t parts) {
  return std::min(static_cast<std::size_t>(fraction * static_cast<double>(parts)), parts - 1);
}

Value value_at(const UnknownParameters& unknown, double fraction) {
  if (!unknown.is_range()) return unknown.values[part_of(fraction, unknown.values.size())];
  if (!unknown.whole) return {on_scale(unknown.scale, *unknown.low, *unknown.high, fraction)};
  return whole_value(std::min(std::floor(whole_number_at(unknown, fraction)), *unknown.high));
}

std::size_t level_count(const UnknownParameters& unknown) {
  if (!unknown.is_range()) return unknown.values.size();
  if (unknown.levels) return *unknown.levels;
  const double most = unknown.whole ? *unknown.high - *unknown.low + 1.0 : kMostParts;
  return std::min(kLevelsUnlessGiven, static_cast<std::size_t>(std::min(most, kMostParts)));
}

// For a design without levels.
std::size_t cell_count(const UnknownParameters& unknown, std::size_t points) {
  if (!unknown.is_range()) return unknown.values.size();
  if (unknown.levels) return *unknown.levels;
  double parts = std::clamp(std::floor(std::sqrt(static_cast<double>(points))), 2.0, kMostParts);
  if (unknown.whole) parts = std::min(parts, *unknown.high - *unknown.low + 1.0);
  return static_cast<std::size_t>(parts);
}

std::vector<std::size_t> level_counts(const SweepDescription& sweep) {
  std::vector<std::size_t> counts;
  counts.reserve(sweep.unknowns.size());
  for (const Unknown& unknown : sweep.unknowns) counts.push_back(level_count(unknown.parameters));
  return counts;
}

SweepPlace at_level(const UnknownParameters& unknown, std::size_t level) {
  return {level_value(unknown, level, level_count(unknown)), level};
}

// `Point` has the number of a level, or nothing, for each unknown.
template <typename Point>
std::vector<SweepPoint> at_levels(const SweepDescription& sweep, const std::vector<Point>& points) {
  std::vector<SweepPoint> places;
  places.reserve(points.size());
  for (const Point& point : points) {
    SweepPoint& place = places.emplace_back();
    for (std::size_t i = 0; i < point.size(); ++i) {
      const std::optional<std::size_t> level = point[i];
      place.emplace_back();
      if (level) place.back() = at_level(sweep.unknowns[i].parameters, *level);
    }
  }
  return places;
}

std::vector<std::vector<double>> fractions_of(const SweepDescription& sweep) {
  const std::size_t points = *sweep.sweep.points;
  const std::size_t dimensions = sweep.unknowns.size();
  if (sweep.sweep.design == SweepDesign::kLatinHypercube) {
    return latin_hypercube(points, dimensions, sweep.sweep.seed);
  }
  std::vector<std::vector<double>> fractions;
  fractions.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    fractions.push_back(sobol_point(static_cast<std::uint32_t>(i), dimensions));
  }
  return fractions;
}

// The places of the unknowns of each group in ascending order.
std::vector<double> with_sorted_groups(const SweepDescription& sweep, std::vector<double> places) {
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string& group = sweep.unknowns[i].parameters.increasing;
    if (!group.empty()) groups[group].push_back(i);
  }
  for (const auto& [name, unknowns] : groups) {
    std::vector<double> of_group;
    for (const std::size_t i : unknowns) of_group.push_back(places[i]);
    std::sort(of_group.begin(), of_group.end());
    for (std::size_t i = 0; i < unknowns.size(); ++i) places[unknowns[i]] = of_group[i];
  }
  return places;
}

SweepCell part_cell(const UnknownParameters& range, std::size_t part, std::size_t parts) {
  const double begin = static_cast<double>(part) / static_cast<double>(parts);
  const double end = static_cast<double>(part + 1) / static_cast<double>(parts);
  if (!range.whole) {
    return {{on_scale(range.scale, *range.low, *range.high, begin)},
            {on_scale(range.scale, *range.low, *range.high, end)}};
  }
  // An edge that is a whole number but for rounding belongs to the later part.
  constexpr double kEdge = 1e-9;
  const double from = std::floor(whole_number_at(range, begin) + kEdge);
  const double to = std::ceil(whole_number_at(range, end) - kEdge) - 1.0;
  return {whole_value(from), whole_value(std::max(from, to))};
}

}  // namespace

bool has_levels(SweepDesign design) {
  return design == SweepDesign::kOneAtATime || design == SweepDesign::kFullFactorial;
}

std::size_t point_count(const SweepDescription& sweep) {
  if (!has_levels(sweep.sweep.design)) return *sweep.sweep.points;
  const bool all = sweep.sweep.design == SweepDesign::kFullFactorial;
  std::size_t points = 1;
  for (const std::size_t levels : level_counts(sweep)) {
    points = std::min(all ? points * levels : points + levels, kMostSweepPoints + 1);
  }
  return points;
}

std::vector<SweepPoint> sweep_points(const SweepDescription& sweep) {
  if (sweep.sweep.design == SweepDesign::kOneAtATime) {
    return at_levels(sweep, one_at_a_time(level_counts(sweep)));
  }
  if (sweep.sweep.design == SweepDesign::kFullFactorial) {
    return at_levels(sweep, full_factorial(level_counts(sweep)));
  }
  std::vector<SweepPoint> points;
  for (const std::vector<double>& fractions : fractions_of(sweep)) {
    points.push_back(point_at(sweep, fractions));
  }
  return points;
}

SweepPlace place_at(const SweepDescription& sweep, const Unknown& unknown, double place) {
  const std::size_t cells = cell_count(unknown.parameters, *sweep.sweep.points);
  return {value_at(unknown.parameters, place), part_of(place, cells)};
}

SweepPoint point_at(const SweepDescription& sweep, const std::vector<double>& places) {
  SweepPoint point;
  const std::vector<double> sorted = with_sorted_groups(sweep, places);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    point.emplace_back(place_at(sweep, sweep.unknowns[i], sorted[i]));
  }
  return point;
}

std::vector<SweepCell> sweep_cells(const SweepDescription& sweep, const Unknown& unknown) {
  std::vector<SweepCell> cells;
  const UnknownParameters& given = unknown.parameters;
  if (given.is_range() && !has_levels(sweep.sweep.design)) {
    const std::size_t parts = cell_count(given, *sweep.sweep.points);
    for (std::size_t i = 0; i < parts; ++i) cells.push_back(part_cell(given, i, parts));
    return cells;
  }
  for (std::size_t i = 0; i < level_count(given); ++i) {
    const Value value = at_level(given, i).value;
    cells.push_back({value, value});
  }
  return cells;
}

std::optional<double> place_in_range(const UnknownParameters& range, double number) {
  if (!range.is_range() || number < *range.low || number > *range.high) return {};
  if (range.scale == UnknownScale::kLinear) {
    return (number - *range.low) / (*range.high - *range.low);
  }
  const double low = natural_log(*range.low);
  return (natural_log(number) - low) / (natural_log(*range.high) - low);
}

}  // namespace somato
