#include "somato/studies/claim.h"

#include <algorithm>
#include <utility>

#include "somato/studies/protocol.h"
#include "studies/metric_names.h"

namespace somato {
namespace {

// Differences of rounded values must not fail a bound that they meet.
constexpr double kClaimRounding = 1e-9;

bool holds(const Claim& claim, double value) {
  return (!claim.at_least || value >= *claim.at_least - kClaimRounding) &&
         (!claim.at_most || value <= *claim.at_most + kClaimRounding);
}

Result<Claim> read_claim(const Table& table) {
  auto claim = read_parameters<Claim>(table);
  if (!claim) return claim;
  claim->where = table.where;
  const auto refuse = [&](const std::string& what, const std::string& advice) {
    return fail(ErrorKind::kUsage, what, table.where, advice);
  };
  if (claim->text.empty()) return refuse("a claim needs its text", "add text = \"...\"");
  if (claim->metric.empty()) return refuse("a claim needs a metric", "add metric = \"accuracy\"");
  if (auto known = check_metric_name(claim->metric, table.where); !known) {
    return fail(std::move(known.error()));
  }
  if (auto known = choice_named<Protocol>("protocol", claim->protocol, table.where); !known) {
    return fail(std::move(known.error()));
  }
  if (!claim->at_least && !claim->at_most) {
    return refuse("a claim needs a bound", "add at_least = ... or at_most = ...");
  }
  return claim;
}

}  // namespace

const Declarations<Claim>& Claim::declarations() {
  using P = Claim;
  static const auto declared =
      Declarations<P>()
          .add("text", &P::text, "", Range::any(), "What is claimed, in one sentence.")
          .add("paper", &P::paper, "", Range::any(),
               "Paper and section; empty where no paper says it.")
          .add("system", &P::system, "", Range::any(),
               "Which system; empty: the one that the file is about.")
          .add("variation", &P::variation, "", Range::any(),
               "Which variation of it; empty: the system as it stands.")
          .add("metric", &P::metric, "", Range::any(), "Name of the metric in results.json.")
          .add("protocol", &P::protocol, "", Range::any(), "Under which protocol.")
          .add("group", &P::group, "", Range::any(), "Label of the groups of leave_group_out.")
          .add("than_system", &P::than_system, "", Range::any(),
               "Compared with which system, pair by pair; empty: the same one.")
          .add("than_variation", &P::than_variation, "", Range::any(),
               "Compared with which variation; empty with than_system: that system as it stands.")
          .add("published", &P::published, "", Range::any(),
               "The metric as the paper's one map shows it.")
          .add("at_least", &P::at_least, "", Range::any(),
               "Holds where the metric, or the difference, is not less.")
          .add("at_most", &P::at_most, "", Range::any(),
               "Holds where the metric, or the difference, is not more.");
  return declared;
}

Result<std::vector<Claim>> read_claims(const Table& file) {
  std::vector<Claim> claims;
  const Table::Entry* entry = file.find("claim");
  if (!entry) return claims;
  const auto* tables = std::get_if<std::vector<Table>>(&entry->content);
  if (!tables) {
    return fail(ErrorKind::kUsage, "claims are a list", entry->where,
                "write [[claim]] on a line of its own for each");
  }
  for (const Table& table : *tables) {
    auto claim = read_claim(table);
    if (!claim) return fail(std::move(claim.error()));
    claims.push_back(std::move(*claim));
  }
  return claims;
}

double ClaimOutcome::share() const {
  if (values.empty()) return 0.0;
  const auto holding = std::count_if(values.begin(), values.end(),
                                     [&](double value) { return holds(claim, value); });
  return static_cast<double>(holding) / static_cast<double>(values.size());
}

}  // namespace somato
