#include "somato/graph/live_system.h"

#include <gtest/gtest.h>

#include "base/support/no_malloc.h"
#include "somato/graph/system_model.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::channels;
using testing::hand_recording;
using testing::module;

constexpr std::size_t kLearned = 3;
constexpr std::size_t kExplorations = 6;

std::string one_hot(const std::string& name) {
  return module(name + "_code", "one_hot",
                "input = '" + name + "'\nlow = 0\nhigh = 1\nelements = 4");
}

// The frames are sparse, with elements that never occur while learning.
std::string crossed() {
  return channels() + one_hot("height") + one_hot("wrist") + one_hot("joints") +
         module("crossed", "tensor_product",
                "inputs = ['height_code', 'wrist_code', 'joints_code', 'touch']");
}

std::string map_of(const std::string& input, const std::string& settings = "") {
  return module("map", "som",
                "input = '" + input + "'\nrows = 3\ncolumns = 4\niterations = 60\n" + settings);
}

std::string summed(const std::string& norm, const std::string& map_settings = "") {
  return crossed() + module("memory", "accumulate", "input = 'crossed'") +
         module("unit", "normalization", "input = 'memory'\nnorm = '" + norm + "'") +
         map_of("unit", map_settings);
}

Recording cut(Recording recording, std::size_t frames) {
  for (Exploration& exploration : recording.explorations) {
    for (Channel& channel : exploration.channels) {
      const Matrix<float> whole = channel.frames;
      const std::size_t kept = std::min(frames, whole.rows());
      channel.frames = Matrix<float>(kept, whole.columns());
      for (std::size_t row = 0; row < kept; ++row) {
        std::copy(whole.row(row).begin(), whole.row(row).end(), channel.frames.row(row).begin());
      }
    }
  }
  return recording;
}

std::vector<std::span<const float>> frame_of(const LiveSystem& live, const Recording& recording,
                                             std::size_t exploration, std::size_t frame) {
  std::vector<std::span<const float>> values;
  values.reserve(live.channels().size());
  for (const std::string& channel : live.channels()) {
    values.push_back(testing::frames_of(recording, channel, exploration).row(frame));
  }
  return values;
}

// The map's input for the exploration so far, evaluated as a whole.
Signal seen(const System& system, const Recording& so_far, std::size_t map,
            std::size_t exploration) {
  const std::string& input = system.modules()[system.modules()[map].inputs.front()].name;
  const Sequence values = testing::output_of(system, so_far, input, exploration);
  std::vector<float> last(values.values.size());
  write_dense(values.values[values.values.count() - 1], last);
  return Signal::dense(std::move(last));
}

void expect_as_evaluated(const std::string& text, std::uint64_t seed) {
  SCOPED_TRACE(text);
  const Recording recording = hand_recording(kExplorations, seed);
  const System system =
      testing::trained(testing::build(text, recording), recording, kLearned, seed);
  const std::size_t map = *system.find("map");
  auto live = LiveSystem::build(system, map).value();
  SomWorkspace workspace;
  for (std::size_t exploration = 0; exploration < kExplorations; ++exploration) {
    live.start();
    const std::size_t frames = testing::frames_of(recording, "joints", exploration).rows();
    for (std::size_t frame = 0; frame < frames; ++frame) {
      ASSERT_TRUE(live.step(frame_of(live, recording, exploration, frame)));
      const Signal input = seen(system, cut(recording, frame + 1), map, exploration);
      const Som& som = *som_of(system, map);
      const std::vector<std::size_t> some{0, som.neurons() / 2, som.neurons() - 1};
      EXPECT_EQ(live.winner().value(), som.winner(input.view(), workspace));
      EXPECT_EQ(live.winner_among(some).value(), som.winner_among(some, input.view(), workspace));
    }
  }
}

