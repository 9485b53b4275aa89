#include "recordings/file/spooled_frames.h"

#include <gtest/gtest.h>

#include "recordings/explorations/collected_explorations.h"

namespace somato {
namespace {

TEST(SpooledFrames, AreHandedOverWithTheEarliestTime) {
  std::vector<Exploration> taken;
  CollectedExplorations collected([&](Exploration exploration) {
    taken.push_back(std::move(exploration));
    return Result<void>();
  });
  SpooledFrames frames;
  const ExplorationStart start{{{"object", "cup"}}, "a", {{"x", "N", {}, {}}, {"y", "", {}, {}}}};
  for (const float shift : {0.0F, 10.0F}) {
    ASSERT_TRUE(frames.add(1, std::vector<float>{1.0F + shift}, 0.5, {}));
    ASSERT_TRUE(
        frames.add(0, std::vector<float>{2.0F, 0.0F}, -0.25, std::vector<std::uint8_t>{1, 0}));
    ASSERT_TRUE(frames.add(0, std::vector<float>{3.0F, 4.0F}, 0.0, {}));
    ASSERT_TRUE(frames.hand_over(start, collected));
  }
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_EQ(taken[1].labels, start.labels);
  const Channel& x = taken[1].channels[0];
  EXPECT_EQ(x.frames, Matrix<float>(2, 2, {2.0F, 0.0F, 3.0F, 4.0F}));
  EXPECT_EQ(x.valid, Matrix<std::uint8_t>(2, 2, {1, 0, 1, 1}));
  EXPECT_EQ(x.times, (std::vector<double>{-0.25, 0.0}));
  EXPECT_EQ(taken[1].channels[1].frames, Matrix<float>(1, 1, 11.0F));
}

// Takes the start only.
class StartSink final : public FrameSink {
 public:
  Result<void> begin_exploration(const ExplorationStart& start) override {
    time = start.time;
    return {};
  }
  Result<void> frame(std::size_t /*channel*/, std::span<const float> /*values*/, double /*time*/,
                     std::span<const std::uint8_t> /*valid*/) override {
    return fail(ErrorKind::kSystem, "full");
  }
  Result<void> end_exploration() override { return {}; }

  double time = 0.0;
};

TEST(SpooledFrames, AFailureOfTheSinkIsReturnedAndNothingIsLeft) {
  StartSink sink;
  SpooledFrames frames;
  ASSERT_TRUE(frames.add(0, std::vector<float>{1.0F}, 3.0, {}));
  ASSERT_TRUE(frames.add(1, std::vector<float>{1.0F}, 2.0, {}));
  EXPECT_FALSE(frames.hand_over({}, sink));
  EXPECT_EQ(sink.time, 2.0);
  EXPECT_TRUE(frames.hand_over({}, sink));
}

}  // namespace
}  // namespace somato
