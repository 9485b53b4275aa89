#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "views/live/reading_listener.h"
#include "views/live/sessions.h"
#include "views/live/view_session.h"
#include "views/live/view_systems.h"
#include "views/live/viewing.h"
#include "views/replay/fake_explorer.h"
#include "views/replay/timeline.h"
#include "views/session/system_reading.h"

namespace somato {
namespace {

using live::SaidReading;
using testing::answer_of;
using testing::command;
using testing::planned_source;
using testing::ReadingListener;
using testing::SaidMoment;
using testing::source_with_readings;

// By evaluating each exploration from its start to each moment.
std::vector<SaidMoment> expected_of(const std::vector<Exploration>& explorations) {
  auto reader = live::SystemReading::build(testing::crossed_model()).value();
  std::vector<SaidMoment> expected;
  for (std::size_t index = 0; index < explorations.size(); ++index) {
    const Exploration& exploration = explorations[index];
    const live::Timeline timeline(exploration);
    for (std::size_t moment = 0; moment < timeline.moments(); ++moment) {
      std::vector<std::size_t> frames;
      for (std::size_t i = 0; i < exploration.channels.size(); ++i) {
        frames.push_back(timeline.frames(i, moment));
      }
      reader.start();
      EXPECT_TRUE(reader.follow(exploration, frames));
      const auto reading = reader.read().value();
      expected.push_back({index, moment + 1, timeline.time(moment) - timeline.time(0),
                          reading ? answer_of(*reading) : std::nullopt});
    }
    EXPECT_TRUE(expected.back().answer);
    expected.push_back(expected.back());
    expected.back().object = *find_label(exploration, "object");
  }
  return expected;
}

void expect_said(const std::vector<SaidMoment>& said, const std::vector<SaidMoment>& expected) {
  ASSERT_EQ(said.size(), expected.size());
  for (std::size_t i = 0; i < said.size(); ++i) {
    EXPECT_NEAR(said[i].time, expected[i].time, 1e-9);
    SaidMoment same_time = said[i];
    same_time.time = expected[i].time;
    EXPECT_EQ(same_time, expected[i]) << i;
  }
}

TEST(SessionReadingsThread, AreSaidOfEachMomentOfARecordingOnce) {
  ReadingListener listener;
  ViewSession session(source_with_readings(testing::hand_source(3), listener), {false, kFastest});
  session.start();
  EXPECT_TRUE(listener.wait());
  session.stop();
  expect_said(listener.said_, expected_of(session.recording().explorations));
}

TEST(SessionReadingsThread, AreSaidOnceThoughAViewerGoesBackAndAhead) {
  ReadingListener listener;
  ViewSession session(source_with_readings(testing::hand_source(3), listener), {true, kFastest});
  session.start();
  for (const std::string frame : {"2", "0", "1", "3"}) {
    command(session, R"({"command":"seek","exploration":0,"frame":)" + frame + "}");
  }
  EXPECT_FALSE(session.command(R"({"command":"seek","exploration":1,"frame":0})"));
  command(session, R"({"command":"step","frames":-2})");
  command(session, R"({"command":"play"})");
  EXPECT_TRUE(listener.wait());
  command(session, R"({"command":"seek","exploration":0,"frame":0})");
  session.stop();
  expect_said(listener.said_, expected_of(session.recording().explorations));
}

TEST(SessionReadingsThread, OfABodyAreThoseOfItsRecording) {
  ReadingListener listener;
  ViewSession session(
      source_with_readings(planned_source(std::make_unique<testing::FakeExplorer>()), listener),
      {false, kFastest});
  session.start();
  EXPECT_TRUE(listener.wait());
  EXPECT_FALSE(session.command(R"({"command":"explore"})"));
  EXPECT_FALSE(session.command(R"({"command":"thing","name":"cube"})"));
  session.stop();
  const auto& explored = session.recording().explorations;
  ASSERT_EQ(explored.size(), 3U);
  expect_said(listener.said_, expected_of(explored));
  EXPECT_EQ(listener.said_.back().object, "cube");
  EXPECT_EQ(listener.channels_, 4U);
  const testing::FakeExplorer again;
  const ExploreOptions unobserved{
      .observer = {[](const auto&, const auto&) -> Result<void> { return {}; },
                   [](const auto&) -> Result<void> { return {}; }}};
  EXPECT_EQ(explored[1], again.explore(0, 1, unobserved).value());
}

// Gives twice as many frames as were felt, as a probe whose recording has another form.
class LongerExplorer : public testing::FakeExplorer {
 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions& options) const override {
    auto exploration = FakeExplorer::simulate(thing, trial, options);
    if (!exploration) return exploration;
    for (Channel& channel : exploration->channels) {
      const Matrix<float> felt = channel.frames;
      channel.frames.append(felt);
      channel.times.clear();
    }
    return exploration;
  }
};

TEST(SessionReadingsThread, OfAnExplorationOfAnotherFormHaveItsEndOnly) {
  ReadingListener listener;
  ViewSession session(
      source_with_readings(planned_source(std::make_unique<LongerExplorer>()), listener),
      {false, kFastest});
  session.start();
  EXPECT_TRUE(listener.wait());
  session.stop();
  const std::vector<SaidMoment> expected = expected_of(session.recording().explorations);
  ASSERT_EQ(expected.size(), 33U) << "ten frames of three explorations, and their ends";
  ASSERT_EQ(listener.said_.size(), 18U) << "five recorded steps of each, and the ends";
  for (std::size_t i = 0; i < 3; ++i) {
    const SaidMoment& end = listener.said_[6 * i + 5];
    EXPECT_EQ(end.moments, 5U);
    EXPECT_EQ(end.answer, expected[11 * i + 10].answer) << "of the whole exploration";
    EXPECT_EQ(end.object, expected[11 * i + 10].object);
  }
}

// Its second trial fails after its steps.
class FailingExplorer : public testing::FakeExplorer {
 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions& options) const override {
    auto exploration = FakeExplorer::simulate(thing, trial, options);
    if (exploration && trial == 1) return fail(ErrorKind::kData, "the hand is stuck");
    return exploration;
  }
};

