#include "views/replay/recorded_explorer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/support/temporary_folder.h"
#include "recordings/explorations/recording_outline.h"
#include "views/replay/growing_exploration.h"

namespace somato::live {
namespace {

class RecordedExplorerTest : public ::testing::Test {
 protected:
  std::string saved(const Recording& recording) {
    const std::string path = folder_.file("recording.mcap");
    const auto written = write_recording(path, recording);
    EXPECT_TRUE(written) << to_string(written.error());
    return path;
  }

  TemporaryFolder folder_;
};

Channel channel(const char* name, std::size_t frames, double rate, std::vector<double> times) {
  Channel channel;
  channel.name = name;
  channel.rate = rate;
  channel.times = std::move(times);
  channel.frames = Matrix<float>(frames, 2);
  for (std::size_t i = 0; i < channel.frames.values().size(); ++i) {
    channel.frames.values()[i] = static_cast<float>(i + 1);
  }
  return channel;
}

std::vector<double> evenly(std::size_t frames, double step, double first) {
  std::vector<double> times(frames);
  for (std::size_t i = 0; i < frames; ++i) times[i] = first + step * static_cast<double>(i);
  return times;
}

// A skin of 125 Hz with missing values, slower joints, a sound, and numbers without times.
Recording four_channels(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto some = [&](std::size_t most) { return 1 + random() % most; };
  Recording recording;
  for (int i = 0; i < 3; ++i) {
    const std::size_t touched = some(300);
    Exploration exploration{{{"object", "cup" + std::to_string(i)}}, "rig", {}};
    exploration.channels = {channel("touch", touched, 0.0, evenly(touched, 0.008, 2.0))};
    exploration.channels[0].valid = Matrix<std::uint8_t>(touched, 2, 1);
    exploration.channels[0].valid(touched / 2, 1) = 0;
    exploration.channels[0].frames(touched / 2, 1) = 0.0F;
    const std::size_t joints = some(30);
    exploration.channels.push_back(channel("joints", joints, 0.0, evenly(joints, 0.1, 2.25)));
    exploration.channels.push_back(channel("sound", some(2000), 1000.0, {}));
    exploration.channels.push_back(channel("weight", some(5), 0.0, {}));
    recording.explorations.push_back(std::move(exploration));
  }
  return recording;
}

// An exploration as a page or a system receives it.
struct Received {
  std::vector<double> times;
  std::vector<std::vector<std::size_t>> frames;
  Exploration exploration;
};

Result<Received> receive(RecordedExplorer& explorer, std::size_t index) {
  Received received;
  std::optional<GrowingExploration> growing;
  ExploreOptions options;
  options.observer.on_begin = [&](const BodyDescription& body, const Scene& scene) -> Result<void> {
    growing.emplace(index, body, std::make_shared<Scene>(scene));
    return {};
  };
  options.observer.on_step = [&](const ExplorationStep& step) -> Result<void> {
    growing->append({step.state, step.poses, step.readings});
    return {};
  };
  SOMATO_TRY(const Exploration played, explorer.explore(0, index, options));
  const PlayedExploration grown = growing->played();
  received.exploration = *grown.exploration;
  received.exploration.labels = played.labels;
  for (std::size_t i = 0; i < grown.timeline->moments(); ++i) {
    received.times.push_back(grown.timeline->time(i));
    received.frames.emplace_back();
    for (std::size_t k = 0; k < played.channels.size(); ++k) {
      received.frames.back().push_back(grown.timeline->frames(k, i));
    }
  }
  return received;
}

TEST_F(RecordedExplorerTest, GivesTheMomentsAndFramesOfTheWholeRecording) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Recording recording = four_channels(seed);
    const auto explorer = RecordedExplorer::open(saved(recording), false);
    ASSERT_TRUE(explorer) << to_string(explorer.error());
    EXPECT_EQ((*explorer)->layout(), layout_of(recording));
    ASSERT_EQ((*explorer)->explorations(), recording.explorations.size());
    for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
      const Exploration& expected = recording.explorations[i];
      const auto received = receive(**explorer, i);
      ASSERT_TRUE(received) << to_string(received.error());
      EXPECT_EQ(received->exploration.labels, expected.labels);
      const Timeline timeline(expected);
      ASSERT_EQ(received->times.size(), timeline.moments());
      for (std::size_t m = 0; m < timeline.moments(); ++m) {
        EXPECT_NEAR(received->times[m] - received->times[0], timeline.time(m) - timeline.time(0),
                    1e-9);
        for (std::size_t k = 0; k < expected.channels.size(); ++k) {
          ASSERT_EQ(received->frames[m][k], timeline.frames(k, m)) << seed << " " << m << " " << k;
        }
      }
      for (std::size_t k = 0; k < expected.channels.size(); ++k) {
        const Channel& grown = received->exploration.channels[k];
        EXPECT_EQ(grown.frames, expected.channels[k].frames);
        EXPECT_EQ(grown.valid, expected.channels[k].valid);
        EXPECT_EQ(grown.frame_rate(), expected.channels[k].frame_rate());
      }
    }
  }
}

TEST_F(RecordedExplorerTest, CollectsFramesOnRequestAsFarAsPermitted) {
  const Recording recording = four_channels(7);
  const std::string path = saved(recording);
  const auto explorer = RecordedExplorer::open(path, true);
  ASSERT_TRUE(explorer);
  auto first = (*explorer)->explore(0, 0);
  ASSERT_TRUE(first) << to_string(first.error());
  EXPECT_EQ(first->channels, read_recording(path)->explorations[0].channels);
  ExploreOptions little;
  little.limits.memory = 100;
  const auto second = (*explorer)->explore(0, 1, little);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->channels[2].frames, Matrix<float>(0, 2));
  const auto other = RecordedExplorer::open(saved(recording), false);
  EXPECT_EQ((*other)->explore(0, 0)->channels[2].frames, Matrix<float>(0, 2));
}

TEST_F(RecordedExplorerTest, EndsWhenItIsStoppedAndAfterTheLastExploration) {
  Recording recording = four_channels(3);
  recording.explorations.resize(1);
  const std::string path = saved(recording);
  const auto explorer = RecordedExplorer::open(path, false);
  ASSERT_TRUE((*explorer)->explore(0, 0));
  EXPECT_EQ((*explorer)->explore(0, 0).error().kind, ErrorKind::kUnavailable);
  const auto stopped = RecordedExplorer::open(path, false);
  ExploreOptions options;
  options.limits.should_continue = [] { return false; };
  EXPECT_EQ((*stopped)->explore(0, 0, options).error().kind, ErrorKind::kInterrupted);
}

TEST_F(RecordedExplorerTest, RefusesWhatIsNoValidRecording) {
  const std::string empty = folder_.file("empty.mcap");
  ASSERT_TRUE(RecordingFile::begin(empty)->finish());
  EXPECT_EQ(RecordedExplorer::open(empty, false).error().what, "the recording has no explorations");
  EXPECT_EQ(RecordedExplorer::open(folder_.file("missing.mcap"), false).error().kind,
            ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato::live
