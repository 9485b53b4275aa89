#include "studies/codes/candidates.h"

#include <gtest/gtest.h>

#include "studies/support/made_senses.h"

namespace somato {
namespace {

ComparisonLimits limits(std::size_t elements = 1000) {
  return {elements, 1, [](double) { return Result<void>(); }};
}

Recording two_channels() {
  return testing::made_senses(3, 3, {{"joints", {0, 1, 2}}, {"touch", {0, 1, 2}}});
}

CandidateGroup group_of(const Recording& recording) {
  return {{0}, {channel_source("joints", recording, 0)}, {}};
}

TEST(Candidates, AreAllCodesInAllScalings) {
  const Recording recording = two_channels();
  CandidateGroup group = group_of(recording);
  const auto found = compare_codes(recording, group, false, limits()).value();
  ASSERT_EQ(group.candidates.size(), 15U);  // last, mean, change, curve, histogram
  for (const CandidateCode& candidate : group.candidates) EXPECT_TRUE(candidate.is_usable());
  EXPECT_EQ(group.candidates[1].elements, 3U);
  double sum = 0.0;  // mean ranks from 1 to 8 of each exploration
  for (const float rank : found.ranks[View::kWhole].row(4)) sum += double{rank};
  EXPECT_NEAR(sum, 36.0, 1e-3);
}

TEST(Candidates, ThatCannotBeUsedAreKeptWithTheReason) {
  const Recording recording = testing::frames_as_given("touch", {{1, 2}, {1, 3}, {1, 5}});
  CandidateGroup group{{0}, {channel_source("touch", recording, 0)}, {}};
  ASSERT_TRUE(compare_codes(recording, group, false, limits(9)).has_value());
  EXPECT_EQ(group.candidates[0].failure, "");
  EXPECT_EQ(group.candidates[2].failure, "a single element");
  EXPECT_EQ(group.candidates[9].failure, "'curve_of_touch' has 10 elements, more than 9");
}

TEST(Candidates, VectorsThatAreEqualAreNotCompared) {
  const Recording recording = testing::frames_as_given("touch", {{1, 2}, {5, 2}, {7, 2}});
  CandidateGroup group{{0}, {channel_source("touch", recording, 0)}, {}};
  ASSERT_TRUE(compare_codes(recording, group, false, limits()).has_value());
  EXPECT_EQ(group.candidates[0].failure, "the same for all explorations");
}

TEST(Candidates, PartsHaveUnitSpread) {
  const Recording recording = two_channels();
  CandidateGroup group = group_of(recording);
  ASSERT_TRUE(compare_codes(recording, group, false, limits()).has_value());
  const std::vector<std::size_t> chosen{1, 3};
  const auto parts = parts_of(recording, group, chosen, limits()).value();
  ASSERT_EQ(parts.size(), 2U);
  double sum = 0.0;
  for (const float distance : parts[1].distances[View::kWhole].values()) sum += double{distance};
  EXPECT_NEAR(sum / 2.0 / 81.0, 1.0, 1e-5);
}

TEST(Candidates, AProductIsScaledToUnitLength) {
  const Recording recording = two_channels();
  CandidateGroup group = group_of(recording);
  const auto touch = channel_source("touch", recording, 1);
  group.sources[0].modules.push_back(touch.modules[0]);
  group.sources[0].outputs.push_back(touch.outputs[0]);
  ASSERT_TRUE(compare_product(recording, group, limits()).has_value());
  ASSERT_EQ(group.candidates.size(), 1U);
  EXPECT_EQ(group.candidates[0].scaling, Scaling::kUnit);
  EXPECT_EQ(group.candidates[0].elements, 90U);  // 3 x 10 x 3
}

TEST(Candidates, CanBeInterrupted) {
  const Recording recording = two_channels();
  CandidateGroup group = group_of(recording);
  ComparisonLimits stopped = limits();
  stopped.proceed = [](double) -> Result<void> { return fail(ErrorKind::kInterrupted, "stopped"); };
  EXPECT_FALSE(compare_codes(recording, group, false, stopped).has_value());
}

}  // namespace
}  // namespace somato
