#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "somato/graph/system_model.h"
#include "somato/studies/own_systems.h"

namespace somato {
namespace {

constexpr std::size_t kFewestPairs = 20;

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
