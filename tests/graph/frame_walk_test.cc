#include "graph/frame_walk.h"

#include <gtest/gtest.h>

#include "support/no_malloc.h"
#include "support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::channels;
using testing::hand_recording;
using testing::module;
using testing::output_of;
using testing::trained;

// P06's chain of T-MPSOMs, up to what is felt in a frame.
std::string t_mpsom_chain() {
  std::string text = channels();
  for (const std::string name : {"height", "wrist", "joints"}) {
    text += module(name + "_code", "one_hot", "input = \"" + name + "\"\nlow = 0\nhigh = 1");
  }
  const auto map = [](const std::string& name, const std::string& inputs,
                      const std::string& shape) {
    return module(name, "t_mpsom", "inputs = [" + inputs + "]\nshape = " + shape);
  };
  return text + map("hand", "\"height_code\", \"wrist_code\"", "[5, 5]") +
         map("posture", "\"hand\", \"joints_code\"", "[6, 8]") +
         map("felt", "\"posture\", \"touch\"", "[12, 3]") +
         "[[phase]]\nlearn = [\"hand\", \"posture\", \"felt\"]\ndraws = 40\nof = \"frames\"\n";
}

class FrameWalkTest : public ::testing::Test {
 protected:
  FrameWalkTest()
      : recording_(hand_recording(6, 3)),
        system_(trained(build(t_mpsom_chain(), recording_), recording_, 6, 3)) {
    walked_.reserve(6);
    sources_.reserve(4);
    for (const char* name : {"height_code", "wrist_code", "joints_code", "hand", "posture"}) {
      walked_.push_back(system_.find(name).value());
    }
    walked_.push_back(felt_ = system_.find("felt").value());
    for (const char* name : {"height", "wrist", "joints", "touch"}) {
      sources_.emplace_back(system_.find(name).value(), Sequence{});
    }
  }

  // Goes to the start of an exploration.
  void start(FrameWalk& walk, std::size_t exploration) {
    for (auto& [module, sequence] : sources_) {
      sequence = output_of(system_, recording_, system_.modules()[module].name, exploration);
    }
    const auto sequence_of = [&](std::size_t module) -> const Sequence* {
      for (const auto& [source, sequence] : sources_) {
        if (source == module) return &sequence;
      }
      return nullptr;
    };
    ASSERT_TRUE(walk.start(sequence_of));
  }

  Recording recording_;
  System system_;
  std::vector<std::size_t> walked_;
  std::size_t felt_ = 0;
  std::vector<std::pair<std::size_t, Sequence>> sources_;
};

TEST_F(FrameWalkTest, GivesWhatWholeExplorationsGive) {
  FrameWalk walk(system_, walked_);
  for (std::size_t exploration = 0; exploration < 6; ++exploration) {
    start(walk, exploration);
    const Sequence felt = output_of(system_, recording_, "felt", exploration);
    ASSERT_EQ(walk.frames(), felt.values.count());
    for (std::size_t frame = 0; frame < walk.frames(); ++frame) {
      ASSERT_TRUE(walk.step());
      const auto values = walk.output(felt_).values();
      const auto expected = felt.values[frame].values;
      EXPECT_TRUE(std::equal(values.begin(), values.end(), expected.begin(), expected.end()));
    }
  }
}

TEST_F(FrameWalkTest, AllocatesNothingOnceItHasItsMemory) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "a sanitizer brings its own operator new";
  FrameWalk walk(system_, walked_);
  std::size_t counted = 0;
  for (std::size_t exploration = 0; exploration < 6; ++exploration) {
    start(walk, exploration);
    for (std::size_t frame = 0; frame < walk.frames(); ++frame) {
      const testing::AllocationCounter counter;
      ASSERT_TRUE(walk.step());
      if (frame < 2) continue;
      EXPECT_EQ(counter.count(), 0U);
      ++counted;
    }
  }
  EXPECT_GT(counted, 4U);
}

}  // namespace
}  // namespace somato
