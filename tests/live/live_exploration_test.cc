#include "live/live_exploration.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace somato::live {
namespace {

// A body with one sensor, which is watched by a program as fast as it can be.
class WatchedSteps : public ::testing::Test {
 protected:
  WatchedSteps() {
    showing_.pace.playing = true;
    showing_.pace.speed = 100.0;
    BodyDescription body;
    body.sensors.emplace_back().name = "height";
    exploration_.begins(body, {});
  }

  // One more tenth of a second, after which the only body of the scene is at `x`.
  void move(double x) {
    state_.time += 0.1;
    state_.readings = {Matrix<float>(1, 1, static_cast<float>(x))};
    ScenePose pose;
    pose.position[0] = x;
    ASSERT_TRUE(exploration_.moved(state_, {pose}));
  }

  void feel() { ASSERT_TRUE(exploration_.felt(state_)); }

  // Where the body was last shown, and what it felt there.
  nlohmann::json shown() const {
    const auto text = hub_.latest(EventKind::kFrame);
    if (!text) return nullptr;
    const auto frame = nlohmann::json::parse(*text);
    return {frame["poses"][0], frame["channels"]["height"][0]};
  }

 private:
  EventHub hub_;
  TaskQueue queue_;
  Showing showing_{hub_, [] {}};
  LiveExploration exploration_{0, showing_, queue_};
  BodyState state_;
};

TEST_F(WatchedSteps, AreShownWhetherTheyAreRecordedOrNot) {
  move(1.0);
  EXPECT_EQ(shown(), nullptr);  // it may be recorded yet
  move(2.0);
  EXPECT_EQ(shown(), (nlohmann::json{1.0, 1.0}));
  feel();
  EXPECT_EQ(shown(), (nlohmann::json{2.0, 2.0}));
  move(3.0);
  EXPECT_EQ(shown(), (nlohmann::json{2.0, 2.0}));
  move(4.0);
  EXPECT_EQ(shown(), (nlohmann::json{3.0, 3.0}));
}

}  // namespace
}  // namespace somato::live
