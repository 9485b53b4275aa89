#include "somato/recording/inspect_recording.h"

#include <gtest/gtest.h>

#include "base/support/temporary_folder.h"
#include "recordings/support/random_recordings.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

TEST(InspectRecording, CountsWhatReadingGives) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 500; seed < 530; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Recording recording = testing::random_recording(random);
    ASSERT_TRUE(write_recording(folder.file("a"), recording));
    const RecordingSummary summary = inspect_recording(folder.file("a")).value();
    EXPECT_FALSE(summary.damage);
    EXPECT_EQ(summary.explorations, recording.explorations.size());
    EXPECT_EQ(summary.size, bytes_of(folder.file("a")).size());
    EXPECT_EQ(summary.compression, "zstd");
    const Exploration& first = recording.explorations[0];
    ASSERT_EQ(summary.labels.size(), first.labels.size());
    for (std::size_t i = 0; i < first.labels.size(); ++i) {
      EXPECT_EQ(summary.labels[i].name, first.labels[i].name);
      EXPECT_EQ(summary.labels[i].others, 0U);
      const auto values = label_values(recording, first.labels[i].name).value();
      ASSERT_EQ(summary.labels[i].values.size(), values.size());
      for (std::size_t v = 0; v < values.size(); ++v) {
        EXPECT_EQ(summary.labels[i].values[v].value, values[v]);
        const auto has_it = [&](const Exploration& e) { return e.labels[i].value == values[v]; };
        EXPECT_EQ(
            summary.labels[i].values[v].explorations,
            std::count_if(recording.explorations.begin(), recording.explorations.end(), has_it));
      }
    }
    ASSERT_EQ(summary.channels.size(), first.channels.size());
    for (std::size_t c = 0; c < first.channels.size(); ++c) {
      std::size_t least = SIZE_MAX;
      std::size_t most = 0;
      for (const Exploration& exploration : recording.explorations) {
        least = std::min(least, exploration.channels[c].frames.rows());
        most = std::max(most, exploration.channels[c].frames.rows());
      }
      EXPECT_EQ(summary.channels[c].description, description_of(first.channels[c]));
      EXPECT_EQ(summary.channels[c].elements, first.channels[c].frames.columns());
      EXPECT_EQ(summary.channels[c].least_frames, least);
      EXPECT_EQ(summary.channels[c].most_frames, most);
      EXPECT_EQ(summary.channels[c].explorations, recording.explorations.size());
    }
  }
}

TEST(InspectRecording, FindsRangesOfRatesAndElements) {
  const TemporaryFolder folder;
  const auto exploration = [](double rate, std::vector<float> values) {
    Channel channel{"sound", "", {}, Matrix<float>(2, 2, std::move(values)), {}, rate};
    channel.valid = Matrix<std::uint8_t>(2, 2, std::vector<std::uint8_t>{1, 1, 1, 0});
    return Exploration{{}, "", {channel}};
  };
  ASSERT_TRUE(write_recording(folder.file("a"), {{exploration(44100.0, {1, 2, 3, 0}),
                                                  exploration(8000.0, {-1, 7, 5, 0})}}));
  const ChannelSummary summary = inspect_recording(folder.file("a")).value().channels.at(0);
  EXPECT_EQ(summary.least_rate, 8000.0);
  EXPECT_EQ(summary.most_rate, 44100.0);
  EXPECT_EQ(summary.ranges, (std::vector<ElementRange>{{-1.0F, 5.0F, 4, 0}, {2.0F, 7.0F, 2, 2}}));
}

TEST(InspectRecording, FailsForOtherFiles) {
  const TemporaryFolder folder;
  EXPECT_EQ(inspect_recording(folder.file("a")).error().kind, ErrorKind::kSystem);
  EXPECT_EQ(inspect_recording(folder.with("a", "1,2\n")).error().kind, ErrorKind::kData);
}

}  // namespace
}  // namespace somato
