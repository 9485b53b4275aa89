#include "recordings/explorations/collected_channel.h"

#include <gtest/gtest.h>

#include <vector>

namespace somato {
namespace {

TEST(CollectedChannel, MarksOfValidityBeginWithTheFirstInvalidValue) {
  CollectedChannel collected;
  collected.add(std::vector<float>{1, 2}, {}, 0.0);
  collected.add(std::vector<float>{3, 0}, std::vector<std::uint8_t>{1, 0}, 0.5);
  collected.add(std::vector<float>{5, 6}, {}, 1.0);
  EXPECT_EQ(collected.frames(), 3U);
  ChannelDescription description;
  description.name = "touch";
  const Channel channel = collected.take(description, 2);
  EXPECT_EQ(channel.frames, Matrix<float>(3, 2, {1, 2, 3, 0, 5, 6}));
  EXPECT_EQ(channel.valid, Matrix<std::uint8_t>(3, 2, {1, 1, 1, 0, 1, 1}));
  EXPECT_EQ(channel.times, (std::vector<double>{0.0, 0.5, 1.0}));
  EXPECT_EQ(collected.frames(), 0U);
}

TEST(CollectedChannel, TimesThatAreNotKnownAreLeftOut) {
  CollectedChannel collected;
  collected.add(std::vector<float>{1}, {}, 7.0);
  ChannelDescription description;
  description.times_known = false;
  EXPECT_TRUE(collected.take(description, 1).times.empty());
  EXPECT_TRUE(collected.take(description, 1).valid.empty());
}

}  // namespace
}  // namespace somato
