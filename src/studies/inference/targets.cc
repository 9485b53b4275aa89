#include "studies/inference/targets.h"

#include <algorithm>
#include <utility>

#include "base/core/contains.h"
#include "studies/results/metric_table.h"
#include "studies/sweep/sweep_points.h"

namespace somato {
namespace {

tl::unexpected<Error> refuse_target(const Target& target, const std::string& what,
                                    const std::string& advice) {
  return fail(ErrorKind::kUsage, "the target " + what, target.where, advice);
}

Result<void> check_target(const Target& target) {
  if (target.text.empty()) return refuse_target(target, "has no text", "add text = \"...\"");
  if (target.system.empty()) return refuse_target(target, "has no system", "add system = \"...\"");
  if (target.metric.empty()) return refuse_target(target, "has no metric", "add metric = \"...\"");
  SOMATO_TRY_VOID(check_metric_name(target.metric, target.where));
  SOMATO_TRY_VOID(choice_named<Protocol>("protocol", target.protocol, target.where));
  if (!target.observed) return refuse_target(target, "has no observed value", "add observed = ...");
  if (!target.scale) {
    return refuse_target(target, "has no scale", "add scale = ..., a difference that counts as 1");
  }
  return {};
}

bool have_same_measure(const Target& a, const Target& b) {
  return a.system == b.system && a.variation == b.variation && a.metric == b.metric &&
         a.protocol == b.protocol && a.group == b.group;
}

Result<std::vector<Target>> read_target_list(const Table& file) {
  std::vector<Target> targets;
  const Table::Entry* entry = file.find("target");
  const auto* tables = entry ? std::get_if<std::vector<Table>>(&entry->content) : nullptr;
  if (!tables || tables->empty()) {
    return fail(ErrorKind::kUsage, "there are no targets", entry ? entry->where : file.where,
                "add a table [[target]] for each observed value");
  }
  for (const Table& table : *tables) {
    SOMATO_TRY(auto target, read_parameters<Target>(table));
    target.where = table.where;
    SOMATO_TRY_VOID(check_target(target));
    for (const Target& other : targets) {
      if (!have_same_measure(target, other)) continue;
      return refuse_target(target, "has the same measure as '" + other.text + "'",
                           "remove one of them");
    }
    targets.push_back(std::move(target));
  }
  return targets;
}

Claim measure_of(const Target& target) {
  Claim measure;
  measure.text = target.text;
  measure.paper = target.paper;
  measure.system = target.system;
  measure.variation = target.variation;
  measure.metric = target.metric;
  measure.protocol = target.protocol;
  measure.group = target.group;
  measure.published = target.observed;
  measure.where = target.where;
  return measure;
}

bool has_protocol(const StudyParameters& study, const Target& target) {
  const bool runs =
      std::any_of(study.protocols.begin(), study.protocols.end(),
                  [&](Protocol protocol) { return choice_name(protocol) == target.protocol; });
  return runs && (target.group.empty() || contains(study.groups, target.group));
}

Result<void> check_swept(const Target& target, const std::vector<ReproductionPart>& parts) {
  std::vector<std::string> systems;
  std::vector<std::string> variations;
  for (const ReproductionPart& part : parts) {
    if (!contains(systems, part.system)) systems.push_back(part.system);
    if (part.system == target.system) variations.push_back(part.variation);
  }
  if (!contains(systems, target.system)) {
    return fail(unknown_name("system of the sweep", target.system, target.where, systems));
  }
  if (!contains(variations, target.variation)) {
    return fail(unknown_name("variation", target.variation, target.where, variations));
  }
  const auto measures = [&](const ReproductionPart& part) {
    return part.system == target.system && part.variation == target.variation &&
           has_protocol(part.description.study, target);
  };
  if (std::any_of(parts.begin(), parts.end(), measures)) return {};
  return refuse_target(target,
                       "has the protocol '" + target.protocol + "', which the system does not run",
                       "add it to 'protocols' of [study] in the file of the sweep");
}

// The seeds of explorations and trainings are consecutive.
bool overlap(std::uint64_t a, std::size_t count_a, std::uint64_t b, std::size_t count_b) {
  return a < b ? b - a < count_a : a - b < count_b;
}

}  // namespace

const Declarations<InferenceParameters>& InferenceParameters::declarations() {
  using P = InferenceParameters;
  static const auto declared =
      Declarations<P>()
          .add("accepted", &P::accepted, "", Range::between(1e-6, 1.0),
               "Share of the simulated maps that are accepted: those nearest to the targets.")
          .add("adjusted", &P::adjusted, "", Range::any(),
               "Whether accepted settings are adjusted by local linear regression on the "
               "differences from the targets; those of a match, by what predicts them.")
          .add("truths", &P::truths, "", Range::between(0, 1e6),
               "Number of simulated maps that are inferred as if they had been observed, to check "
               "the intervals.")
          .add("bodies", &P::bodies, "", Range::between(1, 1e6),
               "Number of accepted settings that are run again, with fresh seeds.")
          .add("pairs", &P::pairs, "", Range::between(1, 1e6),
               "Number of pairs of recording and seed of each of them; each pair has its own "
               "recording.")
          .add("seed", &P::seed, "", Range::any(),
               "First fresh seed of exploration and training, and the seed of random selections.");
  return declared;
}

const Declarations<Target>& Target::declarations() {
  using P = Target;
  static const auto declared =
      Declarations<P>()
          .add("text", &P::text, "", Range::any(), "The observation, in one sentence. Required.")
          .add("paper", &P::paper, "", Range::any(), "Paper and section it is from.")
          .add("system", &P::system, "", Range::any(), "Name of the system. Required.")
          .add("variation", &P::variation, "", Range::any(),
               "Variation of the system; default: the unchanged system.")
          .add("metric", &P::metric, "", Range::any(), "Metric of one map. Required.")
          .add("protocol", &P::protocol, "", Range::any(), "Protocol of the metric.")
          .add("group", &P::group, "", Range::any(),
               "Group of the protocol that leaves groups out.")
          .add("observed", &P::observed, "", Range::any(), "Observed value. Required.")
          .add("scale", &P::scale, "", Range::above(0.0),
               "Difference from the observed value that counts as 1. Required.");
  return declared;
}

Observation Targets::observation() const {
  Observation observed;
  for (const Target& target : targets) {
    observed.values.push_back(*target.observed);
    observed.scales.push_back(*target.scale);
  }
  return observed;
}

Result<Targets> read_targets(const Table& file) {
  Targets read;
  for (const Table::Entry& entry : file.entries) {
    if (entry.name != "inference" && entry.name != "target") {
      return fail(unknown_name("table", entry.name, entry.where, {"inference", "target"}));
    }
  }
  const Table::Entry* entry = file.find("inference");
  if (const auto* table = entry ? std::get_if<Table>(&entry->content) : nullptr) {
    SOMATO_TRY(auto parameters, read_parameters<InferenceParameters>(*table));
    read.inference = parameters;
  } else if (entry) {
    return fail(ErrorKind::kUsage, "'inference' must be a table", entry->where,
                "write [inference] on a separate line");
  }
  SOMATO_TRY(auto targets, read_target_list(file));
  read.targets = std::move(targets);
  return read;
}

Result<void> check_inferable(const InferenceParameters& inference, const SweepParameters& sweep,
                             std::size_t drawn, std::size_t fresh, const std::string& where) {
  if (has_levels(sweep.design)) {
    return fail(ErrorKind::kUsage,
                "an inference requires a sweep in which all unknowns vary at once", where,
                R"(use the design "sobol" or "latin_hypercube" with 'points')");
  }
  if (!overlap(sweep.seed, drawn, inference.seed, fresh)) return {};
  return fail(ErrorKind::kUsage, "the fresh seeds are among those of the sweep", where,
              "set 'seed' of [inference] to " + std::to_string(sweep.seed + drawn) + " or more");
}

bool is_about(const Claim& claim, const Target& target) {
  if (claim.protocol != target.protocol || claim.group != target.group) return false;
  const auto is_measure = [&](const std::string& system, const std::string& variation,
                              const std::string& metric) {
    return system == target.system && variation == target.variation && metric == target.metric;
  };
  if (is_measure(claim.system, claim.variation, claim.metric)) return true;
  return claim.compares() &&
         is_measure(claim.than_system.empty() ? claim.system : claim.than_system,
                    claim.than_variation, claim.other_metric());
}

Result<void> add_targets(const Targets& targets, SystemSweep& sweep) {
  const std::string& where = targets.targets.front().where;
  const SweepParameters& draws = sweep.sweep.sweep;
  SOMATO_TRY_VOID(check_inferable(
      targets.inference, draws, draws.points.value_or(0) * std::max(draws.pairs, draws.recordings),
      targets.inference.bodies * targets.inference.pairs, where));
  ReproductionPlan plan;
  for (const NamedFile& file : sweep.files) {
    SOMATO_TRY_VOID(add_to_plan(file, {}, plan));
  }
  for (const Target& target : targets.targets) {
    SOMATO_TRY_VOID(check_swept(target, plan.parts));
    sweep.measured.push_back(measure_of(target));
  }
  return {};
}

}  // namespace somato
