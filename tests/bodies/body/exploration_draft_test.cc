#include "bodies/body/exploration_draft.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/support/eventually.h"
#include "base/support/temporary_folder.h"
#include "bodies/body/frame_log.h"
#include "somato/recording/recording_file.h"
#include "somato/recording/recover_recording.h"

namespace somato {
namespace {

BodyDescription sensing_body() {
  BodyDescription body;
  body.name = "hand";
  body.sensors = {{"touch", "N", {"a", "b"}, {}, 0.0, true},
                  {"sound", "V", {}, {}, 100.0, false},
                  {"unclocked", "", {}, {2, 1}, 0.0, false}};
  return body;
}

BodyState sensed_state(double time, std::vector<float> touch, std::vector<float> sound) {
  const std::size_t taxels = touch.size();
  const std::size_t samples = sound.size();
  BodyState state;
  state.time = time;
  state.readings = {Matrix<float>(1, taxels, std::move(touch)),
                    Matrix<float>(samples, samples == 0 ? 0 : 1, std::move(sound)),
                    Matrix<float>(1, 2, {7, 8})};
  return state;
}

class ExplorationDraftTest : public ::testing::Test {
 protected:
  // The exploration that can be recovered, once it has so many frames of touch.
  Exploration recovered(std::size_t frames) const {
    Recording read;
    const bool has_all = testing::eventually([&] {
      if (!recover_recording(folder_.file("a.partial"), folder_.file("b"))) return false;
      read = read_recording(folder_.file("b")).value();
      return !read.explorations.empty() && read.explorations[0].channels[0].frames.rows() >= frames;
    });
    if (has_all) return std::move(read.explorations[0]);
    ADD_FAILURE() << "not all frames were saved";
    return {};
  }

  TemporaryFolder folder_;
  std::unique_ptr<GrowingRecording> file_ = GrowingRecording::begin(folder_.file("a")).value();
};

// The exploration that ends later has the same channels.
TEST_F(ExplorationDraftTest, HasTheChannelsOfTheExploration) {
  ExplorationDraft draft(*file_);
  draft.begin(sensing_body(), {{"object", "ball"}});
  FrameLog log(sensing_body());
  BodyState timed = sensed_state(3, {7, 8}, {});
  timed.readings[0] = Matrix<float>(2, 2, {7, 8, 9, 10});
  timed.times = {{2.25, 2.75}};
  for (const BodyState& state :
       {sensed_state(0.25, {1, 2}, {10, 20, 30}), sensed_state(0.5, {3, 4}, {40}),
        sensed_state(2, {5, 6}, {}), timed}) {
    ASSERT_TRUE(draft.append(state));
    ASSERT_TRUE(log.append(state));
  }
  const Exploration found = recovered(5);
  EXPECT_EQ(found.labels, (std::vector<Label>{{"object", "ball"}}));
  EXPECT_EQ(found.source, "hand");
  const std::vector<Channel> expected = std::move(log).channels();
  ASSERT_EQ(found.channels.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(found.channels[i].frames, expected[i].frames) << expected[i].name;
    ASSERT_EQ(found.channels[i].times.size(), expected[i].times.size()) << expected[i].name;
    for (std::size_t k = 0; k < expected[i].times.size(); ++k) {
      EXPECT_NEAR(found.channels[i].times[k], expected[i].times[k], 1e-9);
    }
  }
}

// The exploring function reports such readings; the draft continues.
TEST_F(ExplorationDraftTest, LeavesOutReadingsThatDoNotFit) {
  ExplorationDraft draft(*file_);
  draft.begin(sensing_body(), {});
  ASSERT_TRUE(draft.append(sensed_state(0.5, {1, 2}, {10, 20})));
  ASSERT_TRUE(draft.append(sensed_state(0.75, {1, 2, 3}, {})));
  ASSERT_TRUE(draft.append(BodyState()));
  ASSERT_TRUE(draft.append(sensed_state(0.25, {3, 4}, {30}))) << "a clock that runs backwards";
  EXPECT_EQ(recovered(2).channels[0].times, (std::vector<double>{0.5, 0.5}));
}

TEST_F(ExplorationDraftTest, BeginsAgainWithTheNextBody) {
  ExplorationDraft draft(*file_);
  draft.begin(sensing_body(), {});
  ASSERT_TRUE(draft.append(sensed_state(0.5, {1, 2}, {10, 20})));
  BodyDescription probe;
  probe.sensors = {{"potentiometer", "", {}, {}, 0.0, true}};
  draft.begin(probe, {});
  BodyState pressed;
  pressed.readings = {Matrix<float>(1, 1, 5.0F)};
  ASSERT_TRUE(draft.append(pressed));
  EXPECT_EQ(recovered(1).channels[0].name, "potentiometer") << "the first draft is dropped";
}

}  // namespace
}  // namespace somato
