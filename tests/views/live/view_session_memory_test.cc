#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/support/temporary_folder.h"
#include "somato/recording/recording_file.h"
#include "views/live/reading_listener.h"
#include "views/live/sessions.h"
#include "views/live/view_session.h"
#include "views/replay/fake_explorer.h"

namespace somato {
namespace {

using testing::FakeExplorer;
using testing::planned_source;
using testing::ReadingListener;
using testing::SaidMoment;
using testing::source_with_readings;

// A frame of the fake body has 9 values and 4 times, 68 bytes, and a pose for the page.
constexpr std::size_t kFrame = 9 * sizeof(float) + 4 * sizeof(double);

ViewSettings settings_of(std::size_t memory, bool has_page) {
  return {.wait_for_viewer = false, .speed = kFastest, .has_page = has_page, .memory = memory};
}

// The readings of a session of so many explorations, each of so many recorded steps.
std::vector<SaidMoment> readings(std::size_t explorations, std::size_t steps,
                                 const ViewSettings& settings, GrowingRecording* file = nullptr) {
  ReadingListener listener;
  ViewSource source = planned_source(std::make_unique<FakeExplorer>(2 * steps));
  source.plan.clear();
  for (std::size_t i = 0; i < explorations; ++i) source.plan.push_back({i % 2, i});
  source.file = file;
  ViewSession session(source_with_readings(std::move(source), listener), settings);
  session.start();
  EXPECT_TRUE(listener.wait());
  session.stop();
  EXPECT_LE(session.recording().explorations.size(), explorations);
  return listener.said_;
}

TEST(SessionMemoryThread, WhatIsNotKeptHasTheSameReadings) {
  constexpr std::size_t kExplorations = 6;
  constexpr std::size_t kSteps = 40;
  const auto all = readings(kExplorations, kSteps, settings_of(kPageMemory, true));
  ASSERT_EQ(all.size(), kExplorations * (kSteps + 1));
  // Room for four explorations, and for a quarter of one.
  for (const std::size_t memory : {16 * kSteps * kFrame, kSteps * kFrame}) {
    for (const bool has_page : {true, false}) {
      EXPECT_EQ(readings(kExplorations, kSteps, settings_of(memory, has_page)), all)
          << memory << " " << has_page;
    }
  }
}

TEST(SessionMemoryThread, WhatIsNotKeptIsInTheFile) {
  const TemporaryFolder folder;
  std::vector<Recording> saved;
  for (const std::size_t memory : {kPageMemory, 40 * kFrame}) {
    const std::string path = folder.file(std::to_string(memory) + ".mcap");
    const auto file = GrowingRecording::begin(path).value();
    readings(3, 40, settings_of(memory, true), file.get());
    ASSERT_TRUE(file->finish());
    saved.push_back(read_recording(path).value());
  }
  ASSERT_EQ(saved[0].explorations.size(), 3U);
  ASSERT_EQ(saved[1].explorations.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(saved[1].explorations[i].channels.size(), 4U);
    for (std::size_t channel = 0; channel < 4; ++channel) {
      EXPECT_EQ(saved[1].explorations[i].channels[channel].frames,
                saved[0].explorations[i].channels[channel].frames);
    }
  }
}

// Room for no more than six of eight explorations of ten frames.
TEST(SessionMemoryThread, ThePageNamesWhatIsNoLongerKept) {
  ReadingListener listener;
  ViewSource source = planned_source(std::make_unique<FakeExplorer>(20));
  for (std::size_t trial = 2; trial < 7; ++trial) source.plan.push_back({0, trial});
  ViewSession session(source_with_readings(std::move(source), listener),
                      settings_of(60 * kFrame, true));
  session.start();
  EXPECT_TRUE(listener.wait());
  const nlohmann::json state = testing::state_of(session);
  const std::size_t dropped = state["dropped"];
  EXPECT_GE(dropped, 2U);
  EXPECT_EQ(state["first_frame"], 0);
  ASSERT_EQ(state["explorations"].size() + dropped, 8U);
  EXPECT_EQ(state["explorations"][0]["index"], dropped);
  const auto seek = [&](std::size_t exploration, int frame) {
    return session.command(R"({"command":"seek","exploration":)" + std::to_string(exploration) +
                           R"(,"frame":)" + std::to_string(frame) + "}");
  };
  const auto refused = seek(dropped - 1, 0);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("no longer kept"), std::string::npos);
  EXPECT_TRUE(seek(7, 3));
  EXPECT_TRUE(testing::eventually([&] { return testing::frame_of(session)["frame"] == 3; }));
  EXPECT_EQ(testing::frame_of(session)["exploration"], 7);
  session.stop();
}

// One exploration of more memory than permitted: it is shown while it takes place.
TEST(SessionMemoryThread, AnExplorationThatIsTooLongCannotBeShownOrTaught) {
  ReadingListener listener;
  ViewSource source = planned_source(std::make_unique<FakeExplorer>(400));
  source.teaches = true;
  source = source_with_readings(std::move(source), listener);
  std::vector<std::string> taught;
  source.readings.name_of = [](const live::SaidReading&) { return std::string("cup"); };
  source.readings.on_taught = [&](const live::TaughtName& name) -> Result<void> {
    taught.push_back(name.problem);
    return {};
  };
  ViewSession session(std::move(source), settings_of(100 * kFrame, true));
  session.start();
  EXPECT_TRUE(listener.wait());
  const nlohmann::json state = testing::state_of(session);
  EXPECT_EQ(state["dropped"], 3);
  EXPECT_EQ(state["explorations"].size(), 0U);
  EXPECT_NE(state["problem"].get<std::string>().find("Exploration 3"), std::string::npos);
  session.stop();
  ASSERT_EQ(taught.size(), 3U);
  EXPECT_NE(taught[0].find("no longer kept"), std::string::npos) << taught[0];
}

}  // namespace
}  // namespace somato
