#include <gtest/gtest.h>

#include "bodies/support/fake_hand.h"
#include "somato/bodies/explore_by.h"

namespace somato {
namespace {

TEST(ExploreByHolding, RecordsEveryStepOfTheTimeAndMovesNothing) {
  FakeHand hand("skin");
  hand.add_servo({"wrist", "deg", -90, 90, 60}, 12);
  hand.add_sensor({"touch", "N", {"a", "b"}, {}, 0.0, true}, [](const std::vector<double>& at) {
    return std::vector<float>{static_cast<float>(at[0]), 3.0F};
  });
  const auto exploration = explore_by_holding(hand, 1.0, 0.25);
  ASSERT_TRUE(exploration) << to_string(exploration.error());
  ASSERT_EQ(exploration->channels.size(), 1U);
  const Channel& touch = exploration->channels.front();
  EXPECT_EQ(touch.name, "touch");
  EXPECT_EQ(touch.times, (std::vector<double>{0.25, 0.5, 0.75, 1.0}));
  ASSERT_EQ(touch.frames.rows(), 4U);
  for (std::size_t frame = 0; frame < 4; ++frame) {
    EXPECT_EQ(touch.frames.row(frame)[0], 12.0F);
    EXPECT_EQ(touch.frames.row(frame)[1], 3.0F);
  }
  EXPECT_TRUE(hand.commands.empty());
  EXPECT_TRUE(exploration->labels.empty());
}

TEST(ExploreByHolding, AFailingStepEndsIt) {
  FakeHand hand("skin");
  hand.add_sensor({"touch", "N", {"a"}, {}, 0.0, true},
                  [](const std::vector<double>&) { return std::vector<float>{1.0F}; });
  hand.failing_step = 3;
  const auto exploration = explore_by_holding(hand, 1.0, 0.25);
  ASSERT_FALSE(exploration);
  EXPECT_EQ(exploration.error().what, "the simulation diverged");
}

}  // namespace
}  // namespace somato
