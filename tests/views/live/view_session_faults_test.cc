#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "views/live/reading_listener.h"
#include "views/live/sessions.h"
#include "views/live/view_session.h"
#include "views/live/view_systems.h"
#include "views/live/viewing.h"

namespace somato {
namespace {

using testing::command;
using testing::eventually;
using testing::frame_of;
using testing::state_of;

std::string problem_of(ViewSession& session) {
  const auto state = state_of(session);
  return state.is_null() || state["problem"].is_null() ? "" : state["problem"];
}

// Throws for the second exploration.
class BrokenScene : public ScenePlayer {
 public:
  const Scene& scene() const override { return scene_; }
  std::vector<ScenePose> poses(const Exploration& exploration, std::size_t /*frame*/) override {
    if (exploration.source == "trial 2") throw std::runtime_error("no such pose");
    return {};
  }

 private:
  Scene scene_;
};

TEST(SessionFaultsThread, OutlivesAMistakeWhileItPlays) {
  ViewSource source = testing::hand_source();
  source.scenes = [](const Exploration&) { return std::make_unique<BrokenScene>(); };
  ViewSession session(std::move(source), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually([&] { return !problem_of(session).empty(); }));
  EXPECT_EQ(problem_of(session), "Internal error: no such pose.");
  EXPECT_EQ(state_of(session)["playing"], false);
  EXPECT_FALSE(session.command(R"({"command":"seek","exploration":1,"frame":1})"));
  command(session, R"({"command":"seek","exploration":2,"frame":0})");
  EXPECT_EQ(frame_of(session)["exploration"], 2);
}

TEST(SessionFaultsThread, ReportsAMistakeToTheReceiverOfReadings) {
  testing::ReadingListener listener;
  ViewSource source = testing::source_with_readings(testing::hand_source(), listener);
  source.scenes = [](const Exploration&) { return std::make_unique<BrokenScene>(); };
  ViewSession session(std::move(source), testing::at_once());
  session.start();
  const auto done = listener.wait();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what, "Internal error: no such pose.");
  session.stop();
}

// Breaks as soon as it is to explore a cube.
class BrokenBody : public testing::FakeExplorer {
 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions& options) const override {
    auto explored = testing::FakeExplorer::simulate(thing, trial, options);
    if (thing == 1) throw std::runtime_error("a finger broke");
    return explored;
  }
};

TEST(SessionFaultsThread, OutlivesAMistakeWhileABodyExplores) {
  ViewSource source;
  source.explorer = std::make_unique<BrokenBody>();
  source.thing = 1;
  ViewSession session(std::move(source), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually([&] { return !problem_of(session).empty(); }));
  EXPECT_EQ(problem_of(session), "Internal error: a finger broke.");
  EXPECT_EQ(state_of(session)["live"], false);
  command(session, R"({"command":"thing","name":"ball"})");
  command(session, R"({"command":"explore"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 1; }));
}

// A map of ten thousand neurons is evaluated for each frame, which takes time.
ViewSystem slow_system(const Recording& recording) {
  const std::string text =
      testing::channels({"joints"}) +
      testing::module("first", "som",
                      "input = 'joints'\nrows = 150\ncolumns = 150\niterations = 9") +
      testing::module("memory", "accumulate", "input = 'first'") +
      testing::module("map", "som", "input = 'memory'\nrows = 2\ncolumns = 2\niterations = 9");
  ViewSystem system = testing::view_system(text, "slow");
  system.trained = testing::trained_model(text, recording);
  return system;
}

// 200,000 frames: to follow them all takes longer than anybody waits for an answer.
TEST(SessionFaultsThread, AnswersWhileItFollowsALongExploration) {
  ViewSource source = testing::hand_source();
  source.systems.push_back(slow_system(source.recording));
  source.system = 0;
  for (Channel& channel : source.recording.explorations[0].channels) {
    channel.frames = Matrix<float>(200000, channel.frames.columns());
    channel.rate = 10.0;
  }
  ViewSession session(std::move(source), {true, 1.0, 0.0});
  session.start();
  command(session, R"({"command":"seek","exploration":0,"frame":199999})");
  command(session, R"({"command":"step","frames":-2})");
  EXPECT_EQ(state_of(session)["frame"], 199998);
  EXPECT_EQ(frame_of(session)["frame"], 0);
  // The last that was wanted is shown, and what was wanted before never.
  command(session, R"({"command":"seek","exploration":1,"frame":1})");
  ASSERT_TRUE(eventually([&] { return frame_of(session)["exploration"] == 1; }));
  EXPECT_TRUE(frame_of(session)["reading"].is_object());
  command(session, R"({"command":"seek","exploration":0,"frame":199999})");
}

TEST(SessionFaultsThread, PlaysOnWhileCommandsKeepComing) {
  ViewSession session(testing::hand_source(), testing::at_once());
  session.start();
  std::atomic<bool> done = false;
  std::vector<std::thread> callers;
  for (int i = 0; i < 4; ++i) {
    callers.emplace_back([&] {
      while (!done) (void)session.command(R"({"command":"speed","speed":100})");
    });
  }
  EXPECT_TRUE(eventually([&] { return state_of(session)["playing"] == false; }));
  done = true;
  for (std::thread& caller : callers) caller.join();
}

// Its channels are known once it explores: the problem is reported immediately, not at the end.
TEST(SessionFaultsThread, ReportsImmediatelyThatABodyDoesNotFit) {
  Recording other = testing::hand_recording(6, 2);
  for (Exploration& one : other.explorations) {
    one.channels[2].frames = Matrix<float>(one.channels[2].frames.rows(), 5, 0.5F);
    one.channels[2].shape = {5};
  }
  ViewSource source = testing::body_source(1000);
  source.systems.push_back(testing::view_system(testing::crossed_system(), "crossed"));
  source.systems[0].trained = testing::trained_model(testing::crossed_system(), other);
  source.system = 0;
  ViewSession session(std::move(source), {false, 1.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] {
    const auto state = state_of(session);
    return !state.is_null() && state["system_problem"].is_string();
  }));
  EXPECT_EQ(state_of(session)["live"], true);
}

TEST(SessionFaultsThread, PausesForGoodAndNotForWhatItRefuses) {
  ViewSession session(testing::body_source(100000), {false, 1.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] { return !frame_of(session).is_null(); }));
  EXPECT_FALSE(session.command(R"({"command":"seek","exploration":1,"frame":0})"));
  EXPECT_EQ(state_of(session)["playing"], true);
  command(session, R"({"command":"step","frames":90000})");
  command(session, R"({"command":"pause"})");
  const auto frame = frame_of(session);
  for (int i = 0; i < 20; ++i) command(session, R"({"command":"speed","speed":100})");
  EXPECT_EQ(frame_of(session), frame);
}

TEST(SessionFaultsThread, TrainsOneSystemAtATime) {
  ViewSource source = testing::hand_source(6);
  source.systems.push_back(testing::view_system(testing::crossed_system(), "crossed"));
  source.system = 0;
  ViewSession session(std::move(source), {true, 1.0, 3600.0});
  session.start();
  command(session, R"({"command":"train"})");
  EXPECT_FALSE(session.command(R"({"command":"train"})"));
  EXPECT_EQ(state_of(session)["training"], true);
  command(session, R"({"command":"stop_training"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["training"] == false; }));
  command(session, R"({"command":"train"})");
  EXPECT_EQ(state_of(session)["training"], true);
}

}  // namespace
}  // namespace somato
