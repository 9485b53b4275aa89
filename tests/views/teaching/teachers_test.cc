#include "views/teaching/teachers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "views/live/sessions.h"
#include "views/live/view_session.h"
#include "views/live/view_systems.h"
#include "views/live/viewing.h"

namespace somato {
namespace {

using nlohmann::json;
using testing::command;
using testing::eventually;
using testing::frame_of;
using testing::state_of;

// `nothing_is_known`: every exploration is too far from what was learned.
ViewSystem trained_system(bool nothing_is_known) {
  SystemModel model =
      copy_of(*testing::trained_model(testing::crossed_system(), testing::hand_recording(6, 2)));
  if (nothing_is_known) {
    model.answer->novelty =
        Novelty{0.05, 20, 1.0, std::vector<double>(model.answer->classes.size(), 1e-3)};
  }
  ViewSystem system = testing::view_system(testing::crossed_system(), "crossed");
  system.trained = std::make_shared<const SystemModel>(std::move(model));
  return system;
}

ViewSource with_system(ViewSource source, bool nothing_is_known = false) {
  source.systems.push_back(trained_system(nothing_is_known));
  source.system = 0;
  return source;
}

void go_to_end_of(ViewSession& session, int exploration) {
  command(session,
          R"({"command":"seek","exploration":)" + std::to_string(exploration) + R"(,"frame":0})");
  command(session, R"({"command":"step","frames":1000})");
}

TEST(TeachersThread, LearnTheNameOfAnExplorationThatHasEnded) {
  ViewSession session(with_system(testing::hand_source(3), true), {true, 1.0, 0.0});
  session.start();
  go_to_end_of(session, 1);
  EXPECT_EQ(state_of(session)["teaches"], true);
  EXPECT_EQ(state_of(session)["taught"], json::array());
  EXPECT_EQ(frame_of(session)["reading"]["answer"], "unknown");
  EXPECT_GT(frame_of(session)["reading"]["novelty"], 1.0);
  command(session, R"({"command":"name","label":"object","value":"cup"})");
  const json taught = state_of(session)["taught"];
  ASSERT_EQ(taught.size(), 1U);
  EXPECT_EQ(taught[0]["exploration"], 1);
  EXPECT_EQ(taught[0]["name"], "cup");
  EXPECT_EQ(taught[0]["before"], "unknown");
  EXPECT_EQ(taught[0]["problem"], nullptr);
  EXPECT_EQ(frame_of(session)["reading"]["answer"], "cup");
  const json maps = state_of(session)["maps"];
  EXPECT_EQ(maps[0]["classes"].back(), "cup");
  const std::size_t neuron = taught[0]["neuron"];
  EXPECT_EQ(maps[0]["neuron_classes"][neuron], maps[0]["classes"].size() - 1);
  // Another label is not what the system answers.
  command(session, R"({"command":"name","label":"colour","value":"red"})");
  EXPECT_EQ(state_of(session)["taught"], taught);
}

void undo(ViewSession& session, const std::string& value, int id) {
  command(session,
          json{{"command", "undo_name"}, {"label", "object"}, {"value", value}, {"id", id}}.dump());
}

// The last name is taken back first; the one before it is learned again.
TEST(TeachersThread, ForgetANameThatIsUndone) {
  ViewSession session(with_system(testing::hand_source(2), true), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually(
      [&] { return frame_of(session)["last"] == true && state_of(session)["exploration"] == 1; }));
  const json before = state_of(session);
  command(session, R"({"command":"name","label":"object","value":"cup"})");
  command(session, R"({"command":"name","label":"object","value":"mug"})");
  ASSERT_EQ(state_of(session)["taught"].size(), 1U);
  EXPECT_EQ(state_of(session)["taught"][0]["name"], "mug");
  undo(session, "mug", 1);
  ASSERT_EQ(state_of(session)["taught"].size(), 1U);
  EXPECT_EQ(state_of(session)["taught"][0]["name"], "cup");
  undo(session, "cup", 1);
  EXPECT_EQ(state_of(session)["taught"], json::array());
  EXPECT_EQ(state_of(session)["maps"], before["maps"]);
  EXPECT_EQ(state_of(session)["labels"], before["labels"]);
  EXPECT_EQ(state_of(session)["naming"]["last"], nullptr);
}

// The receiver of the readings learns of it.
TEST(TeachersThread, SayThatANameIsForgotten) {
  ViewSource source = with_system(testing::hand_source(2), true);
  std::vector<std::string> said;
  source.readings.on_begin = [](const Exploration&) { return Result<void>(); };
  source.readings.on_moment = [](const live::SaidReading&) { return Result<void>(); };
  source.readings.on_end = [](const live::SaidReading&, const Exploration&) {
    return Result<void>();
  };
  source.readings.on_taught = [&](const live::TaughtName& name) {
    said.push_back("taught " + name.name);
    return Result<void>();
  };
  source.readings.on_forgotten = [&](const GivenName& name) {
    said.push_back("forgotten " + name.label.value);
    return Result<void>();
  };
  source.readings.on_done = [](const Result<void>&) {};
  ViewSession session(std::move(source), {true, 1.0, 0.0});
  session.start();
  command(session, R"({"command":"step","frames":1000})");
  for (const std::string value : {"cup", "mug"}) {
    command(session, R"({"command":"name","label":"object","value":")" + value + "\"}");
  }
  for (const std::string value : {"mug", "cup"}) undo(session, value, 0);
  session.stop();
  EXPECT_EQ(said,
            (std::vector<std::string>{"taught cup", "taught mug", "taught cup", "forgotten cup"}));
}

TEST(TeachersThread, LearnTheNameOfAnExplorationInProgressWhenItEnds) {
  ViewSession session(with_system(testing::body_source(200), true), {false, 1.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] { return state_of(session)["live"] == true; }));
  command(session, R"({"command":"name","label":"object","value":"cup"})");
  EXPECT_EQ(state_of(session)["taught"], json::array());
  command(session, R"({"command":"speed","speed":100})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["taught"].size() == 1; }));
  EXPECT_EQ(state_of(session)["taught"][0]["name"], "cup");
  EXPECT_EQ(frame_of(session)["reading"]["answer"], "cup");
  session.stop();
  EXPECT_EQ(session.system()->answer->classes.back(), "cup");
}

// The first exploration has ended as soon as it is shown.
TEST(TeachersThread, LearnTheNameOfAFirstExplorationOfOneFrame) {
  ViewSource source = with_system(testing::hand_source(3), true);
  for (Exploration& exploration : source.recording.explorations) {
    for (Channel& channel : exploration.channels) {
      const auto first = channel.frames.row(0);
      channel.frames = Matrix<float>(1, first.size(), {first.begin(), first.end()});
      channel.times.clear();
    }
  }
  std::vector<std::pair<std::size_t, std::string>> taught;
  std::atomic<bool> done{false};
  source.readings.on_begin = [](const Exploration&) { return Result<void>(); };
  source.readings.on_moment = [](const live::SaidReading&) { return Result<void>(); };
  source.readings.on_end = [](const live::SaidReading&, const Exploration&) {
    return Result<void>();
  };
  source.readings.name_of = [](const live::SaidReading& said) {
    return std::optional("thing " + std::to_string(said.exploration));
  };
  source.readings.on_taught = [&](const live::TaughtName& name) {
    taught.emplace_back(name.exploration, name.name);
    return Result<void>();
  };
  source.readings.on_done = [&](const Result<void>&) { done = true; };
  ViewSession session(std::move(source), {false, 100.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] { return done.load(); }));
  session.stop();
  const std::vector<std::pair<std::size_t, std::string>> all{
      {0, "thing 0"}, {1, "thing 1"}, {2, "thing 2"}};
  EXPECT_EQ(taught, all);
}

