#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <tuple>

#include "somato/graph/system_model.h"
#include "somato/studies/own_systems.h"

namespace somato {
namespace {

constexpr std::size_t kFewestPairs = 20;

// Words of texts that are true of equal systems as well.
constexpr std::array kIncluding{"at least as many", "At least as many", "does not reduce",
                                "does not increase", "At most one exploration fewer"};

// The nine systems, and the questions but for the one that only looks at settings.
ReproductionPlan plan_of_claims() {
  const OwnSystems own = own_systems().value();
  ReproductionPlan plan;
  for (const NamedFile& file : own.systems) {
    EXPECT_TRUE(add_to_plan(file, own.systems, plan)) << file.name;
  }
  for (const NamedFile& file : own.questions) {
    if (!file.content.find("claim")) continue;
    EXPECT_TRUE(add_to_plan(file, own.systems, plan)) << file.name;
  }
  return plan;
}

TEST(OwnSystemsClaims, HoldForThePapersOwnOutcome) {
  for (const Claim& claim : plan_of_claims().claims) {
    if (!claim.published) continue;
    EXPECT_LE(claim.at_least.value_or(*claim.published), *claim.published) << claim.where;
    EXPECT_GE(claim.at_most.value_or(*claim.published), *claim.published) << claim.where;
  }
}

// A count of one system that is neither none nor a share of 1 must be able to fail on either side.
TEST(OwnSystemsClaims, HaveTwoSidesWhereAPaperCounts) {
  const std::set<std::string> shares{"individuals_apart", "order_within",
                                     "placed_with_most_similar"};
  for (const Claim& claim : plan_of_claims().claims) {
    const bool is_share = shares.contains(claim.metric) || claim.metric.ends_with("accuracy") ||
                          claim.metric.ends_with("areas_connected");
    if (!claim.published || *claim.published <= 0.0 || is_share || claim.compares()) continue;
    EXPECT_EQ(claim.at_least, *claim.published - (*claim.published > 1.0 ? 1.0 : 0.0))
        << claim.where;
    EXPECT_EQ(claim.at_most, *claim.published + 1.0) << claim.where;
  }
}

// A count plus or minus one is a count of one map.
TEST(OwnSystemsClaims, JudgeCountsOfOneMapByTheirRange) {
  std::size_t counts = 0;
  for (const Claim& claim : plan_of_claims().claims) {
    const bool is_count =
        claim.is_of_paper() && claim.at_least && claim.at_most && !claim.compares();
    EXPECT_EQ(claim.judged_by == ClaimCriterion::kCentralRange, is_count) << claim.where;
    counts += is_count ? 1 : 0;
  }
  EXPECT_EQ(counts, 12U);
}

// Decision 43 lists them.
TEST(OwnSystemsClaims, JudgeOnlyClaimsOfPapersAgain) {
  std::size_t means = 0;
  std::size_t exceptions = 0;
  std::size_t contradicted = 0;
  for (const Claim& claim : plan_of_claims().claims) {
    EXPECT_TRUE(claim.is_of_paper() || !claim.as_written()) << claim.where;
    means += claim.judged_by == ClaimCriterion::kMean ? 1 : 0;
    exceptions += claim.judged_metric.starts_with("exceptions") ? 1 : 0;
    contradicted += claim.contradicted_by.empty() ? 0 : 1;
  }
  EXPECT_EQ(means, 28U);
  EXPECT_EQ(exceptions, 4U);
  EXPECT_EQ(contradicted, 1U);
}

// "At least as many" is true of equal maps, "more" and "fewer" are not.
TEST(OwnSystemsClaims, IncludeTheBoundOfAMeanWhereTheTextIncludesIt) {
  std::size_t included = 0;
  for (const Claim& claim : plan_of_claims().claims) {
    if (claim.judged_by != ClaimCriterion::kMean) continue;
    const bool expected = std::any_of(kIncluding.begin(), kIncluding.end(), [&](const char* words) {
      return claim.text.find(words) != std::string::npos;
    });
    EXPECT_EQ(claim.as_written()->bounds_included, expected) << claim.where;
    included += expected ? 1 : 0;
  }
  EXPECT_EQ(included, 14U);
}

TEST(OwnSystemsClaims, StandOnceEach) {
  std::set<std::tuple<std::string, std::string, std::string, std::string, std::string, std::string,
                      std::string>>
      known;
  for (const Claim& claim : plan_of_claims().claims) {
    EXPECT_TRUE(known
                    .emplace(claim.system, claim.variation, claim.than_system, claim.than_variation,
                             claim.metric, claim.protocol, claim.group)
                    .second)
        << claim.where;
  }
}

// With two rows and two columns at most, a torus has the distances of a plane.
TEST(OwnSystemsClaims, CountNoMapTwice) {
  for (const ReproductionPart& part : plan_of_claims().parts) {
    const System system = System::build(part.description.system, RecordingLayout{}).value();
    for (std::size_t module = 0; module < system.modules().size(); ++module) {
      if (!som_of(system, module)) continue;
      const Grid grid = grid_of(system, module);
      const bool is_tiny = grid.rows() <= 2 && grid.columns() <= 2;
      EXPECT_FALSE(is_tiny && grid.topology() == Topology::kTorus)
          << part.system << " " << part.variation;
    }
  }
}

TEST(OwnSystemsClaims, OfQuestionsRestOnEnoughPairs) {
  for (const ReproductionPart& part : plan_of_claims().parts) {
    if (part.question.empty()) continue;
    ASSERT_TRUE(part.pairs.has_value()) << part.question;
    EXPECT_GE(*part.pairs, kFewestPairs) << part.question;
  }
}

}  // namespace
}  // namespace somato
