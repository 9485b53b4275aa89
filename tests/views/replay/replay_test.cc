#include "views/replay/replay.h"

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "views/replay/growing_exploration.h"

namespace somato::live {
namespace {

// A body with one sensor explores.
class ReplayOfABody : public ::testing::Test {
 protected:
  ReplayOfABody() {
    BodyDescription body;
    body.sensors.emplace_back().name = "height";
    growing_ = std::make_unique<GrowingExploration>(0, body, std::make_shared<Scene>());
    replay_.begin(growing_->played());
  }

  // One more tenth of a second, after which the only body of the scene is at `x`.
  void move(double x, Readings readings) {
    time_ += 0.1;
    ScenePose pose;
    pose.position[0] = x;
    growing_->append({{time_, {}, {Matrix<float>(1, 1, static_cast<float>(x))}}, {pose}, readings});
    if (readings == Readings::kRecorded) {
      replay_.show(replay_.moments() - 1);
    } else {
      replay_.show_between(growing_->last());
    }
  }

  // Which frame was shown last, where the body was, and what it felt there.
  nlohmann::json shown() const {
    const auto text = hub_.latest(EventKind::kFrame);
    if (!text) return nullptr;
    const auto frame = nlohmann::json::parse(*text);
    EXPECT_EQ(frame["frames"], nullptr);
    EXPECT_EQ(frame["last"], false);
    return {frame["frame"], frame["poses"].at(0), frame["channels"]["height"].at(0)};
  }

  EventHub hub_;
  Pace pace_;
  Replay replay_{hub_, pace_};
  std::unique_ptr<GrowingExploration> growing_;
  double time_ = 0.0;
};

TEST_F(ReplayOfABody, ShowsStepsWhetherTheyAreRecordedOrNot) {
  EXPECT_EQ(shown(), nullptr);
  move(1.0, Readings::kLeftOut);
  EXPECT_EQ(shown(), (nlohmann::json{0, 1.0, 1.0}));
  move(2.0, Readings::kRecorded);
  EXPECT_EQ(shown(), (nlohmann::json{0, 2.0, 2.0}));
  move(3.0, Readings::kRecorded);
  EXPECT_EQ(shown(), (nlohmann::json{1, 3.0, 3.0}));
  move(4.0, Readings::kLeftOut);
  EXPECT_EQ(shown(), (nlohmann::json{1, 4.0, 4.0}));
}

TEST_F(ReplayOfABody, GoesBackAndForthInWhatHasComeSoFar) {
  for (const double x : {1.0, 2.0, 3.0}) move(x, Readings::kRecorded);
  EXPECT_TRUE(replay_.is_over());
  replay_.show(0);
  EXPECT_EQ(shown(), (nlohmann::json{0, 1.0, 1.0}));
  EXPECT_FALSE(replay_.is_over());
  EXPECT_DOUBLE_EQ(replay_.pause(), 0.1);
  replay_.show(2);
  EXPECT_EQ(shown(), (nlohmann::json{2, 3.0, 3.0}));
}

TEST_F(ReplayOfABody, ShowsWhatIsKept) {
  for (const double x : {1.0, 2.0, 3.0, 4.0}) move(x, Readings::kRecorded);
  growing_->drop_half();
  EXPECT_EQ(replay_.first(), 2U);
  EXPECT_EQ(replay_.moments(), 4U);
  replay_.show(2);
  EXPECT_EQ(shown(), (nlohmann::json{2, 3.0, 3.0}));
  replay_.show(3);
  EXPECT_EQ(shown(), (nlohmann::json{3, 4.0, 4.0}));
  move(5.0, Readings::kRecorded);
  EXPECT_EQ(shown(), (nlohmann::json{4, 5.0, 5.0}));
}

}  // namespace
}  // namespace somato::live
