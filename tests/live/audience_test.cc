#include "live/audience.h"

#include <gtest/gtest.h>

namespace somato::live {
namespace {

using Change = Audience::Change;

TEST(Audience, BeginsWithTheFirstViewer) {
  Audience audience(true, false);
  EXPECT_FALSE(audience.has_begun());
  EXPECT_EQ(audience.set_viewers(0, false), Change::kNone);
  EXPECT_EQ(audience.set_viewers(1, false), Change::kBegin);
  EXPECT_EQ(audience.set_viewers(2, true), Change::kNone);
  EXPECT_EQ(audience.set_viewers(0, true), Change::kNone);
  EXPECT_EQ(audience.set_viewers(1, true), Change::kNone);
}

TEST(Audience, RestsWithoutViewersAndContinuesOnlyWhatPlayed) {
  Audience audience(true, true);
  audience.set_viewers(1, false);
  EXPECT_EQ(audience.set_viewers(0, true), Change::kRest);
  EXPECT_TRUE(audience.is_resting());
  EXPECT_EQ(audience.set_viewers(1, false), Change::kContinue);
  EXPECT_FALSE(audience.is_resting());
  EXPECT_EQ(audience.set_viewers(0, false), Change::kRest);
  EXPECT_EQ(audience.set_viewers(1, false), Change::kNone);
}

TEST(Audience, DoesNotContinueAfterACommand) {
  Audience audience(false, true);
  EXPECT_EQ(audience.set_viewers(0, true), Change::kRest);
  audience.take_command();
  EXPECT_FALSE(audience.is_resting());
  EXPECT_EQ(audience.set_viewers(1, false), Change::kNone);
}

TEST(Audience, BeginsOnceByACommand) {
  Audience audience(true, false);
  EXPECT_TRUE(audience.begin());
  EXPECT_FALSE(audience.begin());
  EXPECT_EQ(audience.set_viewers(1, true), Change::kNone);
}

}  // namespace
}  // namespace somato::live
