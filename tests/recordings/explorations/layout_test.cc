#include "somato/recording/layout.h"

#include <gtest/gtest.h>

#include "systems/support/systems.h"

namespace somato {
namespace {

Exploration with_frames(std::size_t a, std::size_t b, std::size_t c) {
  return {{},
          {},
          {{"a", "deg", {"x", "y"}, Matrix<float>(a, 2), {}},
           {"b", "", {}, Matrix<float>(b, 6), {}, 0.0, {2, 3}, {}},
           {"c", "", {}, Matrix<float>(c, 1), {}}}};
}

TEST(Layout, DescribesThePropertiesSharedByExplorations) {
  const RecordingLayout layout = layout_of({{with_frames(4, 4, 4), with_frames(2, 9, 2)}});
  const ChannelLayout a{"a", "deg", {2}, {"x", "y"}, "a"};
  const ChannelLayout b{"b", "", {2, 3}, {}, "b"};
  const ChannelLayout c{"c", "", {1}, {}, "a"};
  EXPECT_EQ(layout.channels, (std::vector<ChannelLayout>{a, b, c}));
  EXPECT_EQ(layout.explorations, 2U);
  EXPECT_EQ(layout.frames, 13U);  // of b
}

TEST(Layout, FramesGoTogetherOnlyWhenTheyDoInEveryExploration) {
  // Two frames each in all but the last exploration.
  const RecordingLayout layout =
      layout_of({{with_frames(2, 2, 2), with_frames(2, 2, 2), with_frames(3, 2, 2)}});
  EXPECT_EQ(layout.channels[0].clock, "a");
  EXPECT_EQ(layout.channels[1].clock, "b");
  EXPECT_EQ(layout.channels[2].clock, "b");
}

TEST(Layout, HasTheRangeOfTheKnownRates) {
  Recording recording{{with_frames(3, 3, 3), with_frames(3, 3, 3), with_frames(3, 3, 3)}};
  for (const std::size_t i : {0U, 1U, 2U}) {
    recording.explorations[i].channels[0].rate = std::vector<double>{100.0, 80.0, 120.0}[i];
  }
  recording.explorations[1].channels[1].times = {0.0, 0.5, 1.0};
  const RecordingLayout layout = layout_of(recording);
  EXPECT_EQ(layout.rates, (std::vector<FrameRates>{{100.0, 80.0, 120.0}, {0.0, 2.0, 2.0}, {}}));
}

TEST(Layout, IsEmptyWithoutExplorations) {
  const RecordingLayout layout = layout_of({});
  EXPECT_TRUE(layout.channels.empty());
  EXPECT_EQ(layout.explorations, 0U);
  EXPECT_EQ(layout.frames, 0U);
}

}  // namespace
}  // namespace somato
