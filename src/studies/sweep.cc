#include "somato/studies/sweep.h"

#include <cmath>
#include <set>
#include <utility>

#include "somato/studies/sobol.h"
#include "somato/studies/sweep_points.h"

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
  if (!range.high) return refuse_unknown(unknown, "has no high", "give both low and high");
  if (*range.low >= *range.high) {
    return refuse_unknown(unknown, "has an empty range", "give a high that is more than low");
  }
  if (range.scale == UnknownScale::kLogarithmic && *range.low <= 0.0) {
    return refuse_unknown(unknown, "is logarithmic down to 0 or below", "give a low above 0");
  }
  if (!std::isfinite(*range.high - *range.low)) {
    return refuse_unknown(unknown, "has too wide a range", "give other ends");
  }
  if (!range.whole) return {};
  constexpr double kMostWhole = 0x1p53;  // from there on not every whole number is a double
  if (std::fabs(*range.low) >= kMostWhole || std::fabs(*range.high) >= kMostWhole) {
    return refuse_unknown(unknown, "has whole numbers that are too large",
                          "give ends of less than 2^53");
  }
  if (std::floor(*range.low) != *range.low || std::floor(*range.high) != *range.high) {
    return refuse_unknown(unknown, "has whole numbers between two that are not",
                          "give whole numbers as low and high");
  }
  if (range.levels && static_cast<double>(*range.levels) > *range.high - *range.low + 1.0) {
    return refuse_unknown(unknown, "has more levels than there are whole numbers",
                          "give fewer levels");
  }
  return {};
}

Result<void> check_values(const Unknown& unknown) {
  const UnknownParameters& given = unknown.parameters;
  if (given.high || given.scale != UnknownScale::kLinear || given.whole || given.levels) {
    return refuse_unknown(unknown, "has values and keys of a range",
                          "give either values, or low and high");
  }
  std::set<std::string> seen;
  for (const Value& value : given.values) {
    if (seen.insert(to_toml(value)).second) continue;
    return refuse_unknown(unknown, "has the value " + to_toml(value) + " twice", "give it once");
  }
  return {};
}

Result<void> check_unknown(const Unknown& unknown) {
  const UnknownParameters& given = unknown.parameters;
  if (given.key.empty()) {
    return refuse_unknown(unknown, "has no key", R"(add key = "module.NAME.PARAMETER")");
  }
  if (given.text.empty()) {
    return refuse_unknown(unknown, "does not say why these values", R"(add text = "...")");
  }
  if (given.is_range() != given.values.empty()) {
    return refuse_unknown(unknown, given.is_range() ? "has values and a range" : "has no values",
                          "give either values, or low and high");
  }
  return given.is_range() ? check_range(unknown) : check_values(unknown);
}

Result<std::vector<Unknown>> read_unknowns(const Table& file) {
  std::vector<Unknown> unknowns;
  const Table::Entry* entry = file.find(kUnknown);
  const auto* tables = entry ? std::get_if<Table>(&entry->content) : nullptr;
  if (!tables || tables->entries.empty()) {
    return fail(ErrorKind::kUsage, "a sweep needs unknowns", entry ? entry->where : file.where,
                "write [unknown.NAME] on a line of its own for each");
  }
  for (const Table::Entry& one : tables->entries) {
    const auto* table = std::get_if<Table>(&one.content);
    if (!table) {
      return fail(ErrorKind::kUsage, "'" + one.name + "' must be a table", one.where,
                  "write [unknown." + one.name + "] on a line of its own, its keys below");
    }
    auto parameters = read_parameters<UnknownParameters>(*table);
    if (!parameters) return fail(std::move(parameters.error()));
    unknowns.push_back({one.name, table->where, std::move(*parameters)});
    if (auto right = check_unknown(unknowns.back()); !right) return fail(std::move(right.error()));
  }
  return unknowns;
}

Result<void> check_keys(const std::vector<Unknown>& unknowns) {
  std::set<std::string> seen;
  for (const Unknown& unknown : unknowns) {
    for (const std::string& key : unknown.parameters.key) {
      if (seen.insert(key).second) continue;
      return refuse_unknown(unknown, "moves '" + key + "', which is moved already",
                            "name each key once");
    }
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
                            "give fewer levels, or values");
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
                                       "leave points out, or give another design")
                              : refuse(name + " needs a number of points", "add points = 64");
  }
  if (sweep.sweep.design == SweepDesign::kSobol && sweep.unknowns.size() > kSobolDimensions) {
    return refuse("Sobol' points have up to " + std::to_string(kSobolDimensions) + " unknowns",
                  "give fewer, or \"latin_hypercube\"");
  }
  if (point_count(sweep) > kMostSweepPoints) {
    return refuse("the sweep has more than " + std::to_string(kMostSweepPoints) + " points",
                  "give fewer levels, or another design");
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
          .add("design", &P::design, "", Range::any(), "How the points lie. Has to be given.")
          .add("points", &P::points, "", Range::between(2, static_cast<double>(kMostSweepPoints)),
               "How many points latin_hypercube and sobol have, best a power of two for sobol; "
               "those of the other designs follow from the unknowns.")
          .add("pairs", &P::pairs, "", Range::between(1, 1e6),
               "Pairs of recording and seed at each point.")
          .add("recordings", &P::recordings, "", Range::between(1, 1e6),
               "Independent recordings they are spread over.")
          .add("seed", &P::seed, "", Range::any(),
               "First seed of exploring and of training, and the seed of latin_hypercube.");
  return declared;
}

const Declarations<UnknownParameters>& UnknownParameters::declarations() {
  using P = UnknownParameters;
  static const auto declared =
      Declarations<P>()
          .add("key", &P::key, "", Range::any(),
               "The key that it moves, such as \"module.map.learning_rate_start\" or "
               "\"explore.simulation.placement_noise\"; or several, which are given the same "
               "value. Has to be given.")
          .add("text", &P::text, "", Range::any(), "Why these values. Has to be given.")
          .add("values", &P::values, "", Range::any(),
               "What it may be: numbers, texts or switches; in place of low and high.")
          .add("low", &P::low, "", Range::any(), "The least number it may be.")
          .add("high", &P::high, "", Range::any(), "The greatest.")
          .add("scale", &P::scale, "", Range::any(),
               "Whether equal differences or equal ratios count alike.")
          .add("whole", &P::whole, "", Range::any(), "Whether it is a whole number.")
          .add("levels", &P::levels, "", Range::between(2, 1e4),
               "Of one_at_a_time and full_factorial: how many values from low to high, 5 unless "
               "given. Of the others: into how many parts the results divide the range, the square "
               "root of the points and at most 8 unless given.");
  return declared;
}

Result<SweepDescription> read_sweep(const Table& file) {
  SweepDescription sweep;
  const Table::Entry* entry = file.find(kSweep);
  const auto* table = entry ? std::get_if<Table>(&entry->content) : nullptr;
  if (!table || !table->find("design")) {
    return fail(ErrorKind::kUsage, "a sweep needs a design", entry ? entry->where : file.where,
                R"(add a table [sweep] with design = "one_at_a_time", or another)");
  }
  auto parameters = read_parameters<SweepParameters>(*table);
  if (!parameters) return fail(std::move(parameters.error()));
  sweep.sweep = *parameters;
  auto unknowns = read_unknowns(file);
  if (!unknowns) return fail(std::move(unknowns.error()));
  sweep.unknowns = std::move(*unknowns);
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
