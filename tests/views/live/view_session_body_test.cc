#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "views/live/sessions.h"
#include "views/live/view_session.h"
#include "views/live/view_systems.h"
#include "views/live/viewing.h"

namespace somato {
namespace {

using live::EventKind;
using nlohmann::json;

using testing::body_source;
using testing::command;
using testing::eventually;
using testing::frame_of;
using testing::latest;
using testing::state_of;
using testing::strips_of;

TEST(BodySessionThread, ReturnsStripsOfTheExplorationSoFar) {
  ViewSession session(body_source(1000), {false, 1.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] {
    const json frame = frame_of(session);
    return !frame.is_null() && frame["frame"] >= 3;
  }));
  command(session, R"({"command":"pause"})");
  json frame = frame_of(session);
  // Between two recorded steps the frame is sent again, with the state that is not recorded.
  command(session, R"({"command":"step","frames":1})");
  ASSERT_TRUE(eventually([&] { return frame_of(session)["frame"] > frame["frame"]; }));
  frame = frame_of(session);
  const json strips = strips_of(session);
  EXPECT_EQ(strips["frames"], nullptr);
  EXPECT_EQ(strips["frame"].back(), frame["frame"]);
  EXPECT_EQ(strips["frame"].size(), frame["frame"].get<std::size_t>() + 1);
  EXPECT_EQ(strips["time"].back(), frame["time"]);
  for (const auto& [channel, values] : frame["channels"].items()) {
    EXPECT_EQ(strips["channels"][channel].back(), values) << channel;
  }
}

TEST(BodySessionThread, ReturnsNoStripsWithoutAnExploration) {
  ViewSession session(body_source(), {true, 1.0, 0.0});
  session.start();
  EXPECT_EQ(strips_of(session), nullptr);
  session.stop();
  EXPECT_FALSE(session.strips());
}

// The explorations of a body until there are three.
struct Explored {
  Recording recording;
  json last_frame;
};

Explored explore_three_times(ViewSession& session) {
  session.start();
  for (std::size_t count = 1; count <= 3; ++count) {
    EXPECT_TRUE(eventually([&] {
      const json state = state_of(session);
      return !state.is_null() && state["explorations"].size() == count && state["live"] == false;
    }));
    if (count < 3) command(session, R"({"command":"explore"})");
  }
  const json frame = frame_of(session);
  session.stop();
  return {session.recording(), frame};
}

ViewSource reading_body() {
  ViewSource source = body_source();
  ViewSystem system = testing::view_system(testing::crossed_system(), "crossed");
  system.trained = testing::trained_model(testing::crossed_system(), testing::hand_recording(6, 2));
  source.systems.push_back(std::move(system));
  source.system = 0;
  return source;
}

TEST(BodySessionThread, YieldsTheSameBitsWithEightViewersOfWhomOneIsStalledAsWithNone) {
  ViewSession unwatched(reading_body(), testing::at_once());
  const Explored expected = explore_three_times(unwatched);
  ViewSession watched(reading_body(), testing::at_once());
  const auto server = ViewServer::start(watched, {}).value();
  const std::string events =
      testing::get_request(server->port(), "/api/events?token=" + server->token());
  std::vector<std::unique_ptr<testing::HttpClient>> clients;
  std::vector<std::thread> readers;
  for (int i = 0; i < 8; ++i) {
    clients.push_back(std::make_unique<testing::HttpClient>(server->port()));
    clients.back()->send(events);
    // The first one never reads.
    if (i > 0) readers.emplace_back([&client = *clients.back()] { client.receive(); });
  }
  const Explored seen = explore_three_times(watched);
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(seen.recording, expected.recording);
  EXPECT_EQ(seen.last_frame, expected.last_frame);
  EXPECT_TRUE(expected.last_frame["reading"]["answer"].is_string());
}

TEST(BodySessionThread, ShowsABodyWhileItExplores) {
  ViewSession session(body_source(1000), {false, 1.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] { return !frame_of(session).is_null(); }));
  command(session, R"({"command":"pause"})");
  const json state = state_of(session);
  EXPECT_EQ(state["live"], true);
  EXPECT_EQ(state["channels"][2]["elements"], (json{"1", "2", "3"}));
  EXPECT_EQ(state["frames"], nullptr);
  EXPECT_EQ(state["things"].size(), 2U);
  EXPECT_EQ(latest(session, EventKind::kScene)["bodies"], (json{"finger"}));
  const std::size_t before = frame_of(session)["frame"];
  command(session, R"({"command":"step","frames":3})");
  EXPECT_TRUE(eventually([&] { return frame_of(session)["frame"] >= before + 2; }));
  EXPECT_EQ(frame_of(session)["poses"].size(), 7U);
  EXPECT_FALSE(session.command(R"({"command":"seek","exploration":1,"frame":0})"));
}

