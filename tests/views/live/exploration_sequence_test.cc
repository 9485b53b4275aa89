#include "views/live/exploration_sequence.h"

#include <gtest/gtest.h>

namespace somato::live {
namespace {

TEST(ExplorationSequence, ExploresTheSelectedThingAgainAndAgainWithoutAPlan) {
  ExplorationSequence plan({}, false, 2);
  EXPECT_FALSE(plan.is_planned());
  ASSERT_TRUE(plan.take_over());
  EXPECT_EQ(plan.next().thing, 2U);
  plan.select(1);
  plan.place({3.0, 4.0, 5.0});
  const ExplorationSequence::Next next = plan.next();
  EXPECT_EQ(next.thing, 1U);
  EXPECT_EQ(next.trial, 1U);
  ASSERT_TRUE(next.placement);
  EXPECT_EQ(next.placement->x, 3.0);
}

TEST(ExplorationSequence, FollowsAFixedPlanToItsEnd) {
  ExplorationSequence plan({{1, 0}, {0, 4}}, false, 0);
  EXPECT_FALSE(plan.take_over());
  EXPECT_EQ(plan.next().thing, 1U);
  EXPECT_EQ(plan.thing(), 1U);
  EXPECT_TRUE(plan.has_next());
  const ExplorationSequence::Next last = plan.next();
  EXPECT_EQ(last.thing, 0U);
  EXPECT_EQ(last.trial, 4U);
  EXPECT_FALSE(last.placement);
  EXPECT_FALSE(plan.has_next());
  EXPECT_TRUE(plan.is_planned());
}

TEST(ExplorationSequence, GivesUpTheRest) {
  ExplorationSequence plan({{1, 0}, {0, 4}}, false, 0);
  plan.give_up();
  EXPECT_FALSE(plan.has_next());
}

// The explorations of the demonstration were trial 0.
TEST(ExplorationSequence, LetsAViewerEndADemonstration) {
  ExplorationSequence plan({{0, 0}, {1, 0}}, true, 0);
  plan.next();
  plan.complete_round();
  EXPECT_EQ(plan.rounds(), 1U);
  ASSERT_TRUE(plan.take_over());
  EXPECT_FALSE(plan.demonstrates());
  EXPECT_FALSE(plan.rounds());
  EXPECT_FALSE(plan.has_next());
  EXPECT_EQ(plan.next().trial, 1U);
}

}  // namespace
}  // namespace somato::live
