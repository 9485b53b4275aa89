#include "somato/studies/reproduction.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "somato/core/check.h"
#include "studies/results/fold_comparison.h"

namespace somato {
namespace {

// The measured metrics, as one text.
std::string measured(const std::vector<ProtocolResults>& protocols) {
  std::string text;
  for (const ProtocolResults& protocol : protocols) {
    text += protocol.protocol + " " + protocol.group + "\n";
    for (const Metric& metric : protocol.metrics) text += metric.name + "\n";
  }
  return text;
}

template <typename T>
void append(const std::vector<T>& found, std::vector<T>& all) {
  all.insert(all.end(), found.begin(), found.end());
}

void append(const ProtocolResults& found, ProtocolResults& all) {
  for (std::size_t i = 0; i < all.metrics.size(); ++i) {
    append(found.metrics[i].values, all.metrics[i].values);
    append(found.metrics[i].of_each, all.metrics[i].of_each);
  }
  append(found.runs, all.runs);
  for (const auto& [kind, folds] : found.chosen_neighbours) all.chosen_neighbours[kind] += folds;
  if (all.fold_comparison && found.fold_comparison) {
    add(*found.fold_comparison, *all.fold_comparison);
  }
}

// The part under the claim's protocol.
const ProtocolResults* find_protocol(const PartResults* part, const Claim& claim) {
  if (!part) return nullptr;
  const auto found = std::find_if(
      part->protocols.begin(), part->protocols.end(), [&](const ProtocolResults& protocol) {
        return protocol.protocol == claim.protocol && protocol.group == claim.group;
      });
  return found == part->protocols.end() ? nullptr : &*found;
}

// A comparison with a system of another file uses that system without a question.
const PartResults* find_part(const std::vector<PartResults>& parts, const std::string& question,
                             const std::string& system, const std::string& variation) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const PartResults& part) {
    return part.question == question && part.system == system && part.variation == variation;
  });
  return found == parts.end() ? nullptr : &*found;
}

std::vector<std::size_t> recordings_of(const PartResults& part) {
  std::vector<std::size_t> recordings;
  recordings.reserve(part.pairs.size());
  for (const Pair& pair : part.pairs) recordings.push_back(pair.recording);
  return recordings;
}

// The best value that the numbers of the explored individuals permit, which is the same in each
// pair.
std::optional<double> limit_of(const std::string& metric, const ProtocolResults& system) {
  for (const char* suffix : {"_greatest", "_least"}) {
    if (const Metric* limit = system.find_metric(metric + suffix)) return limit->mean();
  }
  return {};
}

void add_chance(const Claim& claim, const ProtocolResults& system, ClaimOutcome& outcome) {
  outcome.limit = limit_of(claim.metric, system);
  const Metric* by_chance = system.find_metric(claim.metric + "_chance");
  if (!by_chance) return;
  outcome.by_chance = by_chance->mean();
  outcome.chance_share = chance_share_of(claim, *by_chance);
  outcome.chance_range = chance_range_of(*by_chance);
}

std::optional<ClaimOutcome> judge_once(const Claim& claim, const std::vector<PartResults>& parts) {
  const PartResults* part = find_part(parts, claim.question, claim.system, claim.variation);
  const ProtocolResults* system = find_protocol(part, claim);
  const Metric* metric = system ? system->find_metric(claim.metric) : nullptr;
  if (!metric) return {};
  ClaimOutcome outcome{claim, metric->values, {}, {}, reason_undecidable(claim, *system)};
  outcome.recordings = recordings_of(*part);
  if (!claim.compares()) {
    add_chance(claim, *system, outcome);
    return outcome;
  }
  const PartResults* other_part =
      find_part(parts, claim.question, claim.than_system, claim.than_variation);
  const ProtocolResults* than = find_protocol(other_part, claim);
  const Metric* other = than ? than->find_metric(claim.other_metric()) : nullptr;
  if (!other || other->values.size() != metric->values.size()) return {};
  for (std::size_t i = 0; i < outcome.values.size(); ++i) outcome.values[i] -= other->values[i];
  if (other_part->recordings.size() < part->recordings.size()) {
    outcome.recordings = recordings_of(*other_part);
  }
  return outcome;
}

// The outcome of a claim about systems that were run, but without its metric.
ClaimOutcome not_measured(const Claim& claim, const std::vector<PartResults>& parts) {
  const ProtocolResults* system =
      find_protocol(find_part(parts, claim.question, claim.system, claim.variation), claim);
  const bool has_first = system && system->find_metric(claim.metric);
  const std::string& missing = has_first ? claim.other_metric() : claim.metric;
  return {claim, {}, {}, {}, "the metric '" + missing + "' was not measured"};
}

std::optional<ClaimOutcome> judge(const Claim& claim, const std::vector<PartResults>& parts) {
  auto outcome = judge_once(claim, parts);
  if (!outcome) return outcome;
  if (const auto second = claim.as_written()) {
    auto judged = judge_once(*second, parts);
    outcome->as_written.push_back(judged ? std::move(*judged) : not_measured(*second, parts));
  }
  return outcome;
}

}  // namespace

std::size_t pairs_of(std::size_t recording, std::size_t recordings, std::size_t pairs) {
  return pairs / recordings + (recording < pairs % recordings ? 1 : 0);
}

Result<void> add_results(const PartResults& found, PartResults& part) {
  require(!found.protocols.empty(), "a study needs an outcome for each of its protocols");
  const bool first = part.protocols.empty();
  if (!first && measured(found.protocols) != measured(part.protocols)) {
    return fail(
        ErrorKind::kData,
        "the recordings of '" + part.system + "' do not permit the same measurements", {},
        "use recordings with the same labels, or run the study for each recording separately");
  }
  for (const Pair& pair : found.pairs) {
    part.pairs.push_back({part.recordings.size() + pair.recording, pair.seed});
  }
  append(found.recordings, part.recordings);
  append(found.test_recordings, part.test_recordings);
  if (first) {
    part.study = found.study;
    part.parameters = found.parameters;
    part.protocols = found.protocols;
    return {};
  }
  for (std::size_t i = 0; i < found.protocols.size(); ++i) {
    append(found.protocols[i], part.protocols[i]);
  }
  return {};
}

std::vector<ClaimOutcome> judge(const std::vector<Claim>& claims,
                                const std::vector<PartResults>& parts) {
  std::vector<ClaimOutcome> outcomes;
  for (const Claim& claim : claims) {
    if (auto outcome = judge(claim, parts)) outcomes.push_back(std::move(*outcome));
  }
  return outcomes;
}

}  // namespace somato
