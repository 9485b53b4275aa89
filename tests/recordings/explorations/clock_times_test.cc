#include "recordings/explorations/clock_times.h"

#include <gtest/gtest.h>

#include <vector>

namespace somato {
namespace {

std::string refusal(const std::vector<double>& times) {
  ClockTimes clock;
  std::size_t row = 0;
  for (const double time : times) {
    ++row;
    clock.take(
        time, [&] { return std::to_string(static_cast<long>(time)); },
        [&] { return "f:" + std::to_string(row); });
  }
  const auto checked = clock.check("column 't'");
  return checked ? "none" : to_string(checked.error());
}

TEST(ClockTimes, AreInOrderIfAllAreOfOneKind) {
  EXPECT_EQ(refusal({}), "none");
  EXPECT_EQ(refusal({0, 0.5, 1e6}), "none");
  EXPECT_EQ(refusal({-1, 0, 1}), "none");
  EXPECT_EQ(refusal({946684800, 1700000000, 1700000001}), "none");
}

TEST(ClockTimes, RefuseThoseBefore2000BesideOthers) {
  EXPECT_EQ(refusal({0, 1700000000, 1700000001, 12}),
            "f:1: 2 of 4 times of column 't' are before the year 2000, first '0'; others are of a "
            "clock that was set, such as '1700000000' (f:2); the clock was not set, or the time is "
            "missing: correct these times, or remove them");
  for (const double none : {-1.0, 0.0, 946684799.0}) {
    EXPECT_EQ(refusal({1700000000, none}).substr(0, 20), "f:2: 1 of 2 times of") << none;
  }
}

}  // namespace
}  // namespace somato
