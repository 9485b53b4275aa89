#include "recordings/explorations/exploration_frames.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace somato {
namespace {

// The times and channels of the frames, and that of the start.
class OrderSink final : public FrameSink {
 public:
  Result<void> begin_exploration(const ExplorationStart& start) override {
    begin = start.time;
    return {};
  }
  Result<void> frame(std::size_t channel, std::span<const float> /*values*/, double time,
                     std::span<const std::uint8_t> /*valid*/) override {
    order.emplace_back(time, channel);
    return {};
  }
  Result<void> end_exploration() override { return {}; }

  double begin = -1.0;
  std::vector<std::pair<double, std::size_t>> order;
};

TEST(HandFrames, FramesComeInTheOrderOfTime) {
  Exploration exploration;
  exploration.channels.push_back({"timed", "", {}, Matrix<float>(2, 1), {5.0, 5.02}});
  exploration.channels.push_back({"untimed", "", {}, Matrix<float>(3, 1), {}});
  OrderSink sink;
  ASSERT_TRUE(hand_frames(exploration, sink));
  EXPECT_EQ(sink.begin, 5.0);
  using Order = std::vector<std::pair<double, std::size_t>>;
  EXPECT_EQ(sink.order, (Order{{5.0, 0}, {5.0, 1}, {5.01, 1}, {5.02, 0}, {5.02, 1}}));
}

}  // namespace
}  // namespace somato
