#include "report/claims_json.h"

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

}  // namespace

std::vector<JudgedClaim> claims_of(const ResultsFile& file, const RecordingLayout& layout,
                                   OwnPlans& plans) {
  if (!file.is_study) return file.claims;
  const auto own = plans.find(file.parts.front(), layout);
  if (!own) return {};
  std::vector<JudgedClaim> all;
  for (ClaimOutcome& outcome : judge(own->claims, file.parts)) {
    const double share = outcome.share();
    all.push_back({std::move(outcome), share});
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
          {"chance_share", number_or_null(judged.outcome.chance_share)},
          {"verdict", choice_name(judged.outcome.verdict())},
          {"reason", judged.outcome.reason()},
          {"share", judged.share}};
}

}  // namespace somato::detail
