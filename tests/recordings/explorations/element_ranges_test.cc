#include "somato/recording/element_ranges.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace somato {
namespace {

TEST(ElementRanges, CountsReadingsAndThoseThatAreMissing) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  ElementRanges ranges;
  EXPECT_TRUE(ranges.elements().empty());
  ranges.add(std::vector<float>{1.0F, 2.0F, kNone}, {});
  ranges.add(std::vector<float>{-3.0F, 0.0F, 4.0F}, std::vector<std::uint8_t>{1, 0, 1});
  EXPECT_EQ(ranges.elements(), (std::vector<ElementRange>{
                                   {-3.0F, 1.0F, 2, 0}, {2.0F, 2.0F, 1, 1}, {4.0F, 4.0F, 1, 1}}));
}

TEST(ElementRanges, AddsAllFramesOfAChannel) {
  Channel channel{"a", "", {}, Matrix<float>(2, 2, {1, 2, 3, 4}), {}};
  ElementRanges ranges;
  ranges.add(channel);
  channel.valid = Matrix<std::uint8_t>(2, 2, std::vector<std::uint8_t>{1, 1, 1, 0});
  ranges.add(channel);
  EXPECT_EQ(ranges.elements(), (std::vector<ElementRange>{{1.0F, 3.0F, 4, 0}, {2.0F, 4.0F, 3, 1}}));
}

TEST(ElementRanges, AnElementIsStillAfterEnoughEqualReadings) {
  ElementRanges ranges;
  for (std::uint64_t i = 1; i < kFewestStillReadings; ++i) {
    ranges.add(std::vector<float>{0.0F, 7.0F}, {});
  }
  EXPECT_FALSE(ranges.elements()[0].is_still());
  ranges.add(std::vector<float>{-0.0F, 7.5F}, {});
  EXPECT_TRUE(ranges.elements()[0].is_still());
  EXPECT_FALSE(ranges.elements()[1].is_still());
}

// A magnetometer that never answers is missing, and not still.
TEST(ElementRanges, WithoutAReadingNothingIsStill) {
  ElementRanges ranges;
  for (int i = 0; i < 100; ++i) ranges.add(std::vector<float>{0.0F}, std::vector<std::uint8_t>{0});
  EXPECT_FALSE(ranges.elements()[0].is_still());
  EXPECT_EQ(ranges.elements()[0].missing, 100U);
}

}  // namespace
}  // namespace somato
