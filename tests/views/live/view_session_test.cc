#include "views/live/view_session.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "views/live/sessions.h"
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

ViewSource source_with_systems() {
  ViewSource source = testing::hand_source(6);
  source.systems = {testing::view_system(testing::crossed_system(), "crossed"),
                    testing::view_system(testing::sound_system(), "sound")};
  source.system = 0;
  return source;
}

// Begins without viewers, and paused.
class SessionThread : public ::testing::Test {
 protected:
  static ViewSettings resting() { return {true, 1.0, 0.0}; }
};

TEST_F(SessionThread, BeginsAtTheFirstFrameAndDescribesItsState) {
  ViewSession session(testing::hand_source(), resting());
  session.start();
  const json state = state_of(session);  // without waiting
  EXPECT_EQ(state["version"], 1);
  EXPECT_EQ(state["source"], "recording");
  EXPECT_EQ(state["explorations"].size(), 3U);
  EXPECT_EQ(state["explorations"][1]["labels"]["object"], "object 1");
  EXPECT_EQ(state["exploration"], 0);
  EXPECT_EQ(state["frame"], 1);
  EXPECT_EQ(state["playing"], false);
  EXPECT_EQ(state["channels"][2]["name"], "joints");
  EXPECT_EQ(state["channels"][2]["elements"], (json{"1", "2", "3"}));
  const json frame = frame_of(session);
  EXPECT_EQ(frame["frame"], 0);
  EXPECT_EQ(frame["reading"], nullptr);
}

TEST_F(SessionThread, HasThePlacesOfALayoutOrSaysWhyNot) {
  const auto with_places = [](const std::string& channel, std::vector<Point> places) {
    ViewSource source = testing::hand_source();
    source.places = {{channel, "hand.toml:1", {}, std::move(places), {}, {}}};
    ViewSession session(std::move(source), resting());
    session.start();
    return state_of(session);
  };
  const json fits = with_places("joints", {{0, 0}, {2, 0}, {4, 0}});
  EXPECT_EQ(fits["channels"][2]["layout"]["places"], json::parse("[[0,0],[2,0],[4,0]]"));
  EXPECT_FALSE(fits["channels"][0].contains("layout"));
  EXPECT_EQ(fits["problem"], nullptr);
  const std::string few = with_places("joints", {{0, 0}, {2, 0}})["problem"];
  EXPECT_NE(few.find("2 places, but 'joints' has 3 elements"), std::string::npos) << few;
  const std::string other = with_places("joint", {{0, 0}})["problem"];
  EXPECT_NE(other.find("did you mean 'joints'?"), std::string::npos) << other;
}

TEST_F(SessionThread, StepsAndSeeksToAndFro) {
  ViewSource source = testing::hand_source();
  const Recording recording = source.recording;
  ViewSession session(std::move(source), resting());
  session.start();
  command(session, R"({"command":"seek","exploration":1,"frame":2})");
  EXPECT_EQ(frame_of(session)["exploration"], 1);
  EXPECT_EQ(frame_of(session)["frame"], 2);
  command(session, R"({"command":"step","frames":-1})");
  EXPECT_EQ(frame_of(session)["frame"], 1);
  command(session, R"({"command":"step","frames":100})");
  const json last = frame_of(session);
  EXPECT_EQ(last["last"], true);
  EXPECT_EQ(last["frames"], last["frame"].get<int>() + 1);
  // All has come by now: the last values are the channel's.
  const auto& joints = testing::frames_of(recording, "joints", 1);
  const auto row = joints.row(joints.rows() - 1);
  EXPECT_EQ(last["channels"]["joints"].get<std::vector<float>>(),
            std::vector<float>(row.begin(), row.end()));
  command(session, R"({"command":"step","frames":-100})");
  EXPECT_EQ(frame_of(session)["frame"], 0);
}

TEST_F(SessionThread, ReturnsStripsThatEqualItsFrames) {
  ViewSession session(testing::hand_source(), resting());
  session.start();
  command(session, R"({"command":"seek","exploration":1,"frame":0})");
  const json strips = strips_of(session);
  EXPECT_EQ(strips["exploration"], 1);
  ASSERT_GT(strips["frames"], 1);
  ASSERT_EQ(strips["frame"].size(), strips["frames"]);
  for (std::size_t i = 0; i < strips["frames"]; ++i) {
    command(session, fmt::format(R"({{"command":"seek","exploration":1,"frame":{}}})", i));
    const json frame = frame_of(session);
    EXPECT_EQ(strips["frame"][i], frame["frame"]);
    EXPECT_EQ(strips["time"][i], frame["time"]);
    for (const char* channel : {"height", "wrist", "joints", "touch"}) {
      EXPECT_EQ(strips["channels"][channel][i], frame["channels"][channel]) << channel << i;
    }
    EXPECT_FALSE(strips["channels"].contains("sound"));
  }
}