TEST(SessionReadingsThread, GoOnAfterAnExplorationThatFails) {
  ReadingListener listener;
  ViewSession session(
      source_with_readings(planned_source(std::make_unique<FailingExplorer>()), listener),
      {false, kFastest});
  session.start();
  EXPECT_TRUE(listener.wait());
  session.stop();
  EXPECT_EQ(listener.failures_, std::vector<std::string>{"the hand is stuck"});
  // Moments of the failed exploration are those of an exploration that has no end.
  std::vector<std::string> ends;
  std::size_t moments = 0;
  for (const SaidMoment& said : listener.said_) {
    if (said.object.empty()) ++moments;
    if (!said.object.empty()) ends.push_back(said.object);
  }
  EXPECT_EQ(ends, (std::vector<std::string>{"ball", "cube"}));
  EXPECT_EQ(moments, 15U) << "five recorded steps of three explorations";
}

// A name is learned before the next exploration begins.
TEST(SessionReadingsThread, TakeNamesFromTheirReceiver) {
  ReadingListener listener;
  ViewSource source =
      source_with_readings(planned_source(std::make_unique<testing::FakeExplorer>()), listener);
  std::vector<std::string> events;
  source.readings.on_begin = [&](const Exploration&) -> Result<void> {
    events.emplace_back("begin");
    return {};
  };
  source.readings.name_of = [](const SaidReading& said) {
    return said.exploration == 1 ? std::optional<std::string>("cup") : std::nullopt;
  };
  source.readings.on_taught = [&](const live::TaughtName& name) -> Result<void> {
    events.push_back(name.name + " for " + std::to_string(name.exploration) + name.problem);
    return {};
  };
  ViewSession session(std::move(source), {false, kFastest});
  session.start();
  EXPECT_TRUE(listener.wait());
  session.stop();
  EXPECT_EQ(events, (std::vector<std::string>{"begin", "begin", "cup for 1", "begin"}));
  EXPECT_EQ(session.system()->answer->classes.back(), "cup");
}

TEST(SessionReadingsThread, EndWithAnErrorOfTheirReceiver) {
  ReadingListener listener;
  listener.refuses_ = true;
  ViewSession session(source_with_readings(testing::hand_source(3), listener), {false, kFastest});
  session.start();
  const auto done = listener.wait();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what, "refused");
  session.stop();
  EXPECT_TRUE(listener.said_.empty());
}

TEST(SessionReadingsThread, EndWithTheErrorOfASystemThatCannotFollow) {
  ReadingListener listener;
  ViewSource source = source_with_readings(testing::hand_source(3), listener);
  for (Exploration& exploration : source.recording.explorations) {
    for (Channel& channel : exploration.channels) {
      if (channel.name == "joints") channel.name = "elbows";
    }
  }
  ViewSession session(std::move(source), {false, kFastest});
  session.start();
  const auto done = listener.wait();
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().what.find("joints"), std::string::npos) << done.error().what;
  session.stop();
}

}  // namespace
}  // namespace somato
