#include "recordings/explorations/checked_explorations.h"

#include <gtest/gtest.h>

#include <limits>

#include "recordings/explorations/collected_explorations.h"
#include "recordings/explorations/exploration_frames.h"

namespace somato {
namespace {

Exploration exploration() {
  Exploration made{{{"object", "cup"}}, "bag", {}};
  made.channels.push_back({"x", "N", {"a", "b"}, Matrix<float>(3, 2, 1.5F), {0.0, 0.1, 0.2}});
  made.channels.push_back({"y", "", {}, Matrix<float>(2, 4, 2.5F), {}, 10.0, {2, 2}});
  return made;
}

class CheckedExplorationsTest : public ::testing::Test {
 protected:
  Result<void> add(const Exploration& added) { return hand_frames(added, checked_); }

  std::string refusal(const Exploration& added) {
    const Result<void> result = add(added);
    return result ? "accepted" : to_string(result.error());
  }

  std::vector<Exploration> taken_;
  CollectedExplorations collected_{[this](Exploration added) {
    taken_.push_back(std::move(added));
    return Result<void>();
  }};
  CheckedExplorations checked_{collected_};
};

TEST_F(CheckedExplorationsTest, WholeExplorationsArePassedOn) {
  ASSERT_TRUE(add(exploration()));
  ASSERT_TRUE(add(exploration()));
  EXPECT_EQ(taken_, (std::vector{exploration(), exploration()}));
  EXPECT_EQ(checked_.count(), 2U);
  EXPECT_EQ(checked_.first().channels[0].frames, Matrix<float>(1, 2, 1.5F));
}

TEST_F(CheckedExplorationsTest, ValuesAreFinite) {
  Exploration infinite = exploration();
  infinite.channels[0].frames(2, 1) = std::numeric_limits<float>::infinity();
  const std::string refused = refusal(infinite);
  EXPECT_NE(refused.find("bag, exploration 1: channel 'x', frame 3, element 2"), std::string::npos)
      << refused;
}

TEST_F(CheckedExplorationsTest, EachChannelHasFrames) {
  Exploration added = exploration();
  added.channels[1].frames = {};
  EXPECT_NE(refusal(added).find("channel 'y' has no frames"), std::string::npos);
}

TEST_F(CheckedExplorationsTest, AllAreLikeTheFirst) {
  ASSERT_TRUE(add(exploration()));
  Exploration added = exploration();
  added.channels[1].unit = "N";
  EXPECT_NE(refusal(added).find("exploration 2: channel 'y' is in 'N'"), std::string::npos);
  added = exploration();
  added.channels.pop_back();
  EXPECT_NE(refusal(added).find("its channels are 'x', but"), std::string::npos);
  added = exploration();
  added.channels[0].element_names.clear();
  added.channels[0].frames = Matrix<float>(3, 3, 1.0F);
  EXPECT_NE(refusal(added).find("channel 'x'"), std::string::npos);
  EXPECT_EQ(checked_.count(), 1U);
}

}  // namespace
}  // namespace somato