TEST_F(SessionThread, PlaysAllExplorationsToTheirEnd) {
  ViewSession session(testing::hand_source(), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually([&] {
    const json state = state_of(session);
    return !state.is_null() && state["exploration"] == 2 && state["playing"] == false;
  }));
  EXPECT_EQ(frame_of(session)["last"], true);
}

TEST_F(SessionThread, PlaysTheFirstExplorationAfterTheLast) {
  ViewSession session(testing::hand_source(), {true, 1e-3, 0.0});
  session.start();
  command(session, R"({"command":"seek","exploration":2,"frame":0})");
  command(session, R"({"command":"step","frames":100})");
  ASSERT_EQ(frame_of(session)["last"], true);
  command(session, R"({"command":"play"})");
  EXPECT_EQ(frame_of(session)["exploration"], 0);
  EXPECT_EQ(frame_of(session)["frame"], 0);
}

TEST_F(SessionThread, WaitsForTheFirstViewer) {
  ViewSession session(testing::hand_source(), {true, 100.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] { return !state_of(session).is_null(); }));
  EXPECT_EQ(state_of(session)["playing"], false);
  const auto subscription = session.hub().subscribe(1);
  EXPECT_TRUE(eventually([&] { return state_of(session)["exploration"] == 2; }));
  EXPECT_EQ(state_of(session)["clients"], 1);
}

TEST_F(SessionThread, RestsWithoutViewersAndGoesOnWithTheNext) {
  ViewSession session(testing::hand_source(), {true, 0.01, 0.0});  // too slow to come to its end
  session.start();
  const auto is_playing = [&] { return json::parse(session.state().value())["playing"] == true; };
  for (int visit = 0; visit < 2; ++visit) {
    const auto subscription = session.hub().subscribe(1);
    EXPECT_TRUE(eventually(is_playing));
  }
  EXPECT_TRUE(eventually([&] { return !is_playing(); }));
  command(session, R"({"command":"seek","exploration":0,"frame":2})");
  const auto subscription = session.hub().subscribe(1);
  EXPECT_TRUE(eventually([&] { return state_of(session)["clients"] == 1; }));
  EXPECT_FALSE(is_playing());  // a command has been given meanwhile
}

TEST_F(SessionThread, StatesTheFrameToComeWhileItPlays) {
  ViewSession session(testing::hand_source(), {false, 100.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] { return frame_of(session)["frame"] > 1; }));
  const int shown = frame_of(session)["frame"];
  const json state = json::parse(session.state().value());
  EXPECT_TRUE(state["exploration"] > 0 || state["frame"] > shown);
}

TEST_F(SessionThread, RefusesWhatCannotBeDone) {
  ViewSession session(testing::hand_source(), resting());
  session.start();
  for (const char* text :
       {R"({"command":"explore"})", R"({"command":"thing","name":"ball"})",
        R"({"command":"train"})", R"({"command":"placement","x":0,"y":0,"turn":0})",
        R"({"command":"system","name":"x"})", R"({"command":"seek","exploration":3,"frame":0})"}) {
    const auto done = session.command(text);
    ASSERT_FALSE(done) << text;
    EXPECT_EQ(done.error().kind, ErrorKind::kUsage);
  }
}

