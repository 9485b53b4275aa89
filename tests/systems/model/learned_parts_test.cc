#include "systems/model/learned_parts.h"

#include <gtest/gtest.h>

#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::channels;
using testing::hand_recording;
using testing::module;
using testing::trained;

const std::string kLearningText =
    channels({"joints", "height"}) + module("closed", "last", "input = 'joints'") +
    module("standard", "standardization", "input = 'closed'") +
    module("code", "one_hot", "input = 'height'\nelements = 3") +
    module("given", "one_hot", "input = 'joints'\nelements = 2\nlow = -1\nhigh = [2, 3, 4.5]") +
    module("binding", "t_mpsom", "inputs = ['code', 'given']\nshape = [2, 3]\niterations = 20");

class LearnedParts : public ::testing::Test {
 protected:
  Recording recording_ = hand_recording(5, 3);
  System system_ = trained(build(kLearningText, recording_), recording_, 5);
  std::size_t number(const std::string& name) const { return *system_.find(name); }
};

TEST_F(LearnedParts, AStandardizationIsThatOfWhatCameIn) {
  const auto found = standardization_of(system_, number("standard"));
  ASSERT_TRUE(found);
  for (std::size_t joint = 0; joint < 3; ++joint) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
      const auto& frames = testing::frames_of(recording_, "joints", i);
      sum += double{frames(frames.rows() - 1, joint)};
    }
    EXPECT_NEAR(found->means[joint], sum / 5, 1e-12);
  }
  EXPECT_FALSE(standardization_of(system_, number("code")));
}

TEST_F(LearnedParts, RangesAreThoseLearnedOrGiven) {
  double low = 1.0;
  double high = 0.0;
  for (std::size_t i = 0; i < 5; ++i) {
    for (const float value : testing::frames_of(recording_, "height", i).values()) {
      low = std::min(low, double{value});
      high = std::max(high, double{value});
    }
  }
  using Ranges = std::vector<std::pair<double, double>>;
  EXPECT_EQ(one_hot_ranges_of(system_, number("code")), (Ranges{{low, high}}));
  EXPECT_EQ(one_hot_ranges_of(system_, number("given")), (Ranges{{-1, 2}, {-1, 3}, {-1, 4.5}}));
  EXPECT_FALSE(one_hot_ranges_of(system_, number("binding")));
}

TEST_F(LearnedParts, ATMpsomAnswersAsItsModuleDoes) {
  const auto map = t_mpsom_of(system_, number("binding"));
  ASSERT_TRUE(map);
  const Sequence code = testing::output_of(system_, recording_, "code", 0);
  const Sequence given = testing::output_of(system_, recording_, "given", 0);
  TMpsom::Workspace workspace(*map);
  std::vector<float> activity(6);
  const std::vector<SignalView> inputs{code.values[0], given.values[0]};
  map->activation(inputs, workspace, activity);
  const Matrix<float> expected =
      testing::dense(testing::output_of(system_, recording_, "binding", 0));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(activity[i], expected(0, i));
  EXPECT_FALSE(t_mpsom_of(system_, number("standard")));
}

}  // namespace
}  // namespace somato