TEST(LiveSystem, AnswersForSumsAsIfEachFrameWereTheLast) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const char* norm : {"l2", "l1", "none", "maximum"})
      expect_as_evaluated(summed(norm), seed);
    expect_as_evaluated(summed("l2", "similarity = 'dot_product'"), seed);
    expect_as_evaluated(summed("none", "similarity = 'euclidean'\nnormalize_input = true"), seed);
    expect_as_evaluated(summed("l2", "initial_weights = 'uniform'"), seed);
    expect_as_evaluated(crossed() + module("memory", "accumulate", "input = 'crossed'") +
                            map_of("memory", "softmax_exponent = 2"),
                        seed);
  }
}

TEST(LiveSystem, AnswersForOtherModulesAsIfEachFrameWereTheLast) {
  for (const std::string& text :
       {channels() + module("sum", "accumulate", "input = 'touch'") + map_of("sum"),
        channels() + module("middle", "mean", "input = 'joints'") + map_of("middle"),
        channels() + module("end", "last", "input = 'joints'") + map_of("end"),
        channels() + module("begin", "first", "input = 'joints'") + map_of("begin"),
        crossed() + module("leaky", "leaky_accumulate", "input = 'crossed'\nleak = 0.25") +
            map_of("leaky"),
        channels() + module("zero", "tare", "input = 'touch'\nframes = 2") +
            module("quick", "high_pass", "input = 'zero'\ntime_constant = 0.2\nrate = 10") +
            module("sum", "accumulate", "input = 'quick'") + map_of("sum"),
        channels() + one_hot("height") + one_hot("wrist") +
            module("both", "concatenation", "inputs = ['height_code', 'wrist_code']") +
            module("mixed", "concatenation", "inputs = ['both', 'touch']") +
            module("sum", "accumulate", "input = 'mixed'") +
            module("even", "standardization", "input = 'sum'\nconstant_columns = 'zero'") +
            map_of("even"),
        channels() + one_hot("height") +
            module("bound", "t_mpsom",
                   "inputs = ['height_code', 'touch']\nshape = [3, 4]\niterations = 40") +
            module("sum", "accumulate", "input = 'bound'") +
            module("unit", "normalization", "input = 'sum'") + map_of("unit")}) {
    expect_as_evaluated(text, 5);
  }
}

// Allocations of steps with the frames of all explorations, after steps with `warm_up` of these.
std::size_t allocations_of_steps(const std::string& text, std::size_t warm_up) {
  const Recording recording = hand_recording(kExplorations, 7);
  const System system = testing::trained(testing::build(text, recording), recording, kLearned);
  auto live = LiveSystem::build(system, *system.find("map")).value();
  std::vector<std::vector<std::span<const float>>> frames;
  frames.reserve(kExplorations);
  for (std::size_t exploration = 0; exploration < kExplorations; ++exploration) {
    frames.push_back(frame_of(live, recording, exploration, 1));
  }
  const auto go = [&](std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_TRUE(live.step(frames[i]));
      EXPECT_TRUE(live.winner());
    }
  };
  go(warm_up);
  const testing::AllocationCounter counter;
  go(frames.size());
  return counter.count();
}

TEST(LiveSystem, AllocatesNothingForSparseFramesOnceItsMemoryHasGrown) {
  EXPECT_EQ(allocations_of_steps(summed("l2"), kExplorations), 0U);
}

TEST(LiveSystem, AllocatesNothingForDenseFramesAfterTheFirst) {
  EXPECT_EQ(allocations_of_steps(
                channels() + one_hot("height") +
                    module("bound", "t_mpsom",
                           "inputs = ['height_code', 'touch']\nshape = [3, 4]\niterations = 40") +
                    module("sum", "accumulate", "input = 'bound'") +
                    module("unit", "normalization", "input = 'sum'") + map_of("unit"),
                1),
            0U);
  EXPECT_EQ(allocations_of_steps(
                channels() + one_hot("height") + one_hot("wrist") +
                    module("both", "concatenation", "inputs = ['height_code', 'wrist_code']") +
                    module("mixed", "concatenation", "inputs = ['both', 'touch']") +
                    module("sum", "accumulate", "input = 'mixed'") + map_of("sum"),
                1),
            0U);
  EXPECT_EQ(allocations_of_steps(
                channels() + module("zero", "tare", "input = 'touch'\nframes = 2") +
                    module("quick", "high_pass", "input = 'zero'\ntime_constant = 0.2\nrate = 10") +
                    module("sum", "accumulate", "input = 'quick'") + map_of("sum"),
                1),
            0U);
}

