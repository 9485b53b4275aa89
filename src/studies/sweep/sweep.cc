#include "studies/sweep/sweep.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/core/contains.h"
#include "studies/sweep/sobol.h"
#include "studies/sweep/sweep_points.h"

namespace somato {
namespace {

constexpr const char* kSweep = "sweep";
constexpr const char* kUnknown = "unknown";

tl::unexpected<Error> refuse_unknown(const Unknown& unknown, const std::string& what,
                                     const std::string& advice) {
  return fail(ErrorKind::kUsage, "the unknown '" + unknown.name + "' " + what, unknown.where,
              advice);
}

Result<void> check_range(const Unknown& unknown) {
  const UnknownParameters& range = unknown.parameters;
  if (!range.high)
    return refuse_unknown(unknown, "has 'low', but no 'high'", "set both 'low' and 'high'");
  if (*range.low >= *range.high) {
    return refuse_unknown(unknown, "has an empty range", "set 'high' above 'low'");
  }
  if (range.scale == UnknownScale::kLogarithmic && *range.low <= 0.0) {
    return refuse_unknown(unknown, "is logarithmic, but its range includes 0 or negative numbers",
                          "set 'low' above 0");
  }
  if (!std::isfinite(*range.high - *range.low)) {
    return refuse_unknown(unknown, "has a range that is too wide", "use a smaller range");
  }
  if (!range.whole) return {};
  constexpr double kMostWhole = 0x1p53;  // from there on not every whole number is a double
  if (std::fabs(*range.low) >= kMostWhole || std::fabs(*range.high) >= kMostWhole) {
    return refuse_unknown(unknown, "has integers that are too large", "use limits below 2^53");
  }
  if (std::floor(*range.low) != *range.low || std::floor(*range.high) != *range.high) {
    return refuse_unknown(unknown, "requires integers, but its limits are not",
                          "use integers for 'low' and 'high'");
  }
  if (range.levels && static_cast<double>(*range.levels) > *range.high - *range.low + 1.0) {
    return refuse_unknown(unknown, "has more levels than its range has integers",
                          "use fewer levels");
  }
  return {};
}

Result<void> check_values(const Unknown& unknown) {
  const UnknownParameters& given = unknown.parameters;
  if (given.high || given.scale != UnknownScale::kLinear || given.whole || given.levels) {
    return refuse_unknown(unknown, "has both 'values' and keys of a range",
                          "use either 'values', or 'low' and 'high'");
  }
  std::set<std::string> seen;
  for (const Value& value : given.values) {
    if (seen.insert(to_toml(value)).second) continue;
    return refuse_unknown(unknown, "has the value " + to_toml(value) + " twice", "list it once");
  }
  return {};
}

Result<void> check_unknown(const Unknown& unknown) {
  const UnknownParameters& given = unknown.parameters;
  if (given.key.empty()) {
    return refuse_unknown(unknown, "has no key", R"(add key = "module.NAME.PARAMETER")");
  }
  if (given.text.empty()) {
    return refuse_unknown(unknown, "does not explain its values", R"(add text = "...")");
  }
  if (given.is_range() != given.values.empty()) {
    return refuse_unknown(unknown, given.is_range() ? "has values and a range" : "has no values",
                          "use either 'values', or 'low' and 'high'");
  }
  return given.is_range() ? check_range(unknown) : check_values(unknown);
}

Result<std::vector<Unknown>> read_unknowns(const Table& file) {
  std::vector<Unknown> unknowns;
  const Table::Entry* entry = file.find(kUnknown);
  const auto* tables = entry ? std::get_if<Table>(&entry->content) : nullptr;
  if (!tables || tables->entries.empty()) {
    return fail(ErrorKind::kUsage, "a sweep requires unknowns", entry ? entry->where : file.where,
                "add a table [unknown.NAME] for each");
  }
  for (const Table::Entry& one : tables->entries) {
    const auto* table = std::get_if<Table>(&one.content);
    if (!table) {
      return fail(ErrorKind::kUsage, "'" + one.name + "' must be a table", one.where,
                  "write [unknown." + one.name + "] on a separate line, its keys below");
    }
    SOMATO_TRY(auto parameters, read_parameters<UnknownParameters>(*table));
    unknowns.push_back({one.name, table->where, std::move(parameters)});
    SOMATO_TRY_VOID(check_unknown(unknowns.back()));
  }
  return unknowns;
}

// Whether a system may have both.
bool share_a_system(const UnknownParameters& a, const UnknownParameters& b) {
  return a.systems.empty() || b.systems.empty() ||
         std::any_of(a.systems.begin(), a.systems.end(),
                     [&](const std::string& system) { return b.is_of(system); });
}

Result<void> check_keys(const std::vector<Unknown>& unknowns) {
  std::map<std::string, std::vector<const Unknown*>> seen;
  for (const Unknown& unknown : unknowns) {
    for (const std::string& key : unknown.parameters.key) {
      for (const Unknown* other : seen[key]) {
        if (!share_a_system(other->parameters, unknown.parameters)) continue;
        return refuse_unknown(unknown, "varies '" + key + "', which is already varied",
                              "use each key once for each system");
      }
      seen[key].push_back(&unknown);
    }
  }
  return {};
}

// The number of values among which equal places choose equal numbers; 0: a range of real numbers.
std::size_t count_of_values(const UnknownParameters& unknown) {
  if (!unknown.is_range()) return unknown.values.size();
  return unknown.whole ? static_cast<std::size_t>(*unknown.high - *unknown.low) + 1 : 0;
}

Result<void> check_increasing(const SweepDescription& sweep) {
  std::map<std::string, std::size_t> counts;
  for (const Unknown& unknown : sweep.unknowns) {
    const std::string& group = unknown.parameters.increasing;
    if (group.empty()) continue;
    if (has_levels(sweep.sweep.design)) {
      return refuse_unknown(
          unknown, "is increasing, but '" + choice_name(sweep.sweep.design) + "' has levels",
          R"(use the design "sobol" or "latin_hypercube")");
    }
    const std::size_t count = count_of_values(unknown.parameters);
    if (counts.emplace(group, count).first->second == count) continue;
    return refuse_unknown(unknown, "has more or fewer values than the others of '" + group + "'",
                          "use the same number of values");
  }
  return {};
}

// Rounding may make one whole number of two levels.
Result<void> check_levels(const SweepDescription& sweep) {
  for (const Unknown& unknown : sweep.unknowns) {
    std::set<std::string> seen;
    for (const SweepCell& cell : sweep_cells(sweep, unknown)) {
      if (seen.insert(to_toml(cell.from)).second) continue;
      return refuse_unknown(unknown, "has the level " + to_toml(cell.from) + " twice",
                            "use fewer levels, or 'values'");
    }
  }
  return {};
}

Result<void> check_design(const SweepDescription& sweep, const std::string& where) {
  const auto refuse = [&](const std::string& what, const std::string& advice) {
    return fail(ErrorKind::kUsage, what, where, advice);
  };
  const std::string name = "'" + choice_name(sweep.sweep.design) + "'";
  if (has_levels(sweep.sweep.design) == sweep.sweep.points.has_value()) {
    return sweep.sweep.points ? refuse("the points of " + name + " follow from its levels",
                                       "remove 'points', or use another design")
                              : refuse(name + " requires 'points'", "add points = 64");
  }
  if (sweep.sweep.design == SweepDesign::kSobol && sweep.unknowns.size() > kSobolDimensions) {
    return refuse("Sobol' points support at most " + std::to_string(kSobolDimensions) + " unknowns",
                  "use fewer unknowns, or the design \"latin_hypercube\"");
  }
  if (sweep.sweep.stock && *sweep.sweep.stock < sweep.sweep.recordings) {
    return refuse("the stock has fewer recordings than a point",
                  "set 'stock' to at least " + std::to_string(sweep.sweep.recordings));
  }
  SOMATO_TRY_VOID(check_increasing(sweep));
  if (point_count(sweep) > kMostSweepPoints) {
    return refuse("the sweep has more than " + std::to_string(kMostSweepPoints) + " points",
                  "use fewer levels, or another design");
  }
  return check_levels(sweep);
}

}  // namespace

const std::vector<std::pair<SweepDesign, std::string>>& Choices<SweepDesign>::all() {
  static const std::vector<std::pair<SweepDesign, std::string>> designs{
      {SweepDesign::kOneAtATime, "one_at_a_time"},
      {SweepDesign::kFullFactorial, "full_factorial"},
      {SweepDesign::kLatinHypercube, "latin_hypercube"},
      {SweepDesign::kSobol, "sobol"}};
  return designs;
}

const std::vector<std::pair<UnknownScale, std::string>>& Choices<UnknownScale>::all() {
  static const std::vector<std::pair<UnknownScale, std::string>> scales{
      {UnknownScale::kLinear, "linear"}, {UnknownScale::kLogarithmic, "logarithmic"}};
  return scales;
}

const Declarations<SweepParameters>& SweepParameters::declarations() {
  using P = SweepParameters;
  static const auto declared =
      Declarations<P>()
          .add("design", &P::design, "", Range::any(), "Design of the points. Required.")
          .add("points", &P::points, "", Range::between(2, static_cast<double>(kMostSweepPoints)),
               "Number of points of latin_hypercube and sobol, for sobol preferably a power of "
               "two; in the other designs it follows from the unknowns.")
          .add("pairs", &P::pairs, "", Range::between(1, 1e6),
               "Number of pairs of recording and seed at each point.")
          .add("recordings", &P::recordings, "", Range::between(1, 1e6),
               "Number of independent recordings among the pairs.")
          .add("seed", &P::seed, "", Range::any(),
               "First seed of exploration and training, and the seed of latin_hypercube.")
          .add("stock", &P::stock, "", Range::between(1, 1e6),
               "Number of recordings with true values that are explored once, with each setting "
               "that changes what is explored; each point plays its sensors on recordings of this "
               "stock. Automatic: each point explores.");
  return declared;
}

bool UnknownParameters::is_of(const std::string& system) const {
  return systems.empty() || contains(systems, system);
}

const Declarations<UnknownParameters>& UnknownParameters::declarations() {
  using P = UnknownParameters;
  static const auto declared =
      Declarations<P>()
          .add("key", &P::key, "", Range::any(),
               "Key that is varied, such as \"module.map.learning_rate_start\" or "
               "\"explore.simulation.placement_noise\"; or several keys, which receive the same "
               "value. Required.")
          .add("text", &P::text, "", Range::any(), "Explanation of the values. Required.")
          .add("values", &P::values, "", Range::any(),
               "Possible values: numbers, texts or booleans; instead of low and high.")
          .add("low", &P::low, "", Range::any(), "Lower limit of the range.")
          .add("high", &P::high, "", Range::any(), "The greatest.")
          .add("scale", &P::scale, "", Range::any(),
               "Scale on which values are distributed evenly.")
          .add("whole", &P::whole, "", Range::any(), "Whether the value is an integer.")
          .add("levels", &P::levels, "", Range::between(2, 1e4),
               "In one_at_a_time and full_factorial: number of values from low to high, 5 by "
               "default. In the other designs: number of parts into which the results divide the "
               "range; by default the square root of the number of points, at most 8.")
          .add("systems", &P::systems, "", Range::any(),
               "Names of the systems to which it applies; empty: all.")
          .add("increasing", &P::increasing, "", Range::any(),
               "Name of a group of unknowns whose places in their ranges, or among their values, "
               "increase from the first in the file to the last: those of a point are sorted.");
  return declared;
}

Result<SweepDescription> read_sweep(const Table& file) {
  SweepDescription sweep;
  const Table::Entry* entry = file.find(kSweep);
  const auto* table = entry ? std::get_if<Table>(&entry->content) : nullptr;
  if (!table || !table->find("design")) {
    return fail(ErrorKind::kUsage, "a sweep requires a design", entry ? entry->where : file.where,
                R"(add a table [sweep] with design = "one_at_a_time", or another)");
  }
  SOMATO_TRY(auto parameters, read_parameters<SweepParameters>(*table));
  sweep.sweep = parameters;
  SOMATO_TRY(auto unknowns, read_unknowns(file));
  sweep.unknowns = std::move(unknowns);
  sweep.changes.where = file.where;
  for (const Table::Entry& other : file.entries) {
    if (other.name != kSweep && other.name != kUnknown) sweep.changes.entries.push_back(other);
  }
  auto right =
      check_keys(sweep.unknowns).and_then([&] { return check_design(sweep, table->where); });
  if (!right) return fail(std::move(right.error()));
  return sweep;
}

}  // namespace somato
