#include "views/replay/pace.h"

#include <gtest/gtest.h>

namespace somato::live {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;
using std::chrono::minutes;

TEST(Pace, CountsTheNextMomentFromWhenThisOneWasDue) {
  Pace pace;
  pace.begin();
  const auto first = pace.due(3600.0);
  pace.keep(first);
  EXPECT_EQ(pace.due(3600.0), first + hours(1));
  pace.speed = 2.0;
  EXPECT_EQ(pace.due(3600.0), first + minutes(30));
}

TEST(Pace, DoesNotMakeUpForALargeDelay) {
  Pace pace;
  const auto before = Pace::Clock::now();
  pace.keep(before - hours(1));
  EXPECT_GE(pace.due(0.0), before - milliseconds(250));
  EXPECT_LE(pace.due(0.0), Pace::Clock::now());
}

}  // namespace
}  // namespace somato::live
