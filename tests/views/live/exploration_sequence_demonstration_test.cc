#include "views/live/exploration_sequence.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "views/live/sessions.h"
#include "views/live/viewing.h"

namespace somato {
namespace {

using nlohmann::json;

using testing::command;
using testing::eventually;
using testing::state_of;

TEST(Demonstration, CountsRoundsUntilItEnds) {
  live::Demonstration demonstration(true);
  EXPECT_EQ(demonstration.rounds(), 0U);
  demonstration.complete_round();
  EXPECT_EQ(demonstration.rounds(), 1U);
  demonstration.end();
  EXPECT_FALSE(demonstration.rounds());
  EXPECT_FALSE(live::Demonstration(false).runs());
}

// The explorations of a FakeExplorer last a second, a hundredth at this speed.
ViewSource demonstrated() {
  ViewSource source = testing::body_source();
  source.demonstrates = true;
  source.plan = {{0, 0}, {1, 0}};
  return source;
}

TEST(DemonstrationThread, ExploresEachThingOnceAndThenRepeatsUntilAViewerExplores) {
  ViewSession session(demonstrated(), testing::at_once());
  session.start();
  // A round lasts some milliseconds, so that its number can pass unseen.
  ASSERT_TRUE(eventually([&] { return state_of(session)["demonstrated"] >= 2; }));
  json state = state_of(session);
  ASSERT_EQ(state["explorations"].size(), 2U);
  EXPECT_EQ(state["explorations"][0]["labels"]["object"], "ball");
  EXPECT_EQ(state["explorations"][1]["labels"]["object"], "cube");
  EXPECT_EQ(state["playing"], true);
  command(session, R"({"command":"thing","name":"cube"})");
  EXPECT_EQ(state_of(session)["demonstrated"], nullptr);
  command(session, R"({"command":"explore"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 3; }));
  ASSERT_TRUE(eventually([&] { return state_of(session)["playing"] == false; }));
  state = state_of(session);
  EXPECT_EQ(state["explorations"][2]["labels"]["object"], "cube");
  session.stop();
  // Another trial than in the demonstration.
  const auto& explored = session.recording().explorations;
  EXPECT_NE(explored[2].channels, explored[1].channels);
}

TEST(DemonstrationThread, StandsStillDuringAPause) {
  ViewSession session(demonstrated(), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() >= 1; }));
  command(session, R"({"command":"pause"})");
  const json state = state_of(session);
  EXPECT_EQ(state["playing"], false);
  const int rounds = state["demonstrated"].get<int>();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  // An exploration that was about to begin may begin, and stands still at its first step; one whose
  // last step was shown may end.
  const json later = state_of(session);
  for (const std::string part : {"playing", "demonstrated", "frame"}) {
    EXPECT_EQ(later[part], state[part]) << part;
  }
  EXPECT_LE(later["explorations"].size(), state["explorations"].size() + 1);
  command(session, R"({"command":"play"})");
  EXPECT_TRUE(eventually([&] { return state_of(session)["demonstrated"] > rounds; }));
}

// A step that the body has begun may still end its exploration.
TEST(DemonstrationThread, RestsWithoutViewers) {
  ViewSession session(demonstrated(), {true, 100.0, 0.0, 0.0});
  session.start();
  auto viewer = session.hub().subscribe(1);
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() >= 1; }));
  viewer.reset();
  ASSERT_TRUE(eventually([&] {
    const json state = state_of(session);
    return state["clients"] == 0 && state["playing"] == false;
  }));
  const json state = state_of(session);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const json later = state_of(session);
  EXPECT_EQ(later["playing"], false);
  EXPECT_EQ(later["demonstrated"], state["demonstrated"]);
  EXPECT_LE(later["explorations"].size(), state["explorations"].size() + 1);
  viewer = session.hub().subscribe(1);
  const int rounds = state["demonstrated"].get<int>();
  EXPECT_TRUE(eventually([&] { return state_of(session)["demonstrated"] > rounds; }));
}

}  // namespace
}  // namespace somato
