#include "somato/maps/schedule.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(Schedule, GoesByEqualDifferencesThenStays) {
  const Schedule schedule{ScheduleShape::kLinear, 15.0, 1.0, 1000};
  EXPECT_EQ(schedule.at(0), 15.0);
  EXPECT_DOUBLE_EQ(schedule.at(500), 8.0);
  EXPECT_EQ(schedule.at(1000), 1.0);
  EXPECT_EQ(schedule.at(1999), 1.0);
}

TEST(Schedule, GoesByEqualRatiosThenStays) {
  const Schedule schedule{ScheduleShape::kExponential, 16.0, 1.0, 4};
  EXPECT_DOUBLE_EQ(schedule.at(0), 16.0);
  EXPECT_DOUBLE_EQ(schedule.at(1), 8.0);
  EXPECT_DOUBLE_EQ(schedule.at(2), 4.0);
  EXPECT_EQ(schedule.at(4), 1.0);
  EXPECT_EQ(schedule.at(5), 1.0);
}

TEST(Schedule, StaysConstant) {
  const Schedule schedule{ScheduleShape::kConstant, 3.0, 1.0, 4};
  EXPECT_EQ(schedule.at(0), 3.0);
  EXPECT_EQ(schedule.at(9), 3.0);
}

TEST(Schedule, CannotGoByEqualRatiosToOrFromZero) {
  for (const auto& [start, end] : {std::pair{0.0, 1.0}, std::pair{1.0, 0.0}}) {
    const auto valid = Schedule{ScheduleShape::kExponential, start, end, 4}.validate("radius");
    ASSERT_FALSE(valid);
    EXPECT_EQ(valid.error().kind, ErrorKind::kUsage);
    EXPECT_NE(valid.error().what.find("of the radius cannot"), std::string::npos);
    EXPECT_TRUE((Schedule{ScheduleShape::kLinear, start, end, 4}.validate("radius")));
  }
  EXPECT_TRUE((Schedule{ScheduleShape::kExponential, 2.0, 0.1, 4}.validate("radius")));
}

}  // namespace
}  // namespace somato
