#include "report/claims_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

// What a claim compares with, in words.
std::string other_of(const Claim& claim) {
  if (!claim.compares()) return {};
  const std::string& system = claim.than_system.empty() ? claim.system : claim.than_system;
  if (claim.than_variation.empty()) return system;
  return system == claim.system ? claim.than_variation : system + ", " + claim.than_variation;
}

const SystemResults* protocol_of(const Claim& claim, const PartResults& part) {
  for (const SystemResults& protocol : part.protocols) {
    if (protocol.protocol == claim.protocol && protocol.group == claim.group) return &protocol;
  }
  return nullptr;
}

bool has_class(const SystemResults& protocol, const std::string& name) {
  return std::any_of(protocol.runs.begin(), protocol.runs.end(), [&](const Run& run) {
    return std::find(run.labels.begin(), run.labels.end(), name) != run.labels.end();
  });
}

// Why no map of these explorations could decide it, or nothing.
std::string reason_undecidable(const Claim& claim, const SystemResults& protocol) {
  if (claim.at_least && *claim.at_least > static_cast<double>(protocol.samples)) {
    return fmt::format("there are {} explorations", protocol.samples);
  }
  const std::string pair = "mapped_with ";
  if (!claim.metric.starts_with(pair)) return {};
  const std::string things = claim.metric.substr(pair.size());
  const std::size_t gap = things.find(' ');
  for (const std::string& name : {things.substr(0, gap), things.substr(gap + 1)}) {
    if (!has_class(protocol, name)) return "there is no '" + name + "'";
  }
  return {};
}

}  // namespace

ClaimsOfFile claims_of(const ResultsFile& file, const RecordingLayout& layout, OwnPlans& plans) {
  if (!file.is_study) return {file.claims, {}};
  ClaimsOfFile all;
  const PartResults& part = file.parts.front();
  const auto own = plans.find(part, layout);
  if (!own) return all;
  for (ClaimOutcome& outcome : judge(own->claims, file.parts)) {
    const SystemResults* protocol = protocol_of(outcome.claim, part);
    const std::string reason = protocol ? reason_undecidable(outcome.claim, *protocol) : "";
    if (!reason.empty()) {
      all.missing.push_back(
          fmt::format("The claim '{}' is left out: {}.", outcome.claim.text, reason));
      continue;
    }
    const double share = outcome.share();
    all.claims.push_back({std::move(outcome), share});
  }
  return all;
}

Json claim_json(const JudgedClaim& judged, const std::string& file) {
  const Claim& claim = judged.outcome.claim;
  return {{"file", file},
          {"question", claim.question},
          {"system", claim.system},
          {"variation", claim.variation},
          {"text", claim.text},
          {"paper", claim.paper},
          {"metric", claim.metric},
          {"protocol", claim.protocol},
          {"group", claim.group},
          {"than", other_of(claim)},
          {"published", number_or_null(claim.published)},
          {"at_least", number_or_null(claim.at_least)},
          {"at_most", number_or_null(claim.at_most)},
          {"values", judged.outcome.values},
          {"by_luck", number_or_null(judged.outcome.by_luck)},
          {"share", judged.share}};
}

}  // namespace somato::detail
