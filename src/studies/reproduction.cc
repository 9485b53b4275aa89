#include "somato/studies/reproduction.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "somato/core/check.h"
#include "studies/results_json.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kReproductionVersion = 1;

// What was measured, as one text.
std::string measured(const std::vector<SystemResults>& protocols) {
  std::string text;
  for (const SystemResults& protocol : protocols) {
    text += protocol.protocol + " " + protocol.group + "\n";
    for (const Metric& metric : protocol.metrics) text += metric.name + "\n";
  }
  return text;
}

void append(const SystemResults& found, SystemResults& all) {
  for (std::size_t i = 0; i < all.metrics.size(); ++i) {
    const std::vector<double>& values = found.metrics[i].values;
    all.metrics[i].values.insert(all.metrics[i].values.end(), values.begin(), values.end());
    const std::vector<Distribution>& of_each = found.metrics[i].of_each;
    all.metrics[i].of_each.insert(all.metrics[i].of_each.end(), of_each.begin(), of_each.end());
  }
  all.runs.insert(all.runs.end(), found.runs.begin(), found.runs.end());
}

// The part under the claim's protocol.
const SystemResults* find_protocol(const PartResults* part, const Claim& claim) {
  if (!part) return nullptr;
  const auto found = std::find_if(
      part->protocols.begin(), part->protocols.end(), [&](const SystemResults& protocol) {
        return protocol.protocol == claim.protocol && protocol.group == claim.group;
      });
  return found == part->protocols.end() ? nullptr : &*found;
}

// Compared with a system of another file, a claim looks at that one as it was run for itself.
const PartResults* find_part(const std::vector<PartResults>& parts, const std::string& question,
                             const std::string& system, const std::string& variation) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const PartResults& part) {
    return part.question == question && part.system == system && part.variation == variation;
  });
  return found == parts.end() ? nullptr : &*found;
}

std::optional<ClaimOutcome> judge(const Claim& claim, const std::vector<PartResults>& parts) {
  const SystemResults* system =
      find_protocol(find_part(parts, claim.question, claim.system, claim.variation), claim);
  const Metric* metric = system ? system->find_metric(claim.metric) : nullptr;
  if (!metric) return {};
  ClaimOutcome outcome{claim, metric->values, {}, {}, reason_undecidable(claim, *system)};
  if (!claim.compares()) {
    const Metric* luck = system->find_metric(claim.metric + "_by_luck");
    if (!luck) return outcome;
    outcome.by_luck = luck->mean();
    outcome.chance_share = chance_share_of(claim, *luck);
    return outcome;
  }
  const SystemResults* than = find_protocol(
      find_part(parts, claim.question, claim.than_system, claim.than_variation), claim);
  const Metric* other = than ? than->find_metric(claim.metric) : nullptr;
  if (!other || other->values.size() != metric->values.size()) return {};
  for (std::size_t i = 0; i < outcome.values.size(); ++i) outcome.values[i] -= other->values[i];
  return outcome;
}

Json recordings_json(const std::vector<RecordingInfo>& recordings) {
  Json json = Json::array();
  for (const RecordingInfo& recording : recordings) {
    json.push_back({{"name", recording.name},
                    {"source", recording.source},
                    {"seed", recording.seed},
                    {"data_hash", recording.data_hash},
                    {"explorations", recording.explorations}});
  }
  return json;
}

Json pairs_json(const std::vector<Pair>& pairs) {
  Json json = Json::array();
  for (const Pair& pair : pairs) json.push_back({pair.recording, pair.seed});
  return json;
}

Json parts_json(const std::vector<PartResults>& parts) {
  Json json = Json::array();
  for (const PartResults& part : parts) {
    Json protocols = Json::array();
    for (const SystemResults& protocol : part.protocols) {
      protocols.push_back(detail::system_json(protocol));
    }
    json.push_back({{"question", part.question},
                    {"system", part.system},
                    {"variation", part.variation},
                    {"settings", detail::settings_json(part.settings)},
                    {"recordings", part.recordings},
                    {"pairs", pairs_json(part.pairs)},
                    {"protocols", std::move(protocols)}});
  }
  return json;
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json claim_json(const ClaimOutcome& outcome) {
  const Metric values{outcome.claim.metric, outcome.values};
  Json json = detail::claim_json(outcome.claim);
  json["verdict"] = choice_name(outcome.verdict());
  json["reason"] = outcome.reason();
  json["share"] = outcome.share();
  json["mean"] = values.mean();
  json["sd"] = values.standard_deviation();
  json["by_luck"] = optional_json(outcome.by_luck);
  json["chance_share"] = optional_json(outcome.chance_share);
  json["pairs"] = outcome.values.size();
  return json;
}

}  // namespace

Json detail::claim_json(const Claim& claim) {
  Json json = {{"text", claim.text},           {"paper", claim.paper},
               {"question", claim.question},   {"system", claim.system},
               {"variation", claim.variation}, {"metric", claim.metric},
               {"protocol", claim.protocol},   {"group", claim.group}};
  if (claim.compares()) {
    json["than_system"] = claim.than_system;
    json["than_variation"] = claim.than_variation;
  }
  json["published"] = optional_json(claim.published);
  json["at_least"] = optional_json(claim.at_least);
  json["at_most"] = optional_json(claim.at_most);
  return json;
}

std::size_t pairs_of(std::size_t recording, std::size_t recordings, std::size_t pairs) {
  return pairs / recordings + (recording < pairs % recordings ? 1 : 0);
}

Result<void> add_results(const StudyResults& found, std::size_t recording, PartResults& part) {
  require(!found.systems.empty(), "a study finds something under each of its protocols");
  const bool first = part.protocols.empty();
  if (!first && measured(found.systems) != measured(part.protocols)) {
    return fail(ErrorKind::kData,
                "the recordings of '" + part.system + "' do not let the same things be measured",
                {}, "give recordings with the same labels, or each in a run of its own");
  }
  for (const Run& run : found.systems.front().runs) part.pairs.push_back({recording, run.seed});
  if (first) {
    part.protocols = found.systems;
    part.settings = found.settings;
    return {};
  }
  for (std::size_t i = 0; i < found.systems.size(); ++i) {
    append(found.systems[i], part.protocols[i]);
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

std::string to_json(const ReproductionResults& results) {
  Json claims = Json::array();
  for (const ClaimOutcome& outcome : results.claims) claims.push_back(claim_json(outcome));
  Json skipped = Json::array();
  for (const NotApplicable& one : results.not_applicable) {
    skipped.push_back({{"system", one.system}, {"reason", one.reason}});
  }
  const Json json = {{"version", kReproductionVersion},
                     {"seed", results.seed},
                     {"pairs", results.pairs},
                     {"recordings", recordings_json(results.recordings)},
                     {"systems", parts_json(results.parts)},
                     {"claims", std::move(claims)},
                     {"not_applicable", std::move(skipped)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace somato