// The moments shown so far can be shown again; the body pauses meanwhile.
TEST(BodySessionThread, GoesBackWhileABodyExplores) {
  ViewSource source = reading_body();
  source.explorer = std::make_unique<testing::FakeExplorer>(1000);
  ViewSession session(std::move(source), {false, 20.0, 0.0});
  session.start();
  std::map<int, json> shown;
  ASSERT_TRUE(eventually([&] {
    const json frame = frame_of(session);
    if (frame.is_null() || frame["poses"][0].get<int>() % 2 == 0) return false;
    shown[frame["frame"].get<int>()] = frame;
    return frame["frame"] >= 30 && shown.size() >= 3;
  }));
  command(session, R"({"command":"pause"})");
  const auto there = std::prev(shown.end(), 2);
  command(session, fmt::format(R"({{"command":"seek","exploration":0,"frame":{}}})", there->first));
  EXPECT_EQ(frame_of(session), there->second);
  EXPECT_EQ(state_of(session)["live"], true);
  command(session, R"({"command":"step","frames":-1})");
  EXPECT_EQ(frame_of(session)["frame"], there->first - 1);
  const json strips = strips_of(session);
  EXPECT_GE(strips["frame"].back(), 30);
  command(session, R"({"command":"step","frames":1000})");
  ASSERT_TRUE(eventually([&] { return frame_of(session)["frame"] > strips["frame"].back(); }));
  command(session, R"({"command":"seek","exploration":0,"frame":0})");
  command(session, R"({"command":"play"})");
  EXPECT_TRUE(eventually([&] {
    return frame_of(session)["frame"].get<int>() > strips["frame"].back().get<int>() + 10;
  }));
}

TEST(BodySessionThread, ExploresWhatIsChosen) {
  ViewSession session(body_source(), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 1; }));
  command(session, R"({"command":"thing","name":"cube"})");
  command(session, R"({"command":"placement","x":5,"y":-5,"turn":10})");
  command(session, R"({"command":"explore"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 2; }));
  const json state = state_of(session);
  EXPECT_EQ(state["explorations"][1]["labels"]["object"], "cube");
  EXPECT_EQ(state["placement"]["turn"], 10);
  command(session, R"({"command":"placement","x":50,"y":0,"turn":0})");
  command(session, R"({"command":"explore"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["problem"] != nullptr; }));
  EXPECT_EQ(state_of(session)["problem"], "cube: the object is out of reach.");
  command(session, R"({"command":"dismiss"})");
  EXPECT_EQ(state_of(session)["problem"], nullptr);
  // Earlier explorations can still be viewed, with their scenes.
  command(session, R"({"command":"seek","exploration":0,"frame":1})");
  EXPECT_EQ(frame_of(session)["poses"][0], 3.0);
}

TEST(BodySessionThread, DoesNotExploreAgainForTheFirstViewerAfterItsCommand) {
  ViewSession session(body_source(), {true, 100.0, 0.0});
  session.start();
  command(session, R"({"command":"explore"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 1; }));
  const auto subscription = session.hub().subscribe(1);
  command(session, R"({"command":"speed","speed":1})");  // done after the viewer is welcomed
  EXPECT_EQ(state_of(session)["live"], false);
  EXPECT_EQ(state_of(session)["explorations"].size(), 1U);
}

TEST(BodySessionThread, EndsWhileABodyExplores) {
  ViewSession session(body_source(100000), {false, 0.05, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] { return !state_of(session).is_null(); }));
  session.stop();
  EXPECT_TRUE(session.recording().explorations.empty());
  EXPECT_FALSE(session.command(R"({"command":"play"})"));
}

}  // namespace
}  // namespace somato