TEST_F(SessionThread, TrainsASystemAndReadsWithIt) {
  ViewSession session(source_with_systems(), resting());
  session.start();
  ASSERT_TRUE(eventually([&] { return !state_of(session).is_null(); }));
  EXPECT_NE(state_of(session)["system_problem"], nullptr);
  EXPECT_EQ(state_of(session)["systems"][0]["learns"], true);
  EXPECT_EQ(state_of(session)["graph"]["map"], "map");
  EXPECT_EQ(state_of(session)["label"], "object");
  EXPECT_FALSE(session.neuron("map", 0));
  command(session, R"({"command":"train"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["training"] == false; }));
  EXPECT_EQ(state_of(session)["system_problem"], nullptr);
  const json training = latest(session, EventKind::kTraining);
  EXPECT_EQ(training["done"], true);
  EXPECT_EQ(training["winners"].size(), 6U);
  command(session, R"({"command":"seek","exploration":1,"frame":2})");
  const json frame = frame_of(session);
  EXPECT_TRUE(frame["reading"]["answer"].is_string());
  EXPECT_EQ(frame["maps"]["map"]["activity"].size(), 12U);
  EXPECT_EQ(frame["modules"]["code"]["shape"], (json{3, 4}));
  EXPECT_TRUE(session.neuron("map", 0));
  EXPECT_TRUE(session.taxel(0));
}

TEST_F(SessionThread, DoesNotTrainWhatWasGivenAsItHasLearned) {
  ViewSource source = source_with_systems();
  source.systems[0].trained = testing::trained_model(testing::crossed_system(), source.recording);
  source.systems[0].description = {};
  ViewSession session(std::move(source), resting());
  session.start();
  EXPECT_EQ(state_of(session)["systems"][0]["learns"], false);
  EXPECT_FALSE(session.command(R"({"command":"train"})"));
}

TEST_F(SessionThread, StopsTrainingOnRequest) {
  ViewSession session(source_with_systems(), {true, 1.0, 3600.0});  // s, after each snapshot
  session.start();
  command(session, R"({"command":"train"})");
  EXPECT_EQ(state_of(session)["training"], true);
  command(session, R"({"command":"stop_training"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["training"] == false; }));
  EXPECT_NE(state_of(session)["system_problem"], nullptr);
}

TEST_F(SessionThread, GivesTheSameReadingHoweverAFrameIsReached) {
  ViewSource source = source_with_systems();
  source.systems[0].trained = testing::trained_model(testing::crossed_system(), source.recording);
  ViewSession session(std::move(source), resting());
  session.start();
  command(session, R"({"command":"seek","exploration":2,"frame":2})");
  const json sought = frame_of(session);
  command(session, R"({"command":"seek","exploration":2,"frame":0})");
  command(session, R"({"command":"step","frames":1})");
  command(session, R"({"command":"step","frames":1})");
  EXPECT_EQ(frame_of(session), sought);
  command(session, R"({"command":"step","frames":1})");
  command(session, R"({"command":"step","frames":-1})");
  EXPECT_EQ(frame_of(session), sought);
}

TEST_F(SessionThread, ShowsTheMomentAgainAsAnotherSystemReadsIt) {
  ViewSource source = testing::hand_source(6);
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"crossed", testing::crossed_system()}, {"two", testing::two_maps_system()}}) {
    source.systems.push_back(testing::view_system(text, name));
    source.systems.back().trained = testing::trained_model(text, source.recording);
  }
  source.system = 0;
  ViewSession session(std::move(source), resting());
  session.start();
  command(session, R"({"command":"seek","exploration":1,"frame":1})");
  EXPECT_TRUE(frame_of(session)["modules"].contains("crossed"));
  command(session, R"({"command":"system","name":"two"})");
  const json frame = frame_of(session);
  EXPECT_EQ(frame["exploration"], 1);
  EXPECT_EQ(frame["frame"], 1);
  EXPECT_FALSE(frame["modules"].contains("crossed"));
  EXPECT_TRUE(frame["modules"].contains("both"));
}

TEST_F(SessionThread, SaysWhyASystemDoesNotFit) {
  ViewSource source = testing::hand_source();
  Recording other = testing::hand_recording(6, 9);
  ViewSystem given = testing::view_system(testing::crossed_system(), "given");
  given.trained = testing::trained_model(testing::crossed_system(), other);
  for (Exploration& one : source.recording.explorations) {
    one.channels[2].frames = Matrix<float>(one.channels[2].frames.rows(), 5);
    one.channels[2].shape = {5};
  }
  source.systems.push_back(std::move(given));
  source.system = 0;
  ViewSession session(std::move(source), resting());
  session.start();
  ASSERT_TRUE(eventually([&] { return !state_of(session).is_null(); }));
  const std::string problem = state_of(session)["system_problem"];
  EXPECT_NE(problem.find("do not fit"), std::string::npos) << problem;
  EXPECT_EQ(frame_of(session)["reading"], nullptr);
}

}  // namespace
}  // namespace somato
