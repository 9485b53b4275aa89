#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/value.h"

namespace somato {

/// Design of the points of a sweep in the space of its unknowns.
enum class SweepDesign {
  kOneAtATime,      ///< The unchanged system, then each value of each unknown.
  kFullFactorial,   ///< All combinations of all values.
  kLatinHypercube,  ///< Random, with one point in each of the equal parts of each unknown.
  kSobol,           ///< Sobol's sequence, which fills the space uniformly.
};

template <>
struct Choices<SweepDesign> {
  static const std::vector<std::pair<SweepDesign, std::string>>& all();
};

/// Scale on which the values of a range are distributed evenly.
enum class UnknownScale {
  kLinear,       ///< Equal differences.
  kLogarithmic,  ///< Equal ratios.
};

template <>
struct Choices<UnknownScale> {
  static const std::vector<std::pair<UnknownScale, std::string>>& all();
};

/// The table [sweep]: the number of points, and the number of runs at each.
struct SweepParameters {
  SweepDesign design = SweepDesign::kOneAtATime;
  std::optional<std::size_t> points;
  std::size_t pairs = 6;
  std::size_t recordings = 2;
  std::uint64_t seed = 2011;
  std::optional<std::size_t> stock;

  static const Declarations<SweepParameters>& declarations();
};

/// A table [unknown.NAME]: an unknown setting of the system, and its possible values.
struct UnknownParameters {
  std::vector<std::string> key;
  std::string text;
  std::vector<Value> values;
  std::optional<double> low;
  std::optional<double> high;
  UnknownScale scale = UnknownScale::kLinear;
  bool whole = false;
  std::optional<std::size_t> levels;
  std::vector<std::string> systems;
  std::string increasing;

  /// Whether it has this key in the system with that name.
  bool is_of(const std::string& system) const;

  /// Whether it is a range, from low to high.
  bool is_range() const { return low.has_value(); }

  static const Declarations<UnknownParameters>& declarations();
};

/// The same with its name.
struct Unknown {
  std::string name;
  std::string where;  ///< `file:line` of its table.
  UnknownParameters parameters;
};

/// A sweep, as its file describes it.
struct SweepDescription {
  SweepParameters sweep;
  std::vector<Unknown> unknowns;
  Table changes;  ///< Changes of the system at every point: all other tables of the file.
};

/// The maximum number of points of a sweep.
inline constexpr std::size_t kMostSweepPoints = std::size_t{1} << 20;

/// Reads a sweep. Errors (kUsage) with their location: no table [sweep], no unknowns; unknown keys;
/// an unknown without key or text, without values and range, or with both; a range that is empty,
/// or logarithmic and not above 0; a duplicate value, or a key twice for one system; keys that the
/// design does not use; increasing unknowns with different numbers of values; a stock with fewer
/// recordings than a point; more than kMostSweepPoints points.
Result<SweepDescription> read_sweep(const Table& file);

}  // namespace somato
