#include "views/http/audience.h"

#include <gtest/gtest.h>

namespace somato::live {
namespace {

using Change = Audience::Change;

TEST(Audience, BeginsWithTheFirstViewer) {
  Audience audience(Beginning::kWithFirstViewer, false);
  EXPECT_FALSE(audience.has_begun());
  EXPECT_EQ(audience.set_viewers(0, false), Change::kNone);
  EXPECT_EQ(audience.set_viewers(1, false), Change::kBegin);
  EXPECT_EQ(audience.set_viewers(2, true), Change::kNone);
  EXPECT_EQ(audience.set_viewers(0, true), Change::kNone);
  EXPECT_EQ(audience.set_viewers(1, true), Change::kNone);
}

TEST(Audience, RestsWithoutViewersAndContinuesOnlyWhatPlayed) {
  Audience audience(Beginning::kWithFirstViewer, true);
  audience.set_viewers(1, false);
  EXPECT_EQ(audience.set_viewers(0, true), Change::kRest);
  EXPECT_TRUE(audience.is_resting());
  EXPECT_EQ(audience.set_viewers(1, false), Change::kContinue);
  EXPECT_FALSE(audience.is_resting());
  EXPECT_EQ(audience.set_viewers(0, false), Change::kRest);
  EXPECT_EQ(audience.set_viewers(1, false), Change::kNone);
}

TEST(Audience, DoesNotContinueAfterACommand) {
  Audience audience(Beginning::kAtOnce, true);
  EXPECT_EQ(audience.set_viewers(0, true), Change::kRest);
  audience.take_command();
  EXPECT_FALSE(audience.is_resting());
  EXPECT_EQ(audience.set_viewers(1, false), Change::kNone);
}

TEST(Audience, BeginsOnceByACommand) {
  Audience audience(Beginning::kWithFirstViewer, false);
  EXPECT_TRUE(audience.begin());
  EXPECT_FALSE(audience.begin());
  EXPECT_EQ(audience.set_viewers(1, true), Change::kNone);
}

TEST(Audience, AwaitsACommandWhoeverComes) {
  Audience audience(Beginning::kByCommand, false);
  for (const std::size_t viewers : {1U, 2U, 0U, 1U}) {
    EXPECT_EQ(audience.set_viewers(viewers, false), Change::kNone);
    EXPECT_TRUE(audience.awaits_command());
  }
  audience.take_command();
  EXPECT_FALSE(audience.has_begun());
  EXPECT_TRUE(audience.begin());
  EXPECT_FALSE(audience.awaits_command());
}

TEST(Audience, AwaitsACommandAgain) {
  Audience audience(Beginning::kByCommand, false);
  audience.begin();
  audience.await_command();
  EXPECT_EQ(audience.set_viewers(2, false), Change::kNone);
  EXPECT_TRUE(audience.awaits_command());
  EXPECT_TRUE(audience.begin());
  Audience other(Beginning::kAtOnce, false);
  other.await_command();
  EXPECT_TRUE(other.has_begun());
}

}  // namespace
}  // namespace somato::live
