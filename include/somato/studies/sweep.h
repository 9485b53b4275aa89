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

/// How the points of a sweep lie in the space of its unknowns.
enum class SweepDesign {
  kOneAtATime,      ///< The system as it stands, then each value of each unknown.
  kFullFactorial,   ///< All combinations of all values.
  kLatinHypercube,  ///< Random, with one point in each of equally many parts of each unknown.
  kSobol,           ///< Sobol's sequence, which fills the space evenly.
};

template <>
struct Choices<SweepDesign> {
  static const std::vector<std::pair<SweepDesign, std::string>>& all();
};

/// What the parts of a range that count alike have in common.
enum class UnknownScale {
  kLinear,       ///< Their difference.
  kLogarithmic,  ///< Their ratio.
};

template <>
struct Choices<UnknownScale> {
  static const std::vector<std::pair<UnknownScale, std::string>>& all();
};

/// The table [sweep]: how many points there are, and how often the system is run at each.
struct SweepParameters {
  SweepDesign design = SweepDesign::kOneAtATime;
  std::optional<std::size_t> points;
  std::size_t pairs = 6;
  std::size_t recordings = 2;
  std::uint64_t seed = 2011;

  static const Declarations<SweepParameters>& declarations();
};

/// A table [unknown.NAME]: a setting of the system that is not known, and what it may be.
struct UnknownParameters {
  std::vector<std::string> key;
  std::string text;
  std::vector<Value> values;
  std::optional<double> low;
  std::optional<double> high;
  UnknownScale scale = UnknownScale::kLinear;
  bool whole = false;
  std::optional<std::size_t> levels;

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
  Table changes;  ///< Of the system at every point: all other tables of the file.
};

/// The most points of a sweep.
inline constexpr std::size_t kMostSweepPoints = std::size_t{1} << 20;

/// Reads a sweep. Errors (kUsage) with their place: no table [sweep], no unknowns; unknown keys;
/// an unknown without key, text, or values or range, or with both; a range that is empty, or
/// logarithmic and not above 0; a value or key twice; keys that the design does not use; more than
/// kMostSweepPoints points.
Result<SweepDescription> read_sweep(const Table& file);

}  // namespace somato