TEST(TeachersThread, DoNotTeachWhereTheSourceForbidsIt) {
  ViewSource source = with_system(testing::hand_source(3));
  source.teaches = false;
  ViewSession session(std::move(source), {true, 1.0, 0.0});
  session.start();
  go_to_end_of(session, 1);
  EXPECT_EQ(state_of(session)["teaches"], false);
  command(session, R"({"command":"name","label":"object","value":"cup"})");
  EXPECT_EQ(state_of(session)["labels"]["object"], "cup");
  EXPECT_EQ(state_of(session)["taught"], json::array());
}

// All is unknown until it has been named; with each round the system begins anew.
TEST(TeachersThread, NameUnknownThingsOfADemonstration) {
  ViewSource source = with_system(testing::body_source(), true);
  source.demonstrates = true;
  source.plan = {{0, 0}, {1, 0}};
  ViewSession session(std::move(source), {false, 100.0, 0.0, 0.02});
  session.start();
  json taught;
  ASSERT_TRUE(eventually([&] { return (taught = state_of(session)["taught"]).size() == 2; }));
  EXPECT_EQ(taught[0]["name"], "ball");
  EXPECT_EQ(taught[1]["name"], "cube");
  EXPECT_EQ(taught[0]["before"], "unknown");
  ASSERT_TRUE(eventually([&] { return state_of(session)["taught"].size() < 2; }));
  EXPECT_TRUE(eventually([&] { return state_of(session)["taught"].size() == 2; }));
  EXPECT_GE(state_of(session)["demonstrated"], 1);
}

}  // namespace
}  // namespace somato