// A frame that was refused must not be half of the next answer.
TEST(LiveSystem, NamesTheModuleThatRefusesAFrame) {
  const Recording recording = hand_recording(kExplorations, 2);
  const System system =
      testing::trained(testing::build(summed("l2"), recording), recording, kLearned);
  auto live = LiveSystem::build(system, *system.find("map")).value();
  auto frame = frame_of(live, recording, 0, 0);
  const std::vector<float> outside{2.0F};
  const auto joints = std::find(live.channels().begin(), live.channels().end(), "height");
  frame[static_cast<std::size_t>(joints - live.channels().begin())] = outside;
  const auto refused = live.step(frame);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_NE(to_string(refused.error()).find("height_code"), std::string::npos);
}

TEST(LiveSystem, RunsModulesThatNeedWholeExplorationsAgainOnWhatHasCome) {
  const Recording recording = hand_recording(kExplorations, 2);
  const std::string text = channels({"sound"}) +
                           module("spectrum", "spectrum", "input = 'sound'\nsegment_length = 4") +
                           map_of("spectrum");
  const System system = testing::trained(testing::build(text, recording), recording, kLearned);
  const std::size_t map = *system.find("map");
  auto live = LiveSystem::build(system, map).value();
  SomWorkspace workspace;
  live.start(100.0);
  for (std::size_t frame = 0; frame < 16; ++frame) {
    ASSERT_TRUE(live.step(frame_of(live, recording, 5, frame)));
    const auto winner = live.winner();
    const auto whole = testing::try_output(system, cut(recording, frame + 1), "spectrum", 5);
    ASSERT_EQ(winner.has_value(), whole.has_value()) << frame;
    if (!winner) continue;
    EXPECT_EQ(*winner, som_of(system, map)->winner(whole->values[0], workspace));
  }
}

TEST(LiveSystem, RefusesChannelsThatAreNotTakenTogether) {
  const Recording recording = hand_recording(kExplorations, 2);
  const std::string text = channels() + module("sound", "channel", "channel = 'sound'") +
                           module("a", "accumulate", "input = 'sound'") +
                           module("b", "accumulate", "input = 'joints'") +
                           module("both", "concatenation", "inputs = ['a', 'b']") + map_of("both");
  const System system = testing::trained(testing::build(text, recording), recording, kLearned);
  const auto live = LiveSystem::build(system, *system.find("map"));
  ASSERT_FALSE(live);
  EXPECT_EQ(live.error().kind, ErrorKind::kUsage);
  EXPECT_NE(to_string(live.error()).find("not recorded together"), std::string::npos);
}

TEST(LiveSystem, RefusesToAnswerBeforeTheFirstFrameAndFramesOfAnotherSize) {
  const Recording recording = hand_recording(kExplorations, 2);
  const System system =
      testing::trained(testing::build(summed("l2"), recording), recording, kLearned);
  auto live = LiveSystem::build(system, *system.find("map")).value();
  EXPECT_THROW((void)live.winner(), InvalidArgument);
  auto frame = frame_of(live, recording, 0, 0);
  EXPECT_THROW((void)live.step(std::span(frame).first(2)), InvalidArgument);
  frame[0] = frame[2];
  EXPECT_THROW((void)live.step(frame), InvalidArgument);
  EXPECT_THROW((void)LiveSystem::build(system, *system.find("unit")), InvalidArgument);
}

}  // namespace
}  // namespace somato
