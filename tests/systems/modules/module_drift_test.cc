#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/support/temporary_folder.h"
#include "somato/graph/system_model.h"
#include "systems/support/systems.h"
#include "systems/walk/walk.h"

namespace somato {
namespace {

using testing::build;
using testing::channels;
using testing::dense;
using testing::frames_of;
using testing::hand_recording;
using testing::module;
using testing::output_of;

// Means and differences in double precision, from the definitions.
Matrix<float> tared_frames(const Matrix<float>& frames, std::size_t first) {
  Matrix<float> out = frames;
  for (std::size_t t = 0; t < frames.rows(); ++t) {
    for (std::size_t j = 0; j < frames.columns(); ++j) {
      double sum = 0.0;
      const std::size_t count = std::min(t + 1, first);
      for (std::size_t i = 0; i < count; ++i) sum += double{frames(i, j)};
      out(t, j) = static_cast<float>(double{frames(t, j)} - sum / static_cast<double>(count));
    }
  }
  return out;
}

TEST(DriftModules, TareSubtractsWhatEachExplorationBeginsWith) {
  const Recording recording = hand_recording(5, 7);
  const System system =
      build(channels() + module("m", "tare", "input = \"joints\"\nframes = 2"), recording);
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    EXPECT_EQ(dense(output_of(system, recording, "m", i)),
              tared_frames(frames_of(recording, "joints", i), 2));
  }
}

// The sound has 100 frames per second: T f = 3, a = 3 / 4.
TEST(DriftModules, HighPassUsesTheRateOfTheChannel) {
  const Recording recording = hand_recording(3, 7);
  const System system = build(channels({"sound"}) + module("m", "high_pass",
                                                           "input = \"sound\"\n"
                                                           "time_constant = 0.03"),
                              recording);
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    const Matrix<float>& sound = frames_of(recording, "sound", i);
    const Matrix<float> out = dense(output_of(system, recording, "m", i));
    double expected = 0.0;
    for (std::size_t t = 0; t < sound.rows(); ++t) {
      if (t > 0) expected = 0.75 * (expected + double{sound(t, 0)} - double{sound(t - 1, 0)});
      EXPECT_NEAR(double{out(t, 0)}, expected, 1e-7);
    }
  }
}

// Times between frames are 0.02 s in the first exploration, and twice that in the others.
Recording timed_recording() {
  Recording recording = hand_recording(3, 7);
  double pause = 0.02;
  for (Exploration& exploration : recording.explorations) {
    for (Channel& channel : exploration.channels) {
      if (channel.name == "sound") continue;
      for (std::size_t i = 0; i < channel.frames.rows(); ++i) {
        channel.times.push_back(pause * static_cast<double>(i));
      }
    }
    pause = 0.04;
  }
  return recording;
}

const std::string kFiltered = channels() + module("m", "high_pass", "input = \"joints\"");

double decided_rate(const System& system) {
  const Table& settings = system.description().modules.back().settings;
  return std::get<double>(std::get<Value>(settings.find("rate")->content).content);
}

TEST(DriftModules, HighPassDecidesItsRateOnceByTheTimesOfTheFirstExploration) {
  const Recording recording = timed_recording();
  const System system = build(kFiltered, recording);
  EXPECT_NEAR(decided_rate(system), 50.0, 1e-9);
  // A recording with other times, and none: the trained system keeps its rate.
  Recording other = recording;
  std::swap(other.explorations[0], other.explorations[1]);
  const System again = System::build(system.description(), layout_of(other)).value();
  EXPECT_EQ(decided_rate(again), decided_rate(system));
  EXPECT_EQ(dense(output_of(again, recording, "m", 2)),
            dense(output_of(system, recording, "m", 2)));
  TemporaryFolder folder;
  ASSERT_TRUE(save_system(folder.file("model"), system));
  const SystemModel loaded = load_system(folder.file("model")).value();
  EXPECT_EQ(dense(output_of(loaded.system, recording, "m", 1)),
            dense(output_of(system, recording, "m", 1)));
}

TEST(DriftModules, HighPassRefusesAnUnknownRate) {
  const Recording recording = hand_recording(3, 7);
  const auto refused = testing::try_build(kFiltered, recording);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("the frame rate of its input is unknown; set 'rate'"),
            std::string::npos)
      << to_string(refused.error());
  EXPECT_TRUE(testing::try_build(kFiltered + "rate = 20\n", recording));
  EXPECT_FALSE(testing::try_build(kFiltered + "rate = 0\n", recording));
  EXPECT_FALSE(testing::try_build(kFiltered + "rate = 20\ntime_constant = 0\n", recording));
  const std::string windowed = channels({"sound"}) +
                               module("w", "onset_window", "input = \"sound\"\nthreshold = 0") +
                               module("m", "high_pass", "input = \"w\"");
  EXPECT_FALSE(testing::try_build(windowed, recording)) << "frames at other times";
}

// An exploration that grows, frame by frame, with times that change its estimated rate.
TEST(DriftModules, GiveTheSameWhileAnExplorationGrows) {
  const Recording recording = timed_recording();
  const System system =
      build(channels() + module("zero", "tare", "input = \"joints\"\nframes = 3") +
                module("m", "high_pass", "input = \"zero\"\ntime_constant = 0.1"),
            recording);
  const std::size_t last = *system.find("m");
  for (std::size_t index = 0; index < recording.explorations.size(); ++index) {
    const Matrix<float> whole = dense(output_of(system, recording, "m", index));
    Walk walk(system, {last}, Outputs::kLatest);
    const Exploration& exploration = recording.explorations[index];
    ASSERT_TRUE(walk.start(&exploration));
    for (std::size_t frame = 0; frame < whole.rows(); ++frame) {
      const std::vector<std::size_t> frames(exploration.channels.size(), frame + 1);
      ASSERT_TRUE(walk.follow(frames));
      std::vector<float> now(3);
      write_dense(*walk.output(last), now);
      const auto row = whole.row(frame);
      EXPECT_EQ(now, std::vector<float>(row.begin(), row.end()));
    }
  }
}

}  // namespace
}  // namespace somato
